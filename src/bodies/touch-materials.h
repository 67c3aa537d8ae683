/* touch-materials.h -- the law of spheres that are made of something: Hertz and Mindlin. */
#ifndef BODIES_TOUCH_MATERIALS_H
#define BODIES_TOUCH_MATERIALS_H

#include "bodies/touch.h"

struct touch_material {
    double young, poisson;  /* E [Pa], nu                                           */
};

/* Of a pair: E* and G*, both [Pa]. */
double touch_materials_elastic(const struct touch_material *a, const struct touch_material *b);
double touch_materials_shear(const struct touch_material *a, const struct touch_material *b);

/* Spheres of reduced radius [m], as touch_law() otherwise; 3D only.  How deep they get at that speed
 * follows: *depth [m]. */
struct touch_law touch_materials_law(const struct touch_material of[2], double radius, double mass,
                                     double speed, double restitution, double mu, double *depth);

/* The fastest rate along the surface of a sphere by that of pressing, both at one depth. */
double touch_materials_along(const struct touch_material of[2]);

#endif
