/* rates.c -- an evaluation: the passes of the plan that a question asks for, in order. */
#include "eval/share.h"

#include "base/status.h"

/* The laws that answer. */
static const struct pairs_table *table_of(const struct plan *p, const struct ask *ask)
{
    if (ask->rates == ASK_DENSITIES)
        return p->table.densities;
    if (ask->rates == ASK_VELOCITIES)
        return p->table.velocities;
    if (ask->without_pressure)
        return p->table.without_pressure;
    if (ask->sides == ASK_IMPLICIT)
        return p->table.implicit;
    return ask->sides == ASK_EXPLICIT ? p->table.explicit : p->table.all;
}

/* As a bit of PASS_FOR_. */
static unsigned question_of(const struct ask *ask, const double *apart)
{
    if (ask->rates)
        return ask->rates == ASK_VELOCITIES ? PASS_FOR_VELOCITIES : PASS_FOR_DENSITIES;
    if (ask->without_pressure)
        return PASS_FOR_OTHERS;
    if (ask->sides == ASK_IMPLICIT)
        return PASS_FOR_IMPLICIT;
    return apart ? PASS_FOR_APART : PASS_FOR_RATES;
}

static int run(struct evaluation *e, unsigned question)
{
    const struct plan_passes *passes = &e->m->plan->passes;

    for (int i = 0; i < passes->n; i++)
        if (passes->pass[i].pass->asked & question)
            TRY(passes->pass[i].pass->run(e, passes->pass[i].of));
    return STATUS_DONE;
}

/* Rates of the classes first..last-1 of rows are not asked for. */
static void stand_still(const struct moment *m, int first, int last, double *ydot)
{
    const long *from = m->layout.from;

    moment_clear(m, from[first], from[last], ydot);
}

int rates_eval(struct moment *m, const struct ask *ask, double t, const double *y, double *ydot,
               double *apart, double *power)
{
    struct evaluation e = {
        .m = m, .ask = ask, .t = t, .y = y, .ydot = ydot, .power = power,
        .job = { .table = table_of(m->plan, ask), .ahead = ask->ahead, .apart = apart },
    };

    if (ask->sides != ASK_IMPLICIT)
        e.job.to = spread_places(m, ask, ydot);
    if (ask->rates == ASK_VELOCITIES)
        stand_still(m, LAYOUT_OTHER, LAYOUT_CLASSES, ydot);
    if (ask->rates == ASK_DENSITIES)
        stand_still(m, 0, LAYOUT_OTHER, ydot);
    TRY(run(&e, question_of(ask, apart)));
    if (ask->rates == ASK_VELOCITIES) /* loads give q' = v, too */
        stand_still(m, 0, LAYOUT_VELOCITY, ydot);
    if (m->share && !m->share->full)
        share_silence(m, ydot);
    return STATUS_DONE;
}

int rates_fields(struct moment *m, double t, const double *y, struct view *v)
{
    struct evaluation e = { .m = m, .t = t, .y = y };
    const int status = run(&e, PASS_FOR_FIELDS);

    *v = e.view;
    return status;
}
