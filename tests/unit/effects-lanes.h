/* effects-lanes.h -- asks an effect at the lane width LANES; the including file
 * sets it. */
#if LANES > 2 /* slow without AVX, but right: no vector leaves this file */
#pragma GCC diagnostic ignored "-Wpsabi"
#endif
#include "effects-pair.h"

#include "space/gather.h"
#include "space/list.h"
#include "space/record.h"

#include <math.h>
#include <string.h>

static void set_record(double *r, const struct pair_particle *p)
{
    r[RECORD_X] = p->x[0];
    r[RECORD_X + 1] = p->x[1];
    r[RECORD_V] = p->v[0];
    r[RECORD_V + 1] = p->v[1];
#if DIM == 3
    r[RECORD_Z] = p->x[2];
    r[RECORD_VZ] = p->v[2];
#endif
    r[RECORD_RHO] = p->rho;
    r[RECORD_IRHO] = 1 / p->rho;
    r[RECORD_P2] = p->p2;
    r[RECORD_M] = p->m;
}

void LANE_NAME(effects_ask)(const struct pair_law *law, const struct pair_particle *a, int n,
                            const struct pair_particle *b, int padding, struct pair_answer *to)
{
    const struct part_law *rule = law->part->as.law;
    static _Alignas(64) double record[(PAIR_MOST + 2) * RECORD];
    const struct pair_particle far = { .x = { 1e3 }, .rho = effects_scales.rho0, .m = 1 };
    const struct kernel_use use = kernel_use_make(
        rule->rows & NEED_LAPW ? &kernel_viscosity_log : &kernel_wendland_c2,
        effects_scales.support, DIM);
    part_pairs *pairs = rule->choose ? rule->choose(law->self) : rule->pairs;
    static struct block block;
    int j[PAIRS_ROWS * LANES];
    struct sum sum = { 0 };
    struct side side;

    set_record(record, a);
    for (int i = 0; i < n; i++)
        set_record(record + (i + 1) * RECORD, &b[i]);
    set_record(record + (n + 1) * RECORD, &far);
    for (int i = 0; i < (n + padding) * LANES; i++)
        j[i] = list_entry(i % LANES == 0 && i / LANES < n ? 1 + i / LANES : n + 1);
    memset(&block, 0xff, sizeof block); /* all bits set are a NaN */
    block.n = n + padding;
    gather_side(record, 0, 1, n + 1, &side);
    gather_choose(rule->rows)(record, j, block.n, &side, &block);
    gather_kernel(rule->rows, &use, &block);
    pairs(law->self, &side, &block, &sum);
    for (int d = 0; d < DIM; d++)
        to->f[d] = sum.f[d][0];
    to->drho = sum.drho[0];
}
