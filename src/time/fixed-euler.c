/* fixed-euler.c -- the integrator of Toth (2012) and its rule for the step.
 *
 *   u_new = u + h a(x, u, rho)                                                 (34)
 *   x_new = x + h u_new                                                        (35)
 *   rho_new = rho + h D(x, u_new, rho)
 *   h = min(0.4 H/v_max, 0.25 sqrt(H rho0/F_max), CFL hs/(c0 + v_max))         (38)
 *
 * F/rho0 is the acceleration.  The last term of (38) is ours: without the sound
 * speed that rule lets steps be ten to a hundred times too long.  Two
 * right-hand sides a step, since the density sees the new velocity.  Toth 2012,
 * section 3.6. */
#include "time/fixed.h"

#include "algebra/vector.h"
#include "base/status.h"
#include "ranks/ranks.h"
#include <math.h>
#include <string.h>

int fixed_euler_advance(struct fixed *x, double h)
{
    const long u = x->from[LAYOUT_VELOCITY], rho = x->from[LAYOUT_OTHER];
    const double c[2] = { 1, h };

    vector_combine(2, c, (const double *[]){ x->y_old + u, x->f_old + u }, rho - u, x->y + u);
    vector_combine(2, c, (const double *[]){ x->y_old, x->y + u }, u, x->y);
    if (rho == x->n)
        return STATUS_DONE;
    vector_copy(x->n, x->y_old, x->try);
    vector_copy(rho - u, x->y + u, x->try + u);
    fixed_hold(x, x->try);
    TRY(moment_eval(x->moment, (struct ask){ .sides = x->kind->sides }, x->t_old, x->try,
                    x->rates));
    vector_combine(2, c, (const double *[]){ x->y_old + rho, x->rates + rho }, x->n - rho,
                   x->y + rho);
    return STATUS_DONE;
}

/* What a rank found among its own rows. */
struct largest {
    double square;
    int id;
};

double fixed_largest(const struct fixed *x, int r, const double *y, int *where)
{
    const struct layout_row *row = &moment_layout(x->moment)->row[r];
    struct largest most = { 0, *where };

    for (int i = 0; i < row->n; i++) {
        const int id = moment_id(x->moment, r, i);
        double square = 0;
        for (int d = 0; d < row->components; d++) {
            const double c = y[row->offset + (long)i * row->components + d];
            square += c * c;
        }
        if (square > most.square || (square == most.square && square > 0 && id < most.id))
            most = (struct largest){ square, id };
    }
    ranks_first(-most.square, most.id, &most, sizeof most);
    *where = most.id;
    return sqrt(most.square);
}

double fixed_shorter(struct fixed *x, double h, double other, int where, const char *name)
{
    if (!(other < h))
        return h;
    x->limit = (struct limit){ .where = where };
    strcpy(x->limit.part, name);
    return other;
}

/* (38), over the rows of velocities of particles. */
double fixed_euler_length(struct fixed *x)
{
    const struct layout *l = moment_layout(x->moment);
    const double H = plan_length(x->plan);
    double h = fixed_wave_step(x);

    for (int r = 0; r < l->rows; r++) {
        int fast = -1, pushed = -1;
        if (l->row[r].what != LAYOUT_VELOCITY || strncmp(l->row[r].name, "velocity", 8) != 0)
            continue;
        const double v = fixed_largest(x, r, x->y, &fast);
        const double a = fixed_largest(x, r, x->f, &pushed);
        if (v > 0)
            h = fixed_shorter(x, h, 0.4 * H / v, fast, "velocity in (38)");
        if (a > 0)
            h = fixed_shorter(x, h, 0.25 * sqrt(H / a), pushed, "force in (38)");
    }
    return h;
}

const struct fixed_kind fixed_euler = {
    .method = FIXED_METHOD("euler-cfl", 1, "semi-implicit Euler of Toth (2012), order 1",
                           "Toth 2012, equations (34), (35), (38)"),
    .number = 0.25,
    .sides = ASK_EXPLICIT | ASK_IMPLICIT,
    .length = fixed_euler_length,
    .advance = fixed_euler_advance,
};
