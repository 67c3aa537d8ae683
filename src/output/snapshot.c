/* snapshot.c -- particles at chosen times as plain CSV, with an index of times. */
#include "output/snapshot.h"

#include "base/status.h"
#include "output/aside.h"
#include "output/looks-file.h"
#include "output/series.h"
#include "ranks/ranks.h"

#include <stdlib.h>
#include <unistd.h>

struct snapshot {
    char dir[ASIDE_PATH];
    int written, safe; /* safe: on the disk */
    double step, middle; /* of points on surfaces, where bodies are cut [m] */
    struct series *index;
};

static int start(struct snapshot *s, const char *dir, bool again)
{
    char path[ASIDE_PATH];

    TRY(aside_join(path, dir, "snapshots"));
    TRY(aside_directory(path));
    TRY(aside_join(s->dir, dir, "."));
    TRY(aside_join(path, dir, "snapshots.csv"));
    if (again)
        return series_open_again(&s->index, path, 2);
    return series_open(&s->index, path, 2, (const char *[]){ "t", "file" },
                       (const char *[]){ "s", "" });
}

int snapshot_open(struct snapshot **out, const char *dir, bool again)
{
    struct snapshot *s = status_alloc(1, sizeof *s);
    int code;

    *out = s;
    if (!s)
        return STATUS_FAILED;
    code = start(s, dir, again);
    if (code != STATUS_DONE)
        snapshot_close(out);
    return code;
}

void snapshot_fineness(struct snapshot *s, double step, double middle)
{
    s->middle = middle;
    s->step = step;
}

/* END: "" of particles, "-bodies", "-surface", "-cut". */
static int file_of(const struct snapshot *s, int number, const char *end, char name[48], char *path)
{
    snprintf(name, 48, "snapshots/%04d%s.csv", number, end);
    return aside_join(path, s->dir, name);
}

/* A checkpoint promises the files that it counts. */
static int make_safe(struct snapshot *s)
{
    static const char *const end[] = { "", "-bodies", "-surface", "-cut" };
    char name[48], path[ASIDE_PATH];

    for (; s->safe < s->written; s->safe++) {
        for (int i = 0; i < 4; i++) {
            TRY(file_of(s, s->safe, end[i], name, path));
            if (i == 0 || access(path, F_OK) == 0)
                TRY(aside_sync(path));
        }
    }
    TRY(aside_join(path, s->dir, "snapshots"));
    return aside_sync(path);
}

int snapshot_keep(struct snapshot *s, struct archive *a)
{
    if (!s)
        return STATUS_DONE;
    if (!archive_fills(a))
        TRY(make_safe(s));
    TRY(archive_integer(a, "snapshots", &s->written));
    return series_keep(s->index, a, "snapshots.csv");
}

/* The particle i of those that are here. */
static void row(FILE *to, const struct cloud_frame *c, int i)
{
    const double *x = c->x + (size_t)c->dim * (size_t)i, *u = c->u + (size_t)c->dim * (size_t)i;

    for (int d = 0; d < c->dim; d++)
        fprintf(to, "%.10g,", x[d]);
    for (int d = 0; d < c->dim; d++)
        fprintf(to, "%.8g,", u[d]);
    fprintf(to, "%.10g,%.8g,%d,%d\n", c->rho[i], c->p[i], c->dye[c->from + i], c->kind[c->from + i]);
}

/* Files of a moment that have a line for each particle. */
struct lines {
    struct aside cloud, surface;
};

static void add_lines(void *lines, const struct cloud_frame *part)
{
    const struct lines *l = lines;

    for (int i = 0; i < part->here; i++)
        row(l->cloud.to, part, i);
    if (l->surface.to)
        looks_file_add_points(l->surface.to, part);
}

static int open_cloud(struct aside *a, const char *path, const struct cloud_frame *c)
{
    TRY(aside_open(a, path));
    fprintf(a->to, "# t = %.12g s\n# units: %s,kg/m^3,Pa,,\n", c->t,
            c->dim == 2 ? "m,m,m/s,m/s" : "m,m,m,m/s,m/s,m/s");
    fputs(c->dim == 2 ? "x,y,ux,uy,rho,p,dye,kind\n" : "x,y,z,ux,uy,uz,rho,p,dye,kind\n", a->to);
    return STATUS_DONE;
}

static bool has_surface(const struct snapshot *s, const struct cloud_frame *c)
{
    return c->looks && c->dim == 3 && s->step > 0;
}

/* What is there without a particle. */
static int write_looks(const struct snapshot *s, const struct cloud_frame *c)
{
    char name[48], path[ASIDE_PATH];

    if (!c->looks)
        return STATUS_DONE;
    TRY(file_of(s, s->written, "-bodies", name, path));
    TRY(looks_file_write(path, c->dim, c->t, c->looks));
    if (!has_surface(s, c))
        return STATUS_DONE;
    TRY(file_of(s, s->written, "-cut", name, path));
    return looks_file_write_cut(path, c->t, s->middle, c->looks);
}

static int open_lines(const struct snapshot *s, const struct cloud_frame *c, struct lines *l)
{
    char name[48], path[ASIDE_PATH];

    TRY(file_of(s, s->written, "", name, path));
    TRY(open_cloud(&l->cloud, path, c));
    if (!has_surface(s, c))
        return STATUS_DONE;
    TRY(file_of(s, s->written, "-surface", name, path));
    return looks_file_open_points(&l->surface, path, s->step, c);
}

static int close_lines(int status, struct lines *l)
{
    struct aside *file[] = { &l->cloud, &l->surface };

    for (int i = 0; i < 2; i++) {
        if (!file[i]->to)
            continue;
        if (status == STATUS_DONE)
            status = aside_close(file[i]);
        else
            aside_drop(file[i]);
    }
    return status;
}

static int note(struct snapshot *s, const struct cloud_frame *c)
{
    char name[48], path[ASIDE_PATH];

    TRY(file_of(s, s->written, "", name, path));
    s->written++;
    TRY(series_text_row(s->index, &c->t, (const char *[]){ NULL, name }));
    return series_flush(s->index);
}

int snapshot_write(struct snapshot *s, const struct cloud_frame *frame)
{
    struct lines lines = { .cloud.to = NULL };
    int status = s ? open_lines(s, frame, &lines) : STATUS_DONE;

    if (frame->shared)
        status = ranks_agree(status);
    if (status == STATUS_DONE)
        status = cloud_show(frame, add_lines, &lines);
    status = close_lines(status, &lines);
    if (!s || status != STATUS_DONE)
        return status;
    TRY(write_looks(s, frame));
    return note(s, frame);
}

int snapshot_close(struct snapshot **snapshot)
{
    int code;

    if (!*snapshot)
        return STATUS_DONE;
    code = series_close(&(*snapshot)->index);
    free(*snapshot);
    *snapshot = NULL;
    return code;
}
