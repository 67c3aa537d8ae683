/* fused.c -- the loops of usual tables: a line each. */
#include "effects/fused.h"

#include "effects/artificial-viscosity.h"
#include "effects/density-diffusion.h"
#include "effects/density-rate.h"
#include "effects/effects.h"
#include "effects/laminar-viscosity.h"
#include "effects/pressure-force.h"
#include "kernels/wendland-c2.h"

/* See fused.h. */
#if defined SINGLE && LANES == 16
#define STRAIGHT 1
#include "space/single-row.h"
#else
#define STRAIGHT 0
#endif

#include <stdbool.h>
#include <stddef.h>

enum {
    MOST = 4,            /* laws in one loop: more do not fit into the registers    */
};

#if STRAIGHT
typedef pairs_straight loop;
#define PARAMETERS const struct pairs_table *table, const struct pairs_source *of, int n,  \
                   struct sum *sum
#define RUN(...)                                                                           \
    if (single_alike(of->all))                                                             \
        run(table, of, true, n, sum, __VA_ARGS__);                                         \
    else                                                                                   \
        run(table, of, false, n, sum, __VA_ARGS__)

LANES_INLINE const struct side *owners(const struct pairs_source *of)
{
    return &of->own->a;
}

/* What is under way of a row: here, all of it. */
typedef struct row begun;

LANES_INLINE begun begin(const struct wendland_c2 *c, const struct pairs_source *of, bool alike,
                         int k)
{
    struct whole_row row;

    single_row(of, alike, k, &row);
    row.pair.gw = wendland_c2_gradient(c, row.r, row.mm);
    row.pair.gw_r2 = wendland_c2_softened(c, row.pair.gw, row.pair.r2);
    return row.pair;
}

LANES_INLINE struct row row_of(const struct pairs_source *of, int k, const begun *row)
{
    (void)of;
    (void)k;
    return *row;
}
#else
typedef pairs_laws loop;
#define PARAMETERS const struct pairs_table *table, const struct side *a, struct block *b, \
                   struct sum *sum
#define RUN(...) run(table, &(struct pairs_source){ a, b }, false, b->n, sum, __VA_ARGS__)

struct pairs_source {
    const struct side *a;
    const struct block *b;
};

LANES_INLINE const struct side *owners(const struct pairs_source *of)
{
    return of->a;
}

/* The gradients that gather_kernel() would have left there. */
typedef struct {
    lanes gw, gw_r2;
} begun;

LANES_INLINE begun begin(const struct wendland_c2 *c, const struct pairs_source *of, bool alike,
                         int k)
{
    const struct block *b = of->b;
    begun row;

    (void)alike;
    row.gw = wendland_c2_gradient(c, b->r[k], b->mm[k]);
    row.gw_r2 = wendland_c2_softened(c, row.gw, b->r2[k]);
    return row;
}

LANES_INLINE struct row row_of(const struct pairs_source *of, int k, const begun *with)
{
    struct row row = pairs_row(of->b, k);

    row.gw = with->gw;
    row.gw_r2 = with->gw_r2;
    return row;
}
#endif

/* Of the laws of one loop: registers, not memory. */
struct sums {
    struct sum one, two, three, four;
};

/* Adds what the laws give on one row.  They are constants, NULL behind the last. */
LANES_INLINE void add_row(const struct pairs_work *w, const struct side *a, const struct row *row,
                          struct sums *to, pairs_row_law *first, pairs_row_law *second,
                          pairs_row_law *third, pairs_row_law *fourth)
{
    first(w[0].self, a, row, &to->one);
    if (second)
        second(w[1].self, a, row, &to->two);
    if (third)
        third(w[2].self, a, row, &to->three);
    if (fourth)
        fourth(w[3].self, a, row, &to->four);
}

/* Member by member, which leaves them in registers; a whole struct would go through memory. */
LANES_INLINE void take(const struct sum *from, struct sum *to)
{
    for (int d = 0; d < DIM; d++)
        to->f[d] = from->f[d];
    to->drho = from->drho;
}

/* The next row is under way while laws wait for the division of this one.  The laws are
 * constants; so is `alike`; n > 0. */
LANES_INLINE void run(const struct pairs_table *table, const struct pairs_source *of, bool alike,
                      int n, struct sum *sum, pairs_row_law *first, pairs_row_law *second,
                      pairs_row_law *third, pairs_row_law *fourth)
{
    const struct pairs_work *w = table->work;
    const struct side *a = owners(of);
    const struct wendland_c2 c = wendland_c2_of(w->kernel->support, w->kernel->inverse, w->kernel->scale);
    begun at = begin(&c, of, alike, 0);
    struct sums s;
    struct row row;

    take(&sum[w[0].slot], &s.one);
    if (second)
        take(&sum[w[1].slot], &s.two);
    if (third)
        take(&sum[w[2].slot], &s.three);
    if (fourth)
        take(&sum[w[3].slot], &s.four);
    for (int k = 1; k < n; k++) {
        const begun next = begin(&c, of, alike, k);

        row = row_of(of, k - 1, &at);
        add_row(w, a, &row, &s, first, second, third, fourth);
        at = next;
    }
    row = row_of(of, n - 1, &at);
    add_row(w, a, &row, &s, first, second, third, fourth);
    take(&s.one, &sum[w[0].slot]);
    if (second)
        take(&s.two, &sum[w[1].slot]);
    if (third)
        take(&s.three, &sum[w[2].slot]);
    if (fourth)
        take(&s.four, &sum[w[3].slot]);
}

#define LOOP(name, ...)                                                                    \
    static void name(PARAMETERS)                                                           \
    {                                                                                      \
        RUN(__VA_ARGS__);                                                                  \
    }

LOOP(rate_pressure, density_rate_row, pressure_force_row, NULL, NULL)
LOOP(rate_pressure_artificial, density_rate_row, pressure_force_row, artificial_viscosity_row,
     NULL)
LOOP(rate_pressure_laminar, density_rate_row, pressure_force_row, laminar_viscosity_row, NULL)
LOOP(rate_pressure_diffusion, density_rate_row, pressure_force_row, density_diffusion_row, NULL)
LOOP(rate_pressure_diffusion_upright, density_rate_row, pressure_force_row,
     density_diffusion_upright_row, NULL)
LOOP(rate_pressure_artificial_diffusion, density_rate_row, pressure_force_row,
     artificial_viscosity_row, density_diffusion_row)
LOOP(rate_pressure_artificial_diffusion_upright, density_rate_row, pressure_force_row,
     artificial_viscosity_row, density_diffusion_upright_row)
LOOP(rate_pressure_laminar_diffusion, density_rate_row, pressure_force_row,
     laminar_viscosity_row, density_diffusion_row)
LOOP(rate_pressure_laminar_diffusion_upright, density_rate_row, pressure_force_row,
     laminar_viscosity_row, density_diffusion_upright_row)
LOOP(pressure_artificial, pressure_force_row, artificial_viscosity_row, NULL, NULL)
LOOP(pressure_laminar, pressure_force_row, laminar_viscosity_row, NULL, NULL)
LOOP(pressure_alone, pressure_force_row, NULL, NULL, NULL)
LOOP(rate_diffusion, density_rate_row, density_diffusion_row, NULL, NULL)
LOOP(rate_diffusion_upright, density_rate_row, density_diffusion_upright_row, NULL, NULL)

#define RATE &LANE_NAME(effects_continuity)
#define PRESSURE &LANE_NAME(effects_pressure_force)
#define ARTIFICIAL &LANE_NAME(effects_artificial_viscosity)
#define LAMINAR &LANE_NAME(effects_laminar_viscosity)
#define DIFFUSION &LANE_NAME(effects_density_diffusion)

extern const struct part LANE_NAME(effects_continuity), LANE_NAME(effects_pressure_force),
    LANE_NAME(effects_artificial_viscosity), LANE_NAME(effects_laminar_viscosity),
    LANE_NAME(effects_density_diffusion);

static const struct {
    const struct part *part[MOST + 1]; /* parts with these laws, in table order, NULL-ended */
    loop *laws;
    loop *upright; /* where diffusion, the last law, has no slope but that along the last direction */
} fused[] = {
    { { RATE, PRESSURE }, rate_pressure, NULL },
    { { RATE, PRESSURE, ARTIFICIAL }, rate_pressure_artificial, NULL },
    { { RATE, PRESSURE, LAMINAR }, rate_pressure_laminar, NULL },
    { { RATE, PRESSURE, DIFFUSION }, rate_pressure_diffusion, rate_pressure_diffusion_upright },
    { { RATE, PRESSURE, ARTIFICIAL, DIFFUSION }, rate_pressure_artificial_diffusion,
      rate_pressure_artificial_diffusion_upright },
    { { RATE, PRESSURE, LAMINAR, DIFFUSION }, rate_pressure_laminar_diffusion,
      rate_pressure_laminar_diffusion_upright },
    { { PRESSURE, ARTIFICIAL }, pressure_artificial, NULL },
    { { PRESSURE, LAMINAR }, pressure_laminar, NULL },
    { { PRESSURE }, pressure_alone, NULL },
    { { RATE, DIFFUSION }, rate_diffusion, rate_diffusion_upright },
};

/* A part that chose another law than its usual one is another part here. */
static bool same(const struct pairs_table *table, const struct part *const *part)
{
    int n = 0;

    for (; part[n]; n++)
        if (n == table->n || table->work[n].law != part[n]->as.law->pairs
            || table->work[n].kernel != table->work[0].kernel)
            return false;
    return n == table->n && table->work[0].kernel->kernel == &kernel_wendland_c2;
}

static loop *find(const struct pairs_table *table)
{
    for (size_t i = 0; i < sizeof fused / sizeof *fused; i++)
        if (same(table, fused[i].part))
            return fused[i].upright && density_diffusion_is_upright(table->work[table->n - 1].self)
                   ? fused[i].upright : fused[i].laws;
    return NULL;
}

#if STRAIGHT
pairs_laws *fused_laws(const struct pairs_table *table)
{
    (void)table;
    return NULL;
}

pairs_straight *fused_straight(const struct pairs_table *table)
{
    return find(table);
}
#else
pairs_laws *fused_laws(const struct pairs_table *table)
{
    return find(table);
}

#ifdef SINGLE
pairs_straight *fused_straight(const struct pairs_table *table)
{
    (void)table;
    return NULL;
}
#endif
#endif
