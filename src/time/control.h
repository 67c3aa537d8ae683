/* control.h -- how long the next step shall be, from the errors of the last.
 *
 *   h_new = h lim(e_n^(-b1/k) e_(n-1)^(-b2/k) e_(n-2)^(-b3/k)),  lim(f) = 1 + atan(f - 1),
 *
 * k = the embedded order + 1 (the lesser of both orders).  Soderlind, ACM Trans.
 * Math. Softw. 29 (2003) 1-26; the limiter: Soderlind, Wang, J. Comput. Appl.
 * Math. 185 (2006) 225-243.  At a stability limit a small b1 + b2 with negative
 * b2 rejects hardly any step: a fifth fewer right-hand sides than with PI or PID. */
#ifndef TIME_CONTROL_H
#define TIME_CONTROL_H

struct control_row {
    double b[3];
    double aim;    /* error, in units of tol, that steps are steered to        */
    double accept; /* largest error, in units of tol, of an accepted step      */
    double growth; /* largest h_new/h                                          */
};

struct method_pace;

struct control {
    const struct control_row *row;
    int k;
    double before[2]; /* errors of the last accepted steps, in units of aim    */
};

/* Forgets the errors of the past, but for those of a pace; NULL: there is none. */
void control_start(struct control *c, const struct control_row *row, int order, int embedded,
                   const struct method_pace *pace);

/* Of steps that go on with h. */
struct method_pace control_pace(const struct control *c, double h);

/* Next step after one of length h whose error was e (in units of tol). */
double control_next(struct control *c, double h, double e);

#endif
