/* beam-couple.h -- members of bodies_beam for a solve together with an implicit viscosity:
 * see bodies.h. */
#ifndef BODIES_BEAM_COUPLE_H
#define BODIES_BEAM_COUPLE_H

#include "bodies/bodies.h"

int beam_couple_unknowns(const struct body *b);
void beam_couple_read(const struct body *b, const struct layout *l, const double *y, double *v);
void beam_couple_write(const struct body *b, const struct layout *l, double gamma, const double *r,
                       const double *v, double *z);
void beam_couple_right(const struct body *b, struct body_work *w, const struct layout *l,
                       double gamma, const double *r, double *to);
void beam_couple_inertia(const struct body *b, struct body_work *w, double gamma,
                         const double *v, double *to);
void beam_couple_drift(const struct body *b, const double *v, double (*u)[DIM]);
void beam_couple_pull(const struct body *b, struct body_work *w, const double (*force)[DIM],
                      double c, double *to);
int beam_couple_join(const struct body *b, struct body_work *w, double gamma, const double *c);
void beam_couple_joined(const struct body *b, const struct body_work *w, double *v);
double beam_couple_fastest(const struct body *b, const double *v);
void beam_couple_yield(const struct body *b, struct body_work *w, const struct layout *l,
                       const double (*force)[DIM], double *ydot, double support[DIM]);
void beam_couple_settle(const struct body *b, struct body_work *w, const struct layout *l,
                        double gamma, const double *r, const double *z,
                        const double (*force)[DIM], double support[DIM]);

#endif
