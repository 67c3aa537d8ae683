/* formulas.c -- the formulas of tests/unit/effects-formulas.c, and those of the effects of
 * doc/adding-a-part.md, as they would stand there. */
#define effects_formula formulas_of_the_house
#include "../unit/effects-formulas.c"
#undef effects_formula

/* (S1) F = -m_a m_b k W (v_a - v_b)/rhobar, W = sigma/H^D (1 - q)^4 (1 + 4 q) */
static void velocity_smoothing(const struct pair_particle *a, const struct pair_particle *b,
                               struct pair_answer *to)
{
    const struct geometry p = look(a, b);
    const double H = effects_scales.support, q = p.r / H;
    const double sigma = DIM == 2 ? 7 / M_PI : 21 / (2 * M_PI);
    const double W = q < 1 ? sigma / pow(H, DIM) * pow(1 - q, 4) * (1 + 4 * q) : 0;

    for (int d = 0; d < DIM; d++)
        to->f[d] = -a->m * b->m * 2.3 * W * p.v[d] / mean_density(a, b);
}

/* (S2) the same with k = mu/(rho0 l^2) */
static void kernel_viscosity(const struct pair_particle *a, const struct pair_particle *b,
                             struct pair_answer *to)
{
    const double l2 = pow(effects_scales.support, 2) * (DIM == 2 ? 5.0 / 144 : 1.0 / 30);

    velocity_smoothing(a, b, to);
    for (int d = 0; d < DIM; d++)
        to->f[d] *= EFFECTS_MU / effects_scales.rho0 / l2 / 2.3;
}

pair_formula *effects_formula(const char *name)
{
    static const struct {
        const char *name;
        pair_formula *formula;
    } all[] = {
        { "velocity-smoothing", velocity_smoothing },
        { "kernel-viscosity", kernel_viscosity },
    };

    for (unsigned i = 0; i < sizeof all / sizeof all[0]; i++)
        if (strcmp(all[i].name, name) == 0)
            return all[i].formula;
    return formulas_of_the_house(name);
}
