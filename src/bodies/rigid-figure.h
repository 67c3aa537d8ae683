/* rigid-figure.h -- what follows from the shape of a rigid body: size, inertia, cores. */
#ifndef BODIES_RIGID_FIGURE_H
#define BODIES_RIGID_FIGURE_H

#include "bodies/rigid-form.h"

/* Refuses (BAD_SCENE) what makes no body.  From then on *d tells place and spin of the centre of
 * mass and of the axes of inertia. */
int rigid_figure_make(struct rigid_def *d, const char *path, struct rigid_figure *to);
/* The shape of that name, a box for others; BAD_SCENE: keys are missing or not its own. */
const struct rigid_form *rigid_figure_form(const char *name);
int rigid_figure_keys(const struct rigid_form *form, const struct rigid_def *d, const char *path);

void rigid_figure_free(struct rigid_figure *f);

double rigid_figure_mass(const struct rigid_figure *f, const struct rigid_def *d); /* [kg, 2D: kg/m] */

/* Principal moments of inertia to [TURNING_SPINS] [kg m^2, 2D: kg m]. */
void rigid_figure_inertia(const struct rigid_figure *f, double mass, double *to);

/* Is x inside of the body as it stands at the start? */
bool rigid_figure_holds(const struct rigid_figure *f, const struct rigid_def *d, const double *x);

/* Measures what is made of convex parts, which stand in the frame of the scene, and tells them, and
 * an outline, in the body's own frame. */
int rigid_figure_measure(struct rigid_figure *f);

/* Makes kernels of all parts: what is left of them below the margin, or below half of their own
 * depth where they are thin. */
int rigid_figure_kernels(struct rigid_figure *f, double margin);

/* What pictures show of it, in its own frame. */
int rigid_figure_surface(const struct rigid_figure *f, struct surface *to);

/* The cores of what is made of convex parts, one each; as cores() of struct rigid_form. */
int rigid_figure_cores(const struct rigid_figure *f, double margin, struct core *core);

#endif
