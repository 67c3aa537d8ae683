/* ranks.c -- what differs when several processes share a run. */
#include "run/ranks.h"

#include "base/status.h"
#include "eval/balance.h"
#include "plan/solver.h"
#include "ranks/ranks.h"
#include "run/stop.h"

#include <stdio.h>
#include <string.h>

/* Methods that add up over y for themselves, or by a library that knows no ranks. */
static const char *const adding[] = { "bdf", "dv", "gsl-msadams", "pcisph" };

enum moment_rows run_ranks_rows(const struct run *r)
{
    for (size_t i = 0; i < sizeof adding / sizeof *adding; i++)
        if (strcmp(r->method->name, adding[i]) == 0)
            return MOMENT_ALL;
    if (r->def.norm != VECTOR_NORM_MAX)
        return MOMENT_ALL;
    return plan_solved(r->method->name) ? MOMENT_RATES : MOMENT_OWN;
}

/* A pressure that is solved for is found by each rank for itself, from all of y. */
void run_ranks_begin(struct run *r)
{
    if (ranks_count() > 1 && (plan_solved(r->method->name) || !r->method->rearrange))
        balance_never(r->moment);
}

static int move(struct run *r, int blocks, const struct vector_rows *row)
{
    return r->self ? r->method->rearrange(r->self, blocks, row) : vector_rows_move(blocks, row, 1, &r->y);
}

int run_ranks_balance(struct run *r)
{
    struct vector_rows row[MOMENT_ROWS];
    int blocks;

    do {
        TRY(balance_cut(r->moment, row, &blocks));
        if (blocks == 0)
            return STATUS_DONE;
        TRY(ranks_agree(move(r, blocks, row)));
        TRY(balance_carry_out(r->moment));
    } while (balance_goes_on(r->moment));
    return STATUS_DONE;
}

bool run_ranks_writes(void)
{
    return ranks_me() == 0;
}

static const double met = 1000; /* a wish above all signals */

void run_ranks_wish(struct run *r)
{
    r->met.asks = !moment_wish(r->moment, r->met.status != STATUS_DONE ? met : stop_asked());
}

int run_ranks_stopped(const struct run *r)
{
    double most = stop_asked();

    if (!r->met.asks)
        return (int)moment_heard(r->moment);
    ranks_most(1, &most);
    return (int)most;
}

int run_ranks_met(struct run *r, int status)
{
    if (status == STATUS_DONE || r->met.asks)
        return status;
    if (r->met.status == STATUS_DONE) {
        r->met.status = status;
        snprintf(r->met.message, sizeof r->met.message, "%s", status_message());
    }
    status_forgive();
    return STATUS_DONE;
}

int run_ranks_agree(struct run *r, int status)
{
    if (r->met.status != STATUS_DONE) {
        status_forgive();
        status = status_fail(r->met.status, "%s", r->met.message);
    }
    return ranks_agree(status);
}

int run_ranks_heard(struct run *r, int status)
{
    if (r->met.asks)
        return ranks_agree(status);
    TRY(status);
    return moment_heard(r->moment) >= met ? run_ranks_agree(r, STATUS_DONE) : STATUS_DONE;
}
