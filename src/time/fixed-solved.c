/* fixed-solved.c -- what methods have in common whose pressure is solved for once a step, by
 * the contract of plan/solver.h. */
#include "time/fixed.h"

#include "plan/solver.h"
#include "ranks/ranks.h"

static const struct plan_solved *by(const struct fixed *x)
{
    return plan_solved(x->kind->method.name);
}

const char *fixed_solved_serves(const char *method, const struct plan *plan)
{
    const struct plan_solved *solved = plan_solved(method);

    return solved ? solved->serves(plan) : "there is no pressure that could be solved for";
}

int fixed_solved_take(struct fixed *x)
{
    return by(x)->create(x->moment, &x->own);
}

void fixed_solved_leave(struct fixed *x)
{
    by(x)->free(&x->own);
}

double fixed_solved_length(struct fixed *x)
{
    return by(x)->length(x->own, x->number, x->t, x->y, x->f, &x->limit);
}

/* Each of many ranks takes the whole step, and so needs the rates of all rows.  All refuse what one
 * refuses, as for want of memory. */
int fixed_solved_advance(struct fixed *x, double h)
{
    return ranks_agree(by(x)->step(x->own, x->t_old, h, x->y_old, moment_whole(x->moment, x->f_old),
                                   x->y, x->rates));
}
