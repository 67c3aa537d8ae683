/* effects-formulas.c -- the laws of src/effects/ as their papers have them: one
 * pair, plain doubles, powers by pow(). */
#include "effects-pair.h"

#include <math.h>
#include <string.h>

/* What every law needs of a pair: x = x_a - x_b, r, v.x and gradW = g x. */
struct geometry {
    double x[DIM], v[DIM], r, xv;
    double g; /* W'(r)/r */
};

/* W(r) = sigma/H^D (1 - q)^4 (1 + 4 q), q = r/H, differentiated by hand. */
static struct geometry look(const struct pair_particle *a, const struct pair_particle *b)
{
    const double H = effects_scales.support;
    const double sigma = DIM == 2 ? 7 / M_PI : 21 / (2 * M_PI);
    struct geometry p = { .r = 0 };
    double q;

    for (int d = 0; d < DIM; d++) {
        p.x[d] = a->x[d] - b->x[d];
        p.v[d] = a->v[d] - b->v[d];
        p.r += p.x[d] * p.x[d];
        p.xv += p.x[d] * p.v[d];
    }
    p.r = sqrt(p.r);
    q = p.r / H;
    if (q < 1)
        p.g = sigma * pow(H, -DIM - 1) * (-4 * pow(1 - q, 3) * (1 + 4 * q) + 4 * pow(1 - q, 4))
            / p.r;
    return p;
}

/* r^2 + 0.01 hs^2 */
static double softened(double r)
{
    return r * r + 0.01 * pow(effects_scales.hs, 2);
}

/* rhobar of (V2) and (D2): the harmonic mean */
static double mean_density(const struct pair_particle *a, const struct pair_particle *b)
{
    return 2 / (1 / a->rho + 1 / b->rho);
}

/* (D1) m_a d rho_a/dt = m_a m_b v . gradW */
static void continuity(const struct pair_particle *a, const struct pair_particle *b,
                       struct pair_answer *to)
{
    const struct geometry p = look(a, b);

    to->drho = a->m * b->m * p.xv * p.g;
}

/* (P1) F = -m_a m_b (p_a/rho_a^2 + p_b/rho_b^2) gradW */
static void pressure(const struct pair_particle *a, const struct pair_particle *b,
                     struct pair_answer *to)
{
    const struct geometry p = look(a, b);

    for (int d = 0; d < DIM; d++)
        to->f[d] = -a->m * b->m * (a->p2 + b->p2) * p.g * p.x[d];
}

/* (V2) F = m_a m_b alpha c0 hs (v.x)/(rhobar (r^2 + 0.01 hs^2)) gradW */
static void artificial_viscosity(const struct pair_particle *a, const struct pair_particle *b,
                                 struct pair_answer *to)
{
    const struct geometry p = look(a, b);
    const double rhobar = mean_density(a, b);

    for (int d = 0; d < DIM; d++)
        to->f[d] = a->m * b->m * EFFECTS_ALPHA * effects_scales.c0 * effects_scales.hs * p.xv
                 / (rhobar * softened(p.r)) * p.g * p.x[d];
}

/* (V1) F = m_a m_b 2 mu/(rho_a rho_b) x.gradW/(r^2 + 0.01 hs^2) v */
static void laminar_viscosity(const struct pair_particle *a, const struct pair_particle *b,
                              struct pair_answer *to)
{
    const struct geometry p = look(a, b);

    for (int d = 0; d < DIM; d++)
        to->f[d] = a->m * b->m * 2 * EFFECTS_MU / (a->rho * b->rho) * p.r * p.r * p.g
                 / softened(p.r) * p.v[d];
}

/* (V4) F = m_a m_b 2 (D + 2) mu/(rho_a rho_b) (v . x)/(r^2 + 0.01 hs^2) gradW */
static void stress_viscosity(const struct pair_particle *a, const struct pair_particle *b,
                             struct pair_answer *to)
{
    const struct geometry p = look(a, b);

    for (int d = 0; d < DIM; d++)
        to->f[d] = a->m * b->m * 2 * (DIM + 2) * EFFECTS_MU / (a->rho * b->rho) * p.xv
                 / softened(p.r) * p.g * p.x[d];
}

/* (D2), with rho_H = rho0 g.x/c0^2 */
static void density_diffusion(const struct pair_particle *a, const struct pair_particle *b,
                              struct pair_answer *to)
{
    const struct geometry p = look(a, b);
    const double rhobar = mean_density(a, b);
    double gx = 0;

    for (int d = 0; d < DIM; d++)
        gx += effects_scales.g[d] * p.x[d];
    to->drho = a->m * b->m * 2 * EFFECTS_DELTA * effects_scales.hs * effects_scales.c0
             * (a->rho - b->rho - effects_scales.rho0 * gx / pow(effects_scales.c0, 2)) / rhobar
             * p.r * p.r * p.g / softened(p.r);
}

/* Wendland's C2. */
static double kernel(double r)
{
    const double H = effects_scales.support, q = r / H;
    const double sigma = DIM == 2 ? 7 / M_PI : 21 / (2 * M_PI);

    return q < 1 ? sigma / pow(H, DIM) * pow(1 - q, 4) * (1 + 4 * q) : 0;
}

/* (W7) F = -n s U^2 m_a m_b/m (W(r)/W(dx))^(n-1) gradW/W(dx) */
static void contact_potential(const struct pair_particle *a, const struct pair_particle *b,
                              struct pair_answer *to)
{
    const struct geometry p = look(a, b);
    const double U = effects_scales.speed, near = effects_scales.nearby;

    for (int d = 0; d < DIM; d++)
        to->f[d] = -EFFECTS_POWER * EFFECTS_STRENGTH * U * U * a->m * b->m / effects_scales.mass
                 * pow(kernel(p.r) / near, EFFECTS_POWER - 1) * p.g / near * p.x[d];
}

/* (P3) F = -m_a m_b (R_a + R_b) (W(r)/W(dx))^4 gradW, R = strength max(0, -p)/rho^2 */
static void artificial_stress(const struct pair_particle *a, const struct pair_particle *b,
                              struct pair_answer *to)
{
    const struct geometry p = look(a, b);
    const double W = kernel(p.r);
    const double R = EFFECTS_STRENGTH * (fmax(0, -a->p2) + fmax(0, -b->p2));

    for (int d = 0; d < DIM; d++)
        to->f[d] = -a->m * b->m * R * pow(W / effects_scales.nearby, 4) * p.g * p.x[d];
}

/* (24) of Toth (2012) is a force density; by (33), with a = F/rho, the force on a is
 * m_a/rho_a times
 *   -rho_a (p_a/rho_a + p_b/rho_b) m_b gradW                             (24) */
static void pressure_printed(const struct pair_particle *a, const struct pair_particle *b,
                             struct pair_answer *to)
{
    const struct geometry p = look(a, b);
    const double pa = a->p2 * a->rho * a->rho, pb = b->p2 * b->rho * b->rho;

    for (int d = 0; d < DIM; d++)
        to->f[d] = a->m / a->rho
                 * -a->rho * (pa / a->rho + pb / b->rho) * b->m * p.g * p.x[d];
}

/* (V3) F = -m_a m_b mu/(rho_a rho_b) lapW v with lapW = s (H - r), s = 40/(pi H^5)
 * in 2D and 45/(pi H^6) in 3D */
static void laplacian_viscosity(const struct pair_particle *a, const struct pair_particle *b,
                                struct pair_answer *to)
{
    const struct geometry p = look(a, b);
    const double H = effects_scales.support, s = DIM == 2 ? 40 * H : 45;
    const double laplacian = p.r < H ? s / (M_PI * pow(H, 6)) * (H - p.r) : 0;

    for (int d = 0; d < DIM; d++)
        to->f[d] = -a->m * b->m * EFFECTS_MU / (a->rho * b->rho) * laplacian * p.v[d];
}

/* By (33) m_a/rho_a times
 *   -mu (u_b - u_a) m_b/rho_b lapW                                       (28)
 *   lapW = -40/(pi H^4) (H - r)                                          (31) */
static void viscosity_printed(const struct pair_particle *a, const struct pair_particle *b,
                              struct pair_answer *to)
{
    const struct geometry p = look(a, b);
    const double H = effects_scales.support;
    const double laplacian = p.r < H ? -40 / (M_PI * pow(H, 4)) * (H - p.r) : 0;

    for (int d = 0; d < DIM; d++)
        to->f[d] = a->m / a->rho * -EFFECTS_MU * (b->v[d] - a->v[d]) * b->m / b->rho * laplacian;
}

pair_formula *effects_formula(const char *name)
{
    static const struct {
        const char *name;
        pair_formula *formula;
    } all[] = {
        { "continuity", continuity },
        { "summation", continuity }, /* its rate is the same */
        { "pressure", pressure },
        { "pressure-printed", pressure_printed },
        { "artificial-viscosity", artificial_viscosity },
        { "laminar-viscosity", laminar_viscosity },
        { "stress-viscosity", stress_viscosity },
        { "laplacian-viscosity", laplacian_viscosity },
        { "viscosity-printed", viscosity_printed },
        { "density-diffusion", density_diffusion },
        { "artificial-stress", artificial_stress },
        { "contact-potential", contact_potential },
    };

    for (unsigned i = 0; i < sizeof all / sizeof all[0]; i++)
        if (strcmp(all[i].name, name) == 0)
            return all[i].formula;
    return NULL;
}
