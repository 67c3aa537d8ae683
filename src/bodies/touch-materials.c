/* touch-materials.c -- spheres that are made of something.
 *
 *   1/E* = sum (1 - nu^2)/E,  1/G* = sum 2 (2 - nu)(1 + nu)/E
 *   k = 4/3 E* sqrt(R*),  k_t = 8 G* sqrt(R* d)                                     (RT8)
 *   d_U = (5/4 M U^2/k)^(2/5)                                                       (RT1)
 *
 * Hertz (1882); Mindlin, J. Appl. Mech. 16 (1949) 259-268; Johnson, Contact Mechanics, 1985, 4.2
 * and 7.2. */
#include "bodies/touch-materials.h"

#include <math.h>

static const double rolls = 3.5; /* 1/m + r^2/I of a ball, by 1/m */

double touch_materials_elastic(const struct touch_material *a, const struct touch_material *b)
{
    return 1 / ((1 - a->poisson * a->poisson) / a->young + (1 - b->poisson * b->poisson) / b->young);
}

static double yields(const struct touch_material *m)
{
    return 2 * (2 - m->poisson) * (1 + m->poisson) / m->young;
}

double touch_materials_shear(const struct touch_material *a, const struct touch_material *b)
{
    return 1 / (yields(a) + yields(b));
}

struct touch_law touch_materials_law(const struct touch_material of[2], double radius, double mass,
                                     double speed, double restitution, double mu, double *depth)
{
    const double k = 4 / 3.0 * touch_materials_elastic(&of[0], &of[1]) * sqrt(radius);

    *depth = pow(1.25 * mass * speed * speed / k, 0.4);
    return (struct touch_law){ .k = k, .mu = mu, .eta = touch_damping(restitution),
                               .shear = 8 * touch_materials_shear(&of[0], &of[1]) * sqrt(radius),
                               .tau = 1 / touch_rate(speed, *depth) };
}

/* By stiffnesses 8 G* sqrt(R* d) and 2 E* sqrt(R* d). */
double touch_materials_along(const struct touch_material of[2])
{
    const double stiff = 4 * touch_materials_shear(&of[0], &of[1])
                       / touch_materials_elastic(&of[0], &of[1]);

    return fmax(1, sqrt(rolls * stiff));
}
