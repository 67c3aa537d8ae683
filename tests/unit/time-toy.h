/* time-toy.h -- a moment, and its plan, with a known solution, for the tests of the room time.
 *
 * Particles i on a line, each with x = sin(t + i), u = x', rho = 1 + 0.1 cos(t + i):
 *
 *   x' = u,  u' = x_e'' - (x^3 rho - x_e^3 rho_e) + (q - q_e),
 *   rho' = rho_e' - (rho u - rho_e u_e) + (v - v_e),  book' = x_0 u_0
 *
 * (e: exact), and, if stiffness > 0, a "beam" whose own terms are the stiff side:
 *
 *   q' = v,  v' = -stiffness q - damping v + [cos t + x_0 - x_e0]               */
#ifndef TIME_TOY_H
#define TIME_TOY_H

#include "eval/moment.h"

enum { TOY_PARTICLES = 3 };

struct moment {
    double stiffness, damping; /* of the beam; stiffness 0: there is none      */
    double wave, decay;        /* rates that moment_limit() reports              */
    double touch;              /* rate that moment_contact_limit() reports       */
    double off;                /* refuses further than this from the exact
                                  density; 0: never                            */
    double refuse_after;       /* refuses beyond this time; 0: never           */
    double poison_after;       /* answers with infinities; 0: never            */
    double solvable;           /* moment_solve() fails beyond this gamma; 0: never */
    double drag;               /* u' = .. - drag (u - u_e)                     */
    bool plain;                /* rho' = rho_e' - (u - u_e) + .., without rho  */
    const char *whole;         /* why there are no halves; NULL: there are     */
    double later;              /* the book takes u after this long, see struct ask */
    double listed;             /* x_0 at the last "rebuild" of the list, which
                                  shows in the last bits of f                  */
    struct layout layout;
    int row_x, row_u, row_rho, row_q, row_v, row_book;
    struct moment_counts counts;
};

struct plan {
    struct moment moment; /* all there is */
};

/* One with these knobs; wave is 1 and the others 0 unless said. */
void toy_make(struct moment *p, double stiffness, double damping);
void toy_exact(const struct moment *p, double t, double *y);

/* Largest |y - exact|, without the book. */
double toy_error(const struct moment *p, double t, const double *y);

#endif
