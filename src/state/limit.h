/* limit.h -- what a part says of the explicit steps that it allows. */
#ifndef STATE_LIMIT_H
#define STATE_LIMIT_H

#include <stdbool.h>

/* The largest explicit step a part's physics allows: a method multiplies 1/rate
 * by its own stability factor, which differs for waves and for decay. */
struct limit {
    double rate;    /* largest |eigenvalue| of the part [1/s]; 0: no limit    */
    bool decay;     /* eigenvalues are real and negative, else imaginary      */
    int where;      /* particle (its id) or element that sets it              */
    double found;   /* what was compared to find it: of several places the largest sets
                       the rate, of equal ones the smallest id                */
    char part[64];  /* name of the part                                       */
};

#endif
