/* fixed-staggered.c -- partitioned coupling of Toth (2012): the water and the bodies
 * step in turn, each as if the other stood still.
 *
 * The water takes one step h of fixed-euler.c, (34), (35), (38), against the skins
 * of t_n.  The bodies feel F_n, the forces of the water at t_n, all that while, in
 * steps short enough for them:
 *
 *   n_t = int(h/h_max) + 1,  h_b = h/n_t                                 (48), (49)
 *   v_(k+1) = v_k + h_b M^-1 (F_n - D v_(k+1) - K q_(k+1))                     (46)
 *   q_(k+1) = q_k + h_b v_(k+1)                                                (47)
 *
 * Order 1, and energy is lost or made at every skin: forces and velocities of one
 * pair are of different times.  Backward Euler damps strongly: a vibration of
 * frequency omega shrinks by (1 + (omega h_b)^2)^(-1/2) a step.  Kept to compare
 * with; methods that take all at once are better.  Toth 2012, chapter 5 and
 * sections 4, 6.4. */
#include "time/fixed.h"

#include "algebra/vector.h"
#include "base/status.h"
#include <math.h>

/* Where no fluid asks for a step, bodies take theirs: one below `substep`, as (48)
 * wants it, or, when none is given, one as short as explicit methods need. */
static double length(struct fixed *x)
{
    const double h = fixed_euler_length(x);

    if (h < HUGE_VAL || x->ranges == 0)
        return h;
    if (!(x->substep < HUGE_VAL))
        return fixed_explicit_step(x);
    x->limit = (struct limit){ .where = -1, .part = "substep" };
    return nextafter(x->substep, 0);
}

/* right = y + h_b M^-1 F_n, entries of bodies, f of the water at t_n. */
static void push(const struct fixed *x, double h, const double *f, double *right)
{
    const double c[2] = { 1, h };

    for (int k = 0; k < x->ranges; k++) {
        const long i = x->range[k][0];
        vector_combine(2, c, (const double *[]){ x->y + i, f + i }, x->range[k][1] - i,
                       right + i);
    }
}

int fixed_bend(struct fixed *x, double h, const double *f, fixed_book *book)
{
    const long steps = (long)(h / x->substep) + 1;

    fixed_hold(x, x->y);
    for (long k = 1; k <= steps; k++) {
        push(x, h / steps, f, x->try);
        TRY(moment_solve(x->moment, x->t_old + h * k / steps, h / steps, x->try, x->y));
        if (book)
            book(x, x->t_old + h * k / steps, h / steps);
    }
    return STATUS_DONE;
}

static int advance(struct fixed *x, double h)
{
    TRY(fixed_euler_advance(x, h));
    return x->ranges > 0 ? fixed_bend(x, h, x->f_old, NULL) : STATUS_DONE;
}

static const char *serves(const struct plan *plan)
{
    const char *why = method_bodies_alone(plan);

    return why ? why : fixed_serves(plan);
}

const struct fixed_kind fixed_staggered = {
    .method = FIXED_METHOD_SERVING(serves, "staggered", 1,
                           "coupling of Toth (2012): water by euler-cfl, bodies by backward "
                           "Euler (strong damping), in turn; order 1",
                           "Toth 2012, equations (46)-(49), chapter 5"),
    .number = 0.25,
    .sides = ASK_EXPLICIT,
    .length = length,
    .advance = advance,
};
