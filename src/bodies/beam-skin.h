/* beam-skin.h -- points that the water meets, carried by a bending beam.
 *
 * A point at s along the axis and eta beside it moves across with the axis there,
 *
 *   x = at + s e + (eta + w(s)) n                                            (BE2)
 *
 * e points along the axis, n is e turned by +90 degrees.  That sections turn,
 * which would move the point by -eta theta(s) along e, is left out: it is small
 * (0.1 mm where the flagship's tip bends by 2 mm), and the point moments that it
 * would put on short elements double the number of steps.  For the same reason w is its
 * mean over the point's share of the length where elements are shorter than that: water
 * that is as coarse as the skin pushes an element each, where there are many, and the
 * single pushes would shake the others.  Forces go back by the
 * transpose of the same numbers, so that the work of the forces on the points is
 * the work on the beam, to rounding; what acts along e goes to the support. */
#ifndef BODIES_BEAM_SKIN_H
#define BODIES_BEAM_SKIN_H

#include "bodies/skin.h"

struct beam_skin_point {
    double rest[DIM];   /* where it is when the beam is straight [m]          */
    int first;          /* first degree of freedom of the element in its middle */
    double shape[4];    /* of w there                                         */
    int from, n;        /* degrees of freedom that it moves with              */
    const double *mean; /* [n] of w over its share of the length, or shape    */
};

struct beam_skin {
    struct skin_def def;
    int points;
    struct beam_skin_point *point;
    double *mean;       /* of all points; NULL: elements are long             */
};

/* Free with beam_skin_free(&s). */
int beam_skin_create(const struct skin_def *def, struct beam_skin **out);
void beam_skin_free(struct beam_skin **s); /* NULL is welcome */

/* x, u [points][DIM] from deflections and rotations q and their rates v. */
void beam_skin_move(const struct beam_skin *s, const double *q, const double *v,
                    double (*x)[DIM], double (*u)[DIM]);

/* u [points][DIM] alone, from rates v. */
void beam_skin_drift(const struct beam_skin *s, const double *v, double (*u)[DIM]);

/* Adds N^T force to f; force [points][DIM].  Returns the sum along the axis,
 * which bends nothing. */
double beam_skin_load(const struct beam_skin *s, const double (*force)[DIM], double *f);

#endif
