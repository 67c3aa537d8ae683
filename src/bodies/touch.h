/* touch.h -- the law of two surfaces that press and rub at one place.
 *
 * Smooth enough for a method with error control: the force begins at 0, friction remembers
 * how far the surfaces were bent along each other, xi, which is state [DIM] [m].  Nothing in
 * it is faster than touch_rate(). */
#ifndef BODIES_TOUCH_H
#define BODIES_TOUCH_H

#include "space/kinds.h"

struct touch_law {
    double k;     /* of Hertz [N/m^(3/2), 2D: per metre of width]                */
    double along; /* the same along the surface, k_t [N/m, 2D: N/m^2]            */
    double shear; /* of Mindlin, 8 G* sqrt(R*) [N/m^(3/2)]; 0: `along` counts    */
    double eta;   /* damping, touch_damping() of the restitution                 */
    double mu;    /* coefficient of friction; 0: none                            */
    double tau;   /* in which what slides forgets what it was bent by [s]        */
};

struct touch_place {
    double depth, rate;     /* of the overlap [m], and how fast it grows [m/s]     */
    double normal[DIM];     /* out of the partner, into the body                   */
    double velocity[DIM];   /* of the body's surface beside the partner [m/s]      */
    double mass;            /* that a push along the normal meets there [kg]       */
    double carried;         /* that all pushes of the two together meet there [kg] */
};

/* How deep it gets at the speed U, in two margins, where no scene says so: that of a contact as fast as
 * sound of c0,
 *   p = min(0.25, 2.7 U/(c0 + U))                                                   (RT5) */
extern const double touch_softest; /* that 0.25 */
double touch_softness(double speed, double c0);

/* Of two solids with a and b, NaN: it has none of its own; unless a rule, not NaN, says it. */
double touch_mixed(double rule, double a, double b);

/* A body of that mass that comes with `speed` is stopped within `depth`. */
struct touch_law touch_law(double mass, double speed, double depth, double restitution,
                           double mu);

/* eta of (RT2) for a restitution of 0.1 to 1, found by integrating impacts. */
double touch_damping(double restitution);

/* The fastest rate of a face that meets with `speed` [1/s]. */
double touch_rate(double speed, double depth);

/* A step that ends after its last stage sees nothing of what touches only there, however strict
 * its error test, and the force begins as a root does: no step may change the overlap by more
 * than the gap that is left and a tenth of d_U,
 *   h <= (gap + d_U/10)/|d'|,  as the rate 3/h, by a method stable to 3.             (RT6) */
double touch_coming(double overlap, double closing, double depth);

/* From how far away that could be shorter than steps at that rate [m]. */
double touch_window(double rate, double closing);

/* Force on the body [DIM] [N] along the normal and along the surface; rate of xi. */
void touch(const struct touch_law *law, const struct touch_place *at, const double *xi,
           double *press, double *rub, double *xi_rate);

/* Rate of xi where nothing touches. */
void touch_forget(const double *xi, double *xi_rate);

#endif
