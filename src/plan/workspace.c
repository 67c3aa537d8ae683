/* workspace.c -- memory of one evaluation: list, records, sums. */
#include "plan/inside.h"

#include "base/status.h"
#include "space/record.h"

#include <stdlib.h>
#include <string.h>

double *plan_lines(size_t numbers)
{
    const size_t bytes = (numbers * sizeof(double) + 63) / 64 * 64 + 64;
    double *to = aligned_alloc(64, bytes);

    if (to)
        memset(to, 0, bytes);
    else
        status_fail(STATUS_FAILED, "no memory for %zu MB of work arrays", bytes >> 20);
    return to;
}

int plan_workspace_make(struct plan *p, struct plan_workspace *w)
{
    const size_t n = p->particles->n;

    if (n == 0) /* a beam alone: no pairs */
        return STATUS_DONE;
    TRY(p->engine->sum->list->create(&w->list, &p->list_def));
    w->slots = n + 1;
    w->record = plan_lines(w->slots * RECORD);
    w->f = plan_lines(n * DIM);
    w->drho = plan_lines(n);
    w->power = plan_lines(p->slots + 1);
    if (p->fields > 0) {
        w->rho = plan_lines(n);
        w->sum = (double (*)[PART_SUMS])plan_lines(n * PART_SUMS);
        if (!w->rho || !w->sum)
            return STATUS_FAILED;
    }
    return w->record && w->f && w->drho && w->power ? STATUS_DONE : STATUS_FAILED;
}

/* The observer shares the run's records: both get those with more room. */
int plan_workspace_fit(struct plan *p, struct plan_workspace *w)
{
    const size_t want = (size_t)w->list->listed + 1, slots = want + want / 8;
    struct plan_workspace *const all[] = { &p->main, &p->observer, w };
    double *old = w->record, *record;

    if (want <= w->slots)
        return STATUS_DONE;
    if (!(record = plan_lines(slots * RECORD)))
        return STATUS_FAILED;
    for (int i = 0; i < 3; i++)
        if (all[i]->record == old) {
            all[i]->record = record;
            all[i]->slots = slots;
        }
    free(old);
    return STATUS_DONE;
}

void plan_workspace_free(struct plan *p, struct plan_workspace *w)
{
    p->engine->sum->list->free(&w->list);
    free(w->record);
    free(w->f);
    free(w->drho);
    free(w->power);
    free(w->rho);
    free(w->sum);
    free(w->scratch.power);
    *w = (struct plan_workspace){0};
}

int plan_observer_make(struct plan *p)
{
    p->observer = p->main;
    p->observer.list = NULL;
    p->observer.scratch = (struct sum_scratch){0};
    return p->engine->sum->list->create(&p->observer.list, &p->list_def);
}

void plan_observer_free(struct plan *p)
{
    p->engine->sum->list->free(&p->observer.list);
    free(p->observer.scratch.power);
    p->observer = (struct plan_workspace){0};
}
