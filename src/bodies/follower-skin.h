/* follower-skin.h -- points that the water meets, carried by a beam that bends far.
 *
 * A point at s along the beam and eta beside it keeps its distance from the centre line,
 *
 *   x = r(s) + eta n,   n = c turned by +90 degrees over |c|, c = r(s + a) - r(s - a)   (BE6)
 *
 * with the chord c over two spacings of the skin, cut off at the ends, in place of the
 * tangent: so a force along the skin turns the beam by two opposite forces two spacings
 * apart, not by a moment on one node, which only short steps could follow.  Velocities are
 * the time derivative, forces go back by its exact transpose. */
#ifndef BODIES_FOLLOWER_SKIN_H
#define BODIES_FOLLOWER_SKIN_H

#include "bodies/skin.h"

struct follower_skin_place { /* a point of the centre line */
    int element;
    double s, shape[4];      /* rest length from the root [m]; of r          */
};

struct follower_skin_point {
    struct follower_skin_place here, back, front;
    double eta;              /* [m]                                          */
};

struct follower_skin {
    struct skin_def def;
    int points;
    struct follower_skin_point *point;
};

/* Free with follower_skin_free(&s). */
int follower_skin_create(const struct skin_def *def, struct follower_skin **out);
void follower_skin_free(struct follower_skin **s); /* NULL is welcome */

/* x, u [points][DIM] from degrees of freedom q (elastica.h) and their rates v; NULL u:
 * positions only. */
void follower_skin_move(const struct follower_skin *s, const double *q, const double *v,
                        double (*x)[DIM], double (*u)[DIM]);

/* u [points][DIM] alone. */
void follower_skin_drift(const struct follower_skin *s, const double *q, const double *v,
                         double (*u)[DIM]);

/* Adds to a [points][DIM] the accelerations that points have while v does not change: each
 * turns about the centre line. */
void follower_skin_bend(const struct follower_skin *s, const double *q, const double *v,
                        double (*a)[DIM]);

/* Adds (dx/dq)^T force to f; force [points][DIM]. */
void follower_skin_load(const struct follower_skin *s, const double *q,
                        const double (*force)[DIM], double *f);

/* r - at at s [m] in the frame of the straight beam: along, across. */
void follower_skin_centre(const struct follower_skin *s, double at, const double *q, double *r);

#endif
