/* growth.h -- how fast a tiny disturbance grows: until when positions mean something. */
#ifndef STUDY_GROWTH_H
#define STUDY_GROWTH_H

struct growth {
    double rate;  /* e-foldings a second [1/s]                                            */
    double until; /* until then less than two digits are lost [s]                         */
};

enum { GROWTH_LOST = 100 };

/* From d[i], the distance of particles of two runs [m] at the times t[i], i = 0..n-1, after
 * gravity g [m/s^2] was tilted by eps [rad].  A free particle would be off by
 * eps g t^2 / 2; the gain is d over that, the rate the slope of its logarithm (least squares)
 * while d stays below a tenth of dx.  NAN: fewer than three such times. */
void growth_fit(struct growth *out, int n, const double *t, const double *d, double eps, double g,
                double dx);

#endif
