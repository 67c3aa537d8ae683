/* face.c -- the fluid sticks at the faces of solids.
 *
 * With the velocity of their particles the fluid would stick where those are, dx/2 behind
 * the face and more.  So a solid's particle w counts with the velocity that is as far
 * beyond that of the face as the fluid before it stays behind,
 *
 *   v_w = 2 (u_w + b_w) - sum_f c_wf v_f / sum_f c_wf                               (W2)
 *
 * b_w the velocity of a face that slides, c the coefficients of the law itself, F_ab =
 * -c_ab (v_a - v_b).  Adami, Hu, Adams, J. Comput. Phys. 231 (2012) 7057-7075, eq. 22, 23,
 * weigh with W; weighed with c the forces are symmetric in velocities and take out
 *
 *   sum_w [ sum_f c_wf e_f^2 + (sum_f c_wf e_f)^2 / sum_f c_wf ],  e_f = v_f - u_w - b_w
 *
 * so that they never drive the fluid and the implicit solve stays one with a symmetric
 * matrix.  What is added here to the law: -c_wf s_w on f and the opposite on w, with the
 * slip s_w = u_w - v_w.  Checked in tests/physics/face.c. */
#include "plan/face.h"

#include "base/status.h"
#include "scene/scene.h"
#define LANES 2 /* only sizes without lanes are used here */
#include "space/pairs.h"
#include "space/record.h"

#include <stdlib.h>
#include <string.h>

enum { BLOCK = 512, STICKY = KIND_STICKY };

static const int sticky[] = { KIND_WALL, KIND_SKIN };

/* --- memory ------------------------------------------------------------------ */

/* After a rebuild there may be more slots, and more pairs. */
static int fit_slots(struct face *o, const struct list *l)
{
    const size_t slots = (size_t)l->listed + 1;

    if (slots <= o->slots)
        return STATUS_DONE;
    free(o->velocity);
    free(o->slip);
    o->slots = slots + slots / 8;
    o->velocity = plan_lines(o->slots * COUPLE_STRIDE);
    o->slip = plan_lines(o->slots * COUPLE_STRIDE);
    return o->velocity && o->slip ? STATUS_DONE : STATUS_FAILED;
}

static int fit_pairs(struct face *o, const struct list *l)
{
    const size_t want = (size_t)l->rows_before[l->groups] * (size_t)l->lanes;

    if (want <= o->room)
        return STATUS_DONE;
    free(o->job.c);
    o->room = want + want / 4;
    o->job.c = status_alloc(o->room, sizeof *o->job.c);
    return o->job.c ? STATUS_DONE : STATUS_FAILED;
}

static int take_memory(struct plan *p, struct face *o)
{
    const size_t n = (size_t)p->particles->n;

    o->job.diagonal = status_alloc(n, sizeof(double));
    o->job.firm = status_alloc(n, sizeof(double));
    o->law = status_alloc(n * DIM, sizeof(double));
    o->f = status_alloc(n * DIM, sizeof(double));
    o->partial = status_alloc(n / BLOCK + 1, sizeof(double));
    return o->job.diagonal && o->job.firm && o->law && o->f && o->partial ? STATUS_DONE
                                                                          : STATUS_FAILED;
}

void face_free(struct plan *p)
{
    struct face *o = p->face;

    if (!o)
        return;
    double *const memory[] = { o->job.c, o->job.diagonal, o->job.firm, o->velocity, o->slip,
                               o->law, o->f, o->partial };
    for (size_t i = 0; i < sizeof memory / sizeof memory[0]; i++)
        free(memory[i]);
    free(o);
    p->face = NULL;
}

/* --- who takes part ----------------------------------------------------------- */

static const struct object *sliding(const struct plan *p)
{
    for (int i = 0; i < p->particles->objects; i++)
        for (int d = 0; d < DIM; d++)
            if (p->particles->object[i].slide[d] != 0)
                return &p->particles->object[i];
    return NULL;
}

static int check_sliding(const struct scene *scene, const struct object *slides,
                         const struct plan_part *part)
{
    if (slides && slides->kind == KIND_WALL_SLIP)
        return status_fail(STATUS_BAD_SCENE, "%s: wall.%s has a velocity of its surface, but "
                           "slip = true, so that nothing is dragged along; leave one of them out",
                           scene_path(scene), slides->name);
    if (slides && !part)
        return status_fail(STATUS_BAD_SCENE, "%s: wall.%s.surface drags the fluid along by a "
                           "viscosity, of which the scene has none: name effects.laminar-viscosity "
                           "= { mu = ...; }", scene_path(scene), slides->name);
    return STATUS_DONE;
}

/* The viscosity that asks for it, or if a face slides the one that there is. */
static int find_part(struct plan *p, const struct scene *scene, const struct plan_part **part)
{
    const struct object *slides = sliding(p);

    *part = NULL;
    for (int i = 0; i < p->parts; i++) {
        const struct plan_part *one = &p->part[i];
        if (!one->part->faces || !(slides || one->part->faces(one->self)))
            continue;
        if (*part)
            return status_fail(STATUS_BAD_SCENE, "%s: %s and %s both act at the faces of walls, "
                               "but one can; leave one of them out, or set its stick = "
                               "\"particles\" if no face slides", scene_path(scene), (*part)->path,
                               one->path);
        *part = one;
    }
    return check_sliding(scene, slides, *part);
}

int face_make(struct plan *p, const struct scene *scene)
{
    const struct plan_part *part;
    struct face *o;

    TRY(find_part(p, scene, &part));
    if (!part || particles_count(p->particles, KIND_WALL)
                 + particles_count(p->particles, KIND_SKIN) == 0)
        return STATUS_DONE;
    if (!(o = p->face = status_alloc(1, sizeof *o)))
        return STATUS_FAILED;
    o->part = part;
    o->mirrored = part->part->faces(part->self);
    o->acts[KIND_FLUID] = STICKY;
    o->acts[KIND_WALL] = o->acts[KIND_SKIN] = KIND_BIT(KIND_FLUID);
    o->job = (struct couple_job){
        .acts = o->acts, .couple = part->part->couple, .self = part->self,
        .needs = part->part->rows & ~(unsigned)NEED_V, .kernel = p->kernel[part->part->kernel],
    };
    return take_memory(p, o);
}

bool face_among(const struct plan *p, const struct pairs_table *table)
{
    return table == p->table || table == p->forces
           || table == (p->face->part == p->stiff ? p->implicit : p->explicit);
}

/* --- slip and forces ----------------------------------------------------------- */

/* Velocities of everybody as the records have them. */
static void read_velocities(const struct plan_workspace *w, double *to)
{
    const int n = w->list->listed + 1;

#pragma omp parallel for schedule(static) if (n > 4096)
    for (int s = 0; s < n; s++) {
        const double *r = w->record + (size_t)s * RECORD;
        double *v = to + (size_t)s * COUPLE_STRIDE;
        v[0] = r[RECORD_V];
        v[1] = r[RECORD_V + 1];
#if DIM == 3
        v[2] = r[RECORD_VZ];
#endif
    }
}

static const double *slide_of(const struct plan *p, const struct list *l, int slot)
{
    return p->particles->object[p->particles->object_of[l->order[slot]]].slide;
}

/* Slip of solids by the law's forces on them, and their part C_w s_w of o->f.  Who has no
 * fluid near has none. */
static void find_slip(const struct plan *p, const struct couple_job *job, bool walls,
                      const double *law)
{
    const struct face *o = p->face;
    const struct list *l = job->list;

    for (int i = 0; i < 2; i++)
        for (int s = l->start[sticky[i]]; s < l->start[sticky[i] + 1]; s++) {
            const double *b = slide_of(p, l, s), all = job->diagonal[s];
            for (int d = 0; d < DIM; d++) {
                const size_t k = (size_t)s * DIM + (size_t)d;
                double *slip = &o->slip[(size_t)s * COUPLE_STRIDE + (size_t)d];
                *slip = o->mirrored && all > 0 ? law[k] / all : 0;
                *slip -= walls ? (o->mirrored ? 2 : 1) * b[d] : 0;
                o->f[k] = all * *slip;
            }
        }
    for (int i = 0; i < 2; i++)
        for (int s = l->image[sticky[i]]; s < l->image[sticky[i] + 1]; s++)
            memcpy(o->slip + (size_t)s * COUPLE_STRIDE,
                   o->slip + (size_t)l->slot[l->order[s]] * COUPLE_STRIDE, DIM * sizeof(double));
}

/* Forces on the fluid, with the sign turned: the sum of c_wf s_w. */
static void hold(const struct plan *p, const struct couple_job *job)
{
    struct face *o = p->face;
    const struct list *l = job->list;

    memset(o->slip, 0, (size_t)l->start[KIND_FLUID + 1] * COUPLE_STRIDE * sizeof *o->slip);
    memset(o->slip + (size_t)l->listed * COUPLE_STRIDE, 0, COUPLE_STRIDE * sizeof *o->slip);
    p->engine->couple->multiply(job, KIND_BIT(KIND_FLUID), o->slip, o->f);
}

int face_find(struct plan *p, struct plan_workspace *w)
{
    struct face *o = p->face;
    const struct couple_engine *couple = p->engine->couple;

    o->job.list = w->list;
    TRY(fit_slots(o, w->list));
    TRY(fit_pairs(o, w->list));
    couple->assemble(&o->job, w->record);
    read_velocities(w, o->velocity);
    couple->multiply(&o->job, STICKY, o->velocity, o->law);
    find_slip(p, &o->job, true, o->law);
    hold(p, &o->job);
    return STATUS_DONE;
}

void face_push(const struct plan *p, const struct plan_workspace *w, double (*push)[DIM])
{
    for (int s = 0; s < w->list->start[KIND_FLUID + 1]; s++) {
        const int c = w->list->order[s];
        for (int d = 0; d < DIM; d++)
            push[c][d] -= p->face->f[(size_t)s * DIM + (size_t)d] / p->particles->m[c];
    }
}

/* --- books --------------------------------------------------------------------- */

/* v . f of the fluid in slot s, velocities as struct sum_job's look ahead has them;
 * adds the forces. */
static double add_to_fluid(const struct plan *p, struct plan_workspace *w,
                           const double (*push)[DIM], int s)
{
    const struct face *o = p->face;
    const int c = w->list->order[s];
    double power = 0;

    for (int d = 0; d < DIM; d++) {
        double *f = &w->f[(size_t)s * DIM + (size_t)d];
        const double more = -o->f[(size_t)s * DIM + (size_t)d];
        double v = o->velocity[(size_t)s * COUPLE_STRIDE + (size_t)d];
        if (push)
            v += p->later * (*f / p->particles->m[c] + push[c][d]);
        power += v * more;
        *f += more;
    }
    return power;
}

/* The same bits on any number of threads. */
static double add_to_fluids(const struct plan *p, struct plan_workspace *w,
                            const double (*push)[DIM])
{
    const int n = w->list->start[KIND_FLUID + 1], blocks = (n + BLOCK - 1) / BLOCK;
    double sum = 0;

#pragma omp parallel for schedule(static) if (blocks > 8)
    for (int k = 0; k < blocks; k++) {
        const int to = (k + 1) * BLOCK < n ? (k + 1) * BLOCK : n;
        p->face->partial[k] = 0;
        for (int s = k * BLOCK; s < to; s++)
            if (p->face->job.firm[s] > 0)
                p->face->partial[k] += add_to_fluid(p, w, push, s);
    }
    for (int k = 0; k < blocks; k++)
        sum += p->face->partial[k];
    return sum;
}

/* u . f of solids; what pulls at a face that slides is the law's force and this. */
static double add_to_solids(const struct plan *p, struct plan_workspace *w)
{
    const struct list *l = w->list;
    struct face *o = p->face;
    double sum = 0;

    o->power = 0;
    for (int i = 0; i < 2; i++)
        for (int s = l->start[sticky[i]]; s < l->start[sticky[i] + 1]; s++) {
            const double *b = slide_of(p, l, s), *u = o->velocity + (size_t)s * COUPLE_STRIDE;
            for (int d = 0; d < DIM; d++) {
                const size_t k = (size_t)s * DIM + (size_t)d;
                w->f[k] += o->f[k];
                sum += u[d] * o->f[k];
                o->power += b[d] * (o->law[k] + o->f[k]);
            }
        }
    return sum + o->power;
}

void face_add(struct plan *p, struct plan_workspace *w, const double (*push)[DIM])
{
    double power = add_to_fluids(p, w, push);

    power += add_to_solids(p, w);
    w->power[p->face->part->slot] += power;
}

/* --- in a solve ---------------------------------------------------------------- */

/* "All fluid alike" meets twice the law's coefficients with solids at rest. */
int face_ready(struct plan *p, const struct couple_job *law)
{
    for (int s = 0; s < law->list->start[KINDS] && p->face->mirrored; s++)
        law->firm[s] *= 2;
    return fit_slots(p->face, law->list);
}

void face_complete(struct plan *p, const struct couple_job *law, unsigned kinds, bool walls,
                   double *f)
{
    const struct list *l = law->list;
    struct face *o = p->face;
    struct couple_job job = *law;

    job.acts = o->acts;
    find_slip(p, &job, walls, f);
    for (int i = 0; i < 2; i++)
        for (int k = l->start[sticky[i]] * DIM; k < l->start[sticky[i] + 1] * DIM; k++)
            f[k] += o->f[k];
    if (!(kinds & KIND_BIT(KIND_FLUID)))
        return;
    hold(p, &job);
    for (int k = 0; k < l->start[KIND_FLUID + 1] * DIM; k++)
        f[k] -= o->f[k];
}

double face_power(struct plan *p, const struct plan_workspace *w)
{
    const struct list *l = w->list;

    p->face->power = 0;
    for (int i = 0; i < 2; i++)
        for (int s = l->start[sticky[i]]; s < l->start[sticky[i] + 1]; s++) {
            const double *b = slide_of(p, l, s);
            for (int d = 0; d < DIM; d++)
                p->face->power += b[d] * w->f[(size_t)s * DIM + (size_t)d];
        }
    return p->face->power;
}
