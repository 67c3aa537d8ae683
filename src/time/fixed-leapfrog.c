/* fixed-leapfrog.c -- velocity Verlet with predicted velocity and density.
 *
 *   v_1/2 = v + h/2 a,  rho_1/2 = rho + h/2 D,  x_new = x + h v_1/2,
 *   (a, D)_new = f(x_new, v + h a, rho + h D),
 *   v_new = v_1/2 + h/2 a_new,  rho_new = rho_1/2 + h/2 D_new                   (LF)
 *
 * One right-hand side a step, second order.  What is called rho here is every
 * entry that is neither position nor velocity.  Step: CFL number * hs/(c0 + v),
 * a quarter by default: with a half it has been seen to blow up at impacts. */
#include "time/fixed.h"

#include "algebra/vector.h"
#include "base/status.h"

/* Velocities and what follows them, over a time h: to = y + h f. */
static void kick(const struct fixed *x, const double *y, double h, const double *f, double *to)
{
    const long from = x->from[LAYOUT_VELOCITY];
    const double c[2] = { 1, h }, *const v[2] = { y + from, f + from };

    vector_combine(2, c, v, x->n - from, to + from);
}

static int advance(struct fixed *x, double h)
{
    const long from = x->from[LAYOUT_VELOCITY];
    const double c[2] = { 1, h };

    kick(x, x->y_old, h / 2, x->f_old, x->y);
    vector_combine(2, c, (const double *[]){ x->y_old, x->y + from }, from, x->y);
    vector_copy(from, x->y, x->try);
    kick(x, x->y_old, h, x->f_old, x->try);
    TRY(moment_eval(x->moment, ASK_ALL, x->t_old + h, x->try, x->f));
    kick(x, x->y, h / 2, x->f, x->y);
    x->has_f = true;
    return STATUS_DONE;
}

const struct fixed_kind fixed_leapfrog = {
    .method = FIXED_METHOD("leapfrog", 2, "velocity Verlet, 1 right-hand side a step, order 2",
                           "Verlet, Phys. Rev. 159 (1967) 98-103"),
    .number = 0.25,
    .sides = ASK_EXPLICIT | ASK_IMPLICIT,
    .spared = 1,
    .length = fixed_wave_step,
    .advance = advance,
};
