/* outputs.c -- tables and particle files of a run. */
#include "run/outputs.h"

#include "base/status.h"
#include "measure/crowd.h"
#include "measure/front.h"
#include "measure/probe.h"
#include "output/aside.h"
#include "output/fields.h"
#include "output/series.h"
#include "output/snapshot.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

enum { COLUMNS = 4096, NAME = 80 };

static const char axes[] = "xyz";

/* In 2D everything that has mass or force is per metre of depth. */
#if DIM == 2
#define UNIT(whole) whole "/m"
#else
#define UNIT(whole) whole
#endif

struct outputs {
    int lock; /* the directory, held against other runs; -1: not held */
    struct series *book, *front, *forces, *beam, *probes, *steps;
    struct fields *fields;
    struct snapshot *snapshot;
    struct crowd *crowd; /* NULL: no fluid */
    struct plan_sheet first, last;
    bool begun;
    double defect_max;
    double *rho, *p, *x, *u; /* of everybody, for particle files */
    unsigned char *kind;
};

/* Column names and units on their way to a file. */
struct head {
    int n; /* columns asked for; open_series() refuses more than there is room for */
    char name[COLUMNS][NAME], unit[COLUMNS][16];
};

static void column(struct head *h, const char *unit, const char *format, ...)
    __attribute__((format(printf, 3, 4)));


static void column(struct head *h, const char *unit, const char *format, ...)
{
    va_list args;

    if (h->n++ >= COLUMNS)
        return;
    va_start(args, format);
    vsnprintf(h->name[h->n - 1], NAME, format, args);
    va_end(args);
    snprintf(h->unit[h->n - 1], sizeof h->unit[0], "%s", unit);
}

static int open_series(struct series **out, const char *dir, const char *file, struct head *h)
{
    const char *name[COLUMNS], *unit[COLUMNS];
    char path[ASIDE_PATH];

    if (h->n > COLUMNS)
        return status_fail(STATUS_BAD_SCENE, "%s would have %d columns, more than %d: use fewer "
                           "walls, beams or probes", file, h->n, COLUMNS);
    for (int i = 0; i < h->n; i++) {
        name[i] = h->name[i];
        unit[i] = h->unit[i];
    }
    TRY(aside_join(path, dir, file));
    return series_open(out, path, h->n, name, unit);
}

/* A file of an earlier run would be taken for one of this run, which has none (yet). */
static int no_file(const char *dir, const char *file)
{
    char path[ASIDE_PATH];

    TRY(aside_join(path, dir, file));
    remove(path);
    return STATUS_DONE;
}

static void head_start(struct head *h)
{
    h->n = 0;
    column(h, "s", "t");
}

static int open_book(struct outputs *o, struct plan *plan, const char *dir, struct head *h)
{
    static const char *const parts[] = { "kinetic", "potential", "internal", "elastic" };
    char work[PLAN_WORKS][80];
    const int works = plan_work_names(plan, work);

    head_start(h);
    for (int i = 0; i < 4; i++)
        column(h, UNIT("J"), "%s", parts[i]);
    for (int i = 0; i < works; i++)
        column(h, UNIT("J"), "%s", work[i]);
    column(h, UNIT("J"), "pressure_defect");
    column(h, UNIT("J"), "total");
    column(h, UNIT("J"), "defect");
    column(h, UNIT("kg"), "mass");
    for (int d = 0; d < DIM; d++)
        column(h, UNIT("kg m/s"), "momentum_%c", axes[d]);
    return open_series(&o->book, dir, "book.csv", h);
}

static bool solid(const struct object *o)
{
    return o->kind != KIND_FLUID;
}

static int open_forces(struct outputs *o, struct plan *plan, const char *dir, struct head *h)
{
    const struct particles *all = plan_particles(plan);

    head_start(h);
    for (int i = 0; i < all->objects; i++) {
        if (!solid(&all->object[i]))
            continue;
        for (int d = 0; d < DIM; d++)
            column(h, UNIT("N"), "%s.f%c", all->object[i].name, axes[d]);
        for (int d = 0; d < DIM; d++)
            column(h, UNIT("N s"), "%s.i%c", all->object[i].name, axes[d]);
    }
    return h->n > 1 ? open_series(&o->forces, dir, "forces.csv", h) : no_file(dir, "forces.csv");
}

static int open_beam(struct outputs *o, struct plan *plan, const char *dir, struct head *h)
{
    head_start(h);
    for (int i = 0; i < plan_bodies(plan); i++) {
        const char *name = plan_body_name(plan, i);
        column(h, "m", "%s.tip_x", name);
        column(h, "m", "%s.tip_y", name);
        column(h, "m", "%s.mid_x", name);
        column(h, "m", "%s.mid_y", name);
        column(h, "rad", "%s.tip_angle", name);
        column(h, UNIT("N"), "%s.root_force", name);
        column(h, UNIT("N m"), "%s.root_moment", name);
    }
    return h->n > 1 ? open_series(&o->beam, dir, "beam.csv", h) : no_file(dir, "beam.csv");
}

static int open_probes(struct outputs *o, struct plan *plan, const char *dir, struct head *h)
{
    head_start(h);
    for (int i = 0; i < plan_probes(plan); i++) {
        const char *name;
        const struct settings_probe *p = plan_probe(plan, i, &name);
        column(h, p->what[0] == 'p' ? "Pa" : p->what[0] == 'h' ? "m" : "m/s", "%s", name);
    }
    return h->n > 1 ? open_series(&o->probes, dir, "probes.csv", h) : no_file(dir, "probes.csv");
}

static int open_front(struct outputs *o, struct plan *plan, const char *dir, struct head *h)
{
    if (particles_count(plan_particles(plan), KIND_FLUID) == 0)
        return no_file(dir, "front.csv");
    TRY(crowd_create(plan_particles(plan), &o->crowd));
    head_start(h);
    column(h, "m", "x");
    column(h, "m", "height");
    return open_series(&o->front, dir, "front.csv", h);
}

static int open_steps(struct outputs *o, const char *dir, struct head *h)
{
    head_start(h);
    column(h, "s", "h");
    column(h, "", "limiter");
    column(h, "", "where");
    column(h, "", "rejected");
    return open_series(&o->steps, dir, "steps.csv", h);
}

static int open_particles(struct outputs *o, struct plan *plan, const char *dir)
{
    const struct particles *all = plan_particles(plan);
    const int n = all->n;

    if (n == 0)
        return STATUS_DONE;
    o->rho = status_alloc(n, sizeof *o->rho);
    o->p = status_alloc(n, sizeof *o->p);
    o->x = status_alloc((size_t)n * DIM, sizeof *o->x);
    o->u = status_alloc((size_t)n * DIM, sizeof *o->u);
    o->kind = status_alloc(n, 1);
    if (!o->rho || !o->p || !o->x || !o->u || !o->kind)
        return STATUS_FAILED;
    for (int k = 0; k < KINDS; k++)
        memset(o->kind + all->from[k], k, particles_count(all, k));
    TRY(fields_open(&o->fields, dir));
    return snapshot_open(&o->snapshot, dir);
}

/* Two runs in one directory would mix their rows.  A file system that knows no
 * locks has none. */
static int lock_directory(struct outputs *o, const char *dir)
{
    TRY(aside_directory(dir));
    o->lock = open(dir, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (o->lock >= 0 && flock(o->lock, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        return status_fail(STATUS_IO, "%s: another run is writing there; wait until it has ended, "
                           "or choose another directory (-o)", dir);
    return STATUS_DONE;
}

static int open_all(struct outputs *o, struct plan *plan, const char *dir, struct head *h)
{
    TRY(lock_directory(o, dir));
    TRY(no_file(dir, "run.json")); /* it is to say how this run ended */
    TRY(open_book(o, plan, dir, h));
    TRY(open_front(o, plan, dir, h));
    TRY(open_forces(o, plan, dir, h));
    TRY(open_beam(o, plan, dir, h));
    TRY(open_probes(o, plan, dir, h));
    TRY(open_steps(o, dir, h));
    return open_particles(o, plan, dir);
}

int outputs_open(struct outputs **out, struct plan *plan, const char *dir)
{
    struct head *h = status_alloc(1, sizeof *h);
    int status;

    *out = status_alloc(1, sizeof **out);
    if (*out)
        (*out)->lock = -1;
    status = *out && h ? open_all(*out, plan, dir, h) : STATUS_FAILED;
    free(h);
    return status;
}

static double defect_of(const struct plan_sheet *first, const struct plan_sheet *s)
{
    double given = s->pressure_defect - first->pressure_defect;

    for (int i = 0; i < s->works; i++)
        given += s->work[i] - first->work[i];
    return s->total - first->total - given;
}

static int row_book(struct outputs *o, struct plan *plan, double t, const double *y)
{
    const struct plan_sheet *s = &o->last;
    double v[COLUMNS];
    int n = 0;

    plan_sheet_make(plan, t, y, &o->last);
    if (!o->begun)
        o->first = o->last;
    o->begun = true;
    o->defect_max = fmax(o->defect_max, fabs(outputs_defect(o)));
    v[n++] = t;
    v[n++] = s->energy.kinetic;
    v[n++] = s->energy.potential;
    v[n++] = s->energy.internal;
    v[n++] = s->energy.elastic;
    for (int i = 0; i < s->works; i++)
        v[n++] = s->work[i];
    v[n++] = s->pressure_defect;
    v[n++] = s->total;
    v[n++] = outputs_defect(o);
    v[n++] = s->mass;
    for (int d = 0; d < DIM; d++)
        v[n++] = s->momentum[d];
    return series_row(o->book, v);
}

static int row_forces(struct outputs *o, struct plan *plan, double t, const double *y)
{
    const struct particles *all = plan_particles(plan);
    double v[COLUMNS];
    int n = 0;

    v[n++] = t;
    for (int i = 0; i < all->objects; i++) {
        if (!solid(&all->object[i]))
            continue;
        for (int d = 0; d < DIM; d++)
            v[n++] = plan_force(plan, i)[d];
        for (int d = 0; d < DIM; d++)
            v[n++] = plan_impulse(plan, y, i)[d];
    }
    return o->forces ? series_row(o->forces, v) : STATUS_DONE;
}

static int row_beam(struct outputs *o, struct plan *plan, double t, const double *y)
{
    double v[COLUMNS];
    int n = 0;

    v[n++] = t;
    for (int i = 0; i < plan_bodies(plan); i++) {
        struct body_view b;
        plan_body_view(plan, i, t, y, &b);
        v[n++] = b.tip[0];
        v[n++] = b.tip[1];
        v[n++] = b.mid[0];
        v[n++] = b.mid[1];
        v[n++] = b.tip_angle;
        v[n++] = b.root_force;
        v[n++] = b.root_moment;
    }
    return o->beam ? series_row(o->beam, v) : STATUS_DONE;
}

static double probe_speed(const struct outputs *o, const struct settings_probe *p)
{
    double u[DIM], u2 = 0;

    probe_velocity(crowd_view(o->crowd), p->at, u);
    for (int d = 0; d < DIM; d++)
        u2 += u[d] * u[d];
    return sqrt(u2);
}

static double probe_value(const struct outputs *o, struct plan *plan, const struct settings_probe *p)
{
    if (p->what[0] == 'h')
        return probe_height(o->crowd, p->at, DIM - 1);
    if (p->what[0] == 'v')
        return probe_speed(o, p);
    plan_pressures(plan, particles_count(plan_particles(plan), KIND_FLUID),
                   crowd_view(o->crowd)->rho[KIND_FLUID], o->p);
    return probe_pressure(crowd_view(o->crowd), o->p, p->at);
}

static int row_water(struct outputs *o, struct plan *plan, double t, const double *y)
{
    double v[COLUMNS];
    struct front front;
    struct view view;
    int n = 0;

    if (!o->crowd)
        return STATUS_DONE;
    plan_view(plan, t, y, &view);
    crowd_update(o->crowd, &view);
    v[n++] = t;
    front_find(o->crowd, &front);
    v[n++] = front.x;
    v[n++] = front.height;
    TRY(series_row(o->front, v));
    n = 1;
    for (int i = 0; i < plan_probes(plan); i++) {
        const char *name;
        const struct settings_probe *p = plan_probe(plan, i, &name);
        v[n++] = probe_value(o, plan, p);
    }
    return o->probes ? series_row(o->probes, v) : STATUS_DONE;
}

int outputs_rows(struct outputs *o, struct plan *plan, double t, const double *y)
{
    TRY(row_book(o, plan, t, y));
    TRY(plan_observe(plan, t, y));
    TRY(row_forces(o, plan, t, y));
    TRY(row_beam(o, plan, t, y));
    return row_water(o, plan, t, y);
}

int outputs_step(struct outputs *o, const struct method_step *step)
{
    static const char *const limiters[] = { "error", "stability", "output" };
    const double v[] = { step->t, step->h, 0, 0, (double)step->rejected };
    const char *text[] = { NULL, NULL, limiters[step->limiter], step->where, NULL };

    return series_text_row(o->steps, v, text);
}

/* Everybody into one frame, creation order. */
static void frame_of(struct outputs *o, struct plan *plan, double t, const double *y,
                     struct cloud_frame *f)
{
    const struct particles *all = plan_particles(plan);
    struct view v;

    plan_view(plan, t, y, &v);
    for (int k = 0; k < KINDS; k++) {
        const size_t from = all->from[k], n = particles_count(all, k);
        if (n == 0)
            continue;
        memcpy(o->x + from * DIM, v.x[k], n * DIM * sizeof *o->x);
        memcpy(o->u + from * DIM, v.u[k], n * DIM * sizeof *o->u);
        for (size_t i = 0; i < n; i++)
            o->rho[from + i] = v.rho[k] ? v.rho[k][i] : plan_scales(plan)->rho0;
    }
    plan_pressures(plan, all->n, o->rho, o->p);
    *f = (struct cloud_frame){ .t = t, .n = all->n, .dim = DIM, .x = o->x, .u = o->u,
                               .rho = o->rho, .p = o->p, .dye = all->dye, .kind = o->kind };
}

int outputs_field(struct outputs *o, struct plan *plan, double t, const double *y)
{
    struct cloud_frame f;

    if (!o->fields)
        return STATUS_DONE;
    frame_of(o, plan, t, y, &f);
    return fields_write(o->fields, &f);
}

int outputs_snapshot(struct outputs *o, struct plan *plan, double t, const double *y)
{
    struct cloud_frame f;

    if (!o->snapshot)
        return STATUS_DONE;
    frame_of(o, plan, t, y, &f);
    return snapshot_write(o->snapshot, &f);
}

const struct plan_sheet *outputs_sheet(const struct outputs *o)
{
    return &o->last;
}

double outputs_energy_initial(const struct outputs *o)
{
    return o->first.total;
}

double outputs_defect(const struct outputs *o)
{
    return defect_of(&o->first, &o->last);
}

double outputs_defect_max(const struct outputs *o)
{
    return o->defect_max;
}

/* Largest component of what momentum the book cannot explain [N s]. */
double outputs_momentum_defect(const struct outputs *o)
{
    double worst = 0;

    for (int d = 0; d < DIM; d++)
        worst = fmax(worst, fabs(o->last.momentum[d] - o->first.momentum[d]
                                 - o->last.momentum_given[d] + o->first.momentum_given[d]));
    return worst;
}

static void keep_first(int *first, int status)
{
    if (*first == STATUS_DONE)
        *first = status;
}

int outputs_close(struct outputs **outputs)
{
    struct outputs *o = *outputs;
    int status = STATUS_DONE;

    if (!o)
        return STATUS_DONE;
    keep_first(&status, series_close(&o->book));
    keep_first(&status, series_close(&o->front));
    keep_first(&status, series_close(&o->forces));
    keep_first(&status, series_close(&o->beam));
    keep_first(&status, series_close(&o->probes));
    keep_first(&status, series_close(&o->steps));
    fields_close(&o->fields);
    keep_first(&status, snapshot_close(&o->snapshot));
    crowd_free(&o->crowd);
    free(o->rho);
    free(o->p);
    free(o->x);
    free(o->u);
    free(o->kind);
    if (o->lock >= 0)
        close(o->lock);
    free(o);
    *outputs = NULL;
    return status;
}
