/* memory.c -- what a run will need memory for. */
#include "plan/memory.h"

#include "plan/facts.h"
#include "plan/inside.h"
#include "plan/solver.h"
#include "space/nabla.h"
#include "space/record.h"
#include "space/single.h"

#include <math.h>

enum { USUAL_VECTORS = 20 }; /* of a method that is not known yet: 4 stages */

struct count {
    double fluid, solid; /* particles                                           */
    double floor, cells; /* solids below the domain; cells over it               */
    double numbers;      /* in y                                                */
    double entries;      /* in the rows of one pair list                        */
    double slots;        /* of a particle, images included                      */
    int vectors;         /* of the size of y, of the method                     */
    bool fields;         /* densities are summed                                */
    bool viscous;        /* a viscosity is implicit                             */
    bool ahead;          /* a pressure that looks ahead is solved for           */
    bool faces;          /* the fluid sticks at faces                           */
    bool drifts;         /* positions move with more than velocities            */
    bool moves;          /* solids do                                           */
    bool gauges;         /* there are probes                                    */
};

/* Neighbours of a particle of the fluid in the list, on a full lattice. */
static double neighbours(const struct plan *p)
{
    const double r = p->in.kernel.support * (1 + p->in.kernel.skin);

    return DIM == 2 ? M_PI * r * r : 4 * M_PI / 3 * r * r * r;
}

/* Neighbours across a plane, shared among the layers of a wet wall. */
static double neighbours_of_wall(const struct plan *p)
{
    const double r = p->in.kernel.support * (1 + p->in.kernel.skin);

    return (DIM == 2 ? 2 * r * r * r / 3 : M_PI / 4 * r * r * r * r) / ceil(p->in.kernel.support);
}

/* Places of a particle: itself, and its images near periodic sides. */
static double slots(const struct plan *p)
{
    const double reach = (1 + p->in.kernel.skin) * p->scales.support;
    double all = 1;

    for (int d = 0; d < DIM; d++)
        if (p->scales.period[d] > 0)
            all *= 1 + 2 * reach / p->scales.period[d];
    return all;
}

/* Particles as files have them, fluid that is company, and pressures for gauges. */
static double frames(const struct count *c)
{
    const double kind = 1, pressures = c->gauges ? 8 : 0;

    return (c->fluid + c->solid) * ((2 * DIM + 2) * 8 + kind) + c->fluid * (PLAN_COMPANY + pressures);
}

/* What else may be company, and where it begins in cells (measure/crowd.c). */
static double company(const struct count *c)
{
    return c->floor * PLAN_COMPANY + 4 * c->cells;
}

/* While their file is made, it takes no more for each (output/fields-file.c).  Cells of measure/pairing.c grow
 * by a quarter until they are four a particle or fewer: of these four, so many on the whole. */
static double outputs(const struct count *c)
{
    const double pairing = 4 + 8 + 0.8 * 16;

    return frames(c) + company(c) + c->fluid * pairing;
}

/* Cells of one support over the domain, or fewer (measure/crowd.c). */
static double cells(const struct plan *p)
{
    const double support = p->scales.support, most = 4.0 * p->particles->n + 64;
    double all = 1;

    for (int d = 0; d < DIM; d++)
        all *= floor((p->scales.high[d] - p->scales.low[d]) / support + 2) + 1;
    return fmin(all, most);
}

/* Solids below the domain, on which water may stand. */
static double floor_of(const struct plan *p)
{
    const struct particles *all = p->particles;
    double n = 0;

    for (int i = all->from[KIND_WALL]; i < all->n; i++)
        n += all->x0[i][DIM - 1] < p->scales.low[DIM - 1];
    return n;
}

/* Coefficients of pairs, velocities and their sums by place, y of a stage, vectors. */
static double viscous(const struct count *c)
{
    const double n = c->fluid + c->solid;

    if (!c->viscous)
        return 0;
    return 8 * (1.25 * c->entries + n * (c->slots * COUPLE_STRIDE + 2 + DIM) + c->numbers
                + c->fluid * DIM * implicit_viscous.vectors);
}

/* Weights of pairs and their neighbours, a scalar and a vector by place, P and the system
 * it solves, vectors of the solver. */
static double ahead(const struct count *c)
{
    const double n = c->fluid + c->solid;

    if (!c->ahead)
        return 0;
    return 1.25 * c->entries * (8 * DIM + 4) + 8 * c->fluid
           + 8 * n * (1.125 * c->slots * (1 + NABLA_STRIDE) + implicit_ahead.vectors);
}

/* Coefficients of pairs of fluid and solids, from both sides; velocities and slip by
 * place; forces of two kinds and sums. */
static double faces(const struct plan *p, const struct count *c)
{
    const double n = c->fluid + c->solid;

    return c->faces ? 8 * (2.5 * neighbours_of_wall(p) * c->solid
                           + n * (c->slots * 2 * COUPLE_STRIDE + 2 * DIM + 2))
                    : 0;
}

/* Records of pairs in single precision. */
static double single(const struct plan *p, const struct count *c)
{
    const double record = sizeof(float) * (double)single_floats(p->table.mass);

    return p->engine->laws == p->engine->effects
               ? 0
               : record * 1.125 * c->slots * (c->fluid + c->solid);
}

/* What a wall model with a pressure of its own keeps. */
static double pressed(const struct plan *p)
{
    const struct plan_part *wall = p->passes.press;

    return wall ? wall->part->as.wall->press->memory(wall->self) : 0;
}

/* What goes through it. */
static double pressing(const struct plan *p)
{
    const double solids = p->particles->n - particles_count(p->particles, KIND_FLUID);

    return p->passes.press ? 8 * p->particles->n + (8 * (1 + DIM) + 5 + (plan_ahead(p) > 0 ? 32 : 0)) * solids : 0;
}

/* Records, forces, and rates of densities by place; fields of densities. */
static double records(const struct count *c)
{
    return 8 * (c->fluid + c->solid) * (c->slots * RECORD + DIM + 1 + (c->fields ? 1 + PART_SUMS : 0))
           + (c->drifts ? 8 * c->fluid * DIM : 0);
}

/* What a pressure that is solved for once a step works in. */
static double solved(const struct plan *p)
{
    const struct plan_solved *by = plan_solved(p->in.set.method);

    return by ? by->memory(p) : 0;
}

static void estimate(const struct plan *p, const struct count *c, struct plan_memory *m)
{
    const double n = c->fluid + c->solid;

    *m = (struct plan_memory){
        .state = 8 * c->numbers * (c->vectors + 2), /* rates of looks, run->y */
        .lists = 2 * list_bytes(n, n * c->slots, c->entries),
        .sums = records(c) + viscous(c) + ahead(c) + faces(p, c) + single(p, c), .records = records(c),
        .particles = n * (8 * (1 + DIM) + 4 + 1) + c->solid * 8 * 2 * 2 * DIM,
        .beside = c->solid * 8 * DIM * (c->moves ? 2 : 1), .idle = c->moves ? 0 : c->solid * 8 * 2 * DIM,
        .outputs = outputs(c), .frames = frames(c), .company = company(c),
    };
}

void plan_memory(const struct plan *p, double pairs, int vectors, struct plan_memory *out)
{
    const double fluid = particles_count(p->particles, KIND_FLUID);
    const struct count c = {
        .fluid = fluid, .solid = p->particles->n - fluid, .floor = floor_of(p), .cells = cells(p),
        .numbers = layout_size(&p->layout),
        .entries = pairs >= 0
                       ? pairs
                       : neighbours(p) * fluid + neighbours_of_wall(p) * (p->particles->n - fluid),
        .slots = slots(p), .vectors = vectors, .fields = p->passes.fields > 0 || p->passes.filters, .viscous = p->stiff,
        .drifts = p->drifter, .faces = p->face, .moves = p->moving_walls || p->bodies > 0, .ahead = plan_ahead(p) > 0,
        .gauges = plan_probes(p) > 0,
    };

    estimate(p, &c, out);
    out->records += pressing(p);
    out->sums += pressed(p) + pressing(p) + solved(p);
}

double plan_memory_sum(const struct plan_memory *m)
{
    return 1.04 * (m->state + m->lists + m->sums + m->particles + m->outputs);
}

double plan_memory_each(const struct plan *p, bool fluid)
{
    const struct count c = {
        .fluid = fluid, .solid = !fluid, .floor = !fluid, .numbers = fluid ? 2 * DIM + 1 : 1,
        .entries = fluid ? neighbours(p) : neighbours_of_wall(p), .slots = slots(p),
        .vectors = USUAL_VECTORS,
    };
    struct plan_memory m;

    estimate(p, &c, &m);
    return plan_memory_sum(&m);
}

void plan_show(const struct plan *p, part_see *see, void *whose)
{
    const struct particles *of = p->particles;
    const struct plan_part *wall = p->passes.press;
    const size_t n = (size_t)of->n;

    see(whose, of->m, n * sizeof *of->m);
    see(whose, of->x0, n * sizeof *of->x0);
    see(whose, of->object_of, n * sizeof *of->object_of);
    see(whose, of->dye, n * sizeof *of->dye);
    if (wall)
        wall->part->as.wall->press->show(wall->self, see, whose);
}
