/* mps-create.c -- which plans MPS serves, and its memory. */
#include "eval/given.h"
#include "plan/solver.h"
#include "solved/memory.h"
#include "solved/mps-inside.h"

#include "base/status.h"

#include <math.h>
#include <stdlib.h>

const char *mps_serves(const struct plan *p)
{
    if (p->row.x < 0)
        return "there is no fluid";
    if (p->bodies > 0)
        return "its pressure is solved for between the fluid and walls, and does not know how "
               "beams yield; imex3 moves both";
    if (p->row.density[KIND_FLUID] < 0)
        return "it keeps the solved pressure as a density in y, which effects.continuity has and "
               "a summed density does not";
    if (p->passes.filters)
        return "it keeps the solved pressure as a density, which effects.shepard-filter would mix; "
               "leave that effect out";
    if (p->passes.press)
        return "it presses through the particles of walls, and walls = \"contact\" presses "
               "through their faces; set walls = \"own-density\"";
    if (p->in.walls->as.wall->only)
        return "it presses through the particles of walls, and these have no pressure; set walls = "
               "\"own-density\"";
    if (plan_drifts(p))
        return plan_drifts(p);
    if (p->stiff)
        return "its explicit step takes no implicit viscosity; set side = \"explicit\", or give "
               "the fluid mps.nu";
    if (p->in.mps.re > ceil(p->in.kernel.support))
        return "mps.re is larger than walls are thick (kernel.support)";
    return precondition_named(p->in.mps.preconditioner)->lacks;
}

/* The first layer of walls, where fluid touches them: of a frame the one beside the domain. */
static bool is_face(const struct scales *scales, const struct shape *shape, const double *x)
{
    double outside = 0;

    if (!shape_goes_round(shape))
        return shape_depth(shape, x) < 0.75 * scales->dx;
    for (int d = 0; d < DIM; d++)
        outside = fmax(outside, fmax(scales->low[d] - x[d], x[d] - scales->high[d]));
    return outside < 0.75 * scales->dx;
}

static void find_faces(struct mps *s)
{
    const struct plan *p = s->moment->plan;

    for (int w = 0; w < p->walls; w++) {
        const struct object *o = &p->particles->object[p->wall[w].object];
        for (int id = o->from; id < o->from + o->n; id++)
            s->face[id] = is_face(&p->scales, &p->in.wall[w].set.shape, p->particles->x0[id]);
    }
}

static const double more = 0.1, margin = 0.4; /* of the list, beyond radii and beside that [spacings] */

/* The list; of near.h what is there for pairs, of poisson.h and of the preconditioner the same for
 * those of fluid; of all, what is there for particles; the arrays of struct mps. */
double mps_memory(const struct plan *p)
{
    const struct settings_mps *key = &p->in.mps;
    const double reach = fmax(key->re, fmax(key->re_gradient, key->re_laplacian)) + more;
    const double n = p->particles->n;
    const struct precondition *how = precondition_named(key->preconditioner);
    const double near = 4 + 16 * DIM + 8, poisson = 11 * 8 + 5 + how->row,
                 arrays = 7 * 8 + 2 + 8 * DIM * (3 + MPS_WORKS);

    return memory_list(p, reach + margin) + 4 * memory_pairs(p, reach, true)
         + (4 + 8 + how->entry) * memory_pairs(p, reach, false) + (near + poisson + arrays) * n;
}

/* All kinds that there are own their pairs with all others. */
static int make_list(struct mps *s)
{
    const struct plan *p = s->moment->plan;
    struct list_def def = p->list_def;
    unsigned all = 0;

    for (int k = 0; k < KINDS; k++)
        all |= particles_count(p->particles, (enum kind)k) > 0 ? KIND_BIT(k) : 0;
    for (int k = 0; k < KINDS; k++)
        def.acts[k] = all & KIND_BIT(k) ? all : 0;
    s->reach = fmax(s->density.re, fmax(s->gradient.re, s->laplacian.re)) + more * p->scales.dx;
    def.support = s->reach;
    def.skin = margin * p->scales.dx;
    return p->engine->sum->list->create(&s->list, &def);
}

static int take_memory(struct mps *s)
{
    const struct particles *all = s->moment->plan->particles;
    const size_t n = (size_t)all->n + 1;
    double **number[] = { &s->number, &s->rate, &s->before, &s->rate_before, &s->source, &s->p,
                          &s->lowest };

    for (size_t i = 0; i < sizeof number / sizeof number[0]; i++)
        if (!(*number[i] = status_alloc(n, sizeof(double))))
            return STATUS_FAILED;
    s->face = status_alloc(n, sizeof *s->face);
    s->role = status_alloc(n, sizeof *s->role);
    s->du = status_alloc(n, sizeof *s->du);
    s->was = status_alloc(n, sizeof *s->was);
    s->gave.push = status_alloc(n, sizeof *s->gave.push);
    for (int k = 0; k < MPS_WORKS; k++)
        if (!(s->gave.kick[k] = status_alloc(n, sizeof *s->gave.kick[k])))
            return STATUS_FAILED;
    if (!s->face || !s->role || !s->du || !s->was || !s->gave.push)
        return STATUS_FAILED;
    TRY(given_make(s->moment));
    TRY(poisson_create(all->n, s->key->iterations, precondition_named(s->key->preconditioner),
                       &s->poisson));
    return make_list(s);
}

/* A plan that was made for another method has no columns of this one's. */
static void find_columns(struct mps *s)
{
    const struct plan *p = s->moment->plan;
    const bool own = plan_solved(p->in.set.method) == &solved_mps;

    for (int k = 0; k < MPS_WORKS; k++)
        s->gave.column[k] = own ? p->book.solved + k : mps_conserved(p);
}

int mps_create(struct moment *moment, struct mps **out)
{
    struct mps *s = *out = status_alloc(1, sizeof *s);
    const struct plan *p = moment->plan;

    if (!s)
        return STATUS_FAILED;
    s->moment = moment;
    s->key = &p->in.mps;
    s->density = weights_of(s->key->re * p->scales.dx, p->scales.dx);
    s->gradient = weights_of(s->key->re_gradient * p->scales.dx, p->scales.dx);
    s->laplacian = weights_of(s->key->re_laplacian * p->scales.dx, p->scales.dx);
    if (take_memory(s) != STATUS_DONE) {
        mps_free(out);
        return STATUS_FAILED;
    }
    find_faces(s);
    find_columns(s);
    return STATUS_DONE;
}

void mps_free(struct mps **mps)
{
    struct mps *s = *mps;

    if (!s)
        return;
    s->moment->plan->engine->sum->list->free(&s->list);
    near_free(&s->near);
    poisson_free(&s->poisson);
    free(s->number), free(s->rate), free(s->before), free(s->rate_before), free(s->source);
    free(s->p), free(s->lowest), free(s->face), free(s->role), free(s->du), free(s->was);
    for (int k = 0; k < MPS_WORKS; k++)
        free(s->gave.kick[k]);
    free(s->gave.push);
    free(s);
    *mps = NULL;
}
