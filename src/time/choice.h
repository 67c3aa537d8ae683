/* choice.h -- what decided on the length of a step, for methods with an error estimate. */
#ifndef TIME_CHOICE_H
#define TIME_CHOICE_H

#include "state/limit.h"
#include "time/method.h"

struct choice {
    double h;                   /* the length decided on [s]                   */
    enum method_limiter limiter;
    long entry;                 /* of the largest error, -1: none known yet    */
    struct limit limit;         /* of the stability bound                      */
    char refusal[320];          /* "" unless f refused to answer               */
};

/* In words, for struct method_step. */
void choice_where(const struct choice *c, const struct moment *moment, char where[96]);

#endif
