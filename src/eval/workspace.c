/* workspace.c -- memory of an evaluation: records, sums. */
#include "eval/inside.h"

#include "base/status.h"
#include "ranks/ranks.h"
#include "space/record.h"

#include <stdlib.h>
#include <string.h>

double *workspace_lines(size_t numbers)
{
    const size_t bytes = (numbers * sizeof(double) + 63) / 64 * 64 + 64;
    double *to = aligned_alloc(64, bytes);

    if (to)
        memset(to, 0, bytes);
    else
        status_starved("%zu kB of work arrays cannot be had", bytes >> 10);
    return to;
}

/* Of solids that press by more than a density of their own. */
static int take_press(const struct plan *p, struct workspace *w)
{
    const size_t solids = (size_t)(p->particles->n - particles_count(p->particles, KIND_FLUID));

    w->p2 = status_alloc(solids + 1, sizeof *w->p2);
    w->pressed = status_alloc(solids + 1, DIM * sizeof *w->pressed);
    w->rows = status_alloc(solids + 1, sizeof *w->rows);
    if (!w->p2 || !w->pressed || !w->rows)
        return STATUS_FAILED;
    if (plan_ahead(p) > 0 && (!(w->mean = workspace_lines(solids))
                              || !(w->law = workspace_lines(solids))))
        return STATUS_FAILED;
    w->between = w->law && p->bodies > 0 ? w->law : w->p2;
    return p->passes.press->part->as.wall->press->work(p->passes.press->self, &w->press);
}

/* For so many places; what was there is gone, before there is more. */
static int take_places(struct workspace *w, size_t slots)
{
    free(w->record);
    free(w->f);
    free(w->drho);
    free(w->wet.seen);
    free(w->busy.of);
    w->busy.list = NULL;
    w->record = workspace_lines(slots * RECORD);
    w->f = workspace_lines(slots * DIM);
    w->drho = workspace_lines(slots);
    w->wet.seen = status_alloc(slots, sizeof *w->wet.seen);
    w->busy.of = status_alloc(slots + 64, 1);
    w->slots = w->record && w->f && w->drho && w->wet.seen && w->busy.of ? slots : 0;
    return w->slots > 0 ? STATUS_DONE : STATUS_FAILED;
}

/* Of pairs. */
static int take_sums(const struct plan *p, struct workspace *w)
{
    const size_t n = (size_t)p->particles->n;

    if (n == 0) /* a beam alone: no pairs */
        return STATUS_DONE;
    TRY(take_places(w, ranks_count() > 1 ? 1 : n + 1)); /* of many, a list tells how many a rank has */
    TRY(wet_create(p, &w->wet));
    w->power = workspace_lines((size_t)p->slots + 1);
    if (p->passes.press)
        TRY(take_press(p, w));
    if ((p->passes.fields > 0 || p->passes.press) && !(w->rho = status_alloc(n, sizeof *w->rho)))
        return STATUS_FAILED;
    if (p->passes.fields > 0 || p->passes.filters) {
        w->sum = (double (*)[PART_SUMS])workspace_lines(n * PART_SUMS);
        if (!w->sum)
            return STATUS_FAILED;
    }
    return w->power ? STATUS_DONE : STATUS_FAILED;
}

static int take_memory(const struct plan *p, struct workspace *w)
{
    const int n = particles_count(p->particles, KIND_FLUID);
    int points = 0;

    for (int i = 0; i < p->bodies; i++)
        points = p->body[i].points > points ? p->body[i].points : points;
    w->rates = status_alloc((size_t)plan_size(p) + 1, sizeof *w->rates);
    w->points = status_alloc((size_t)points + 1, sizeof *w->points);
    if (plan_ahead(p) > 0 && !(w->sourced = status_alloc((size_t)n + 1, sizeof *w->sourced)))
        return STATUS_FAILED;
    if (p->drifter && !(w->drift = status_alloc((size_t)n + 1, sizeof *w->drift)))
        return STATUS_FAILED;
    w->speeds = status_alloc((size_t)points + 1, sizeof *w->speeds);
    return w->rates && w->points && w->speeds ? take_sums(p, w) : STATUS_FAILED;
}

int workspace_create(const struct plan *p, struct workspace **out)
{
    struct workspace *w = *out = status_alloc(1, sizeof *w);
    int status;

    if (!w)
        return STATUS_FAILED;
    status = take_memory(p, w);
    if (status != STATUS_DONE)
        workspace_free(p, out);
    return status;
}

int workspace_fit(struct workspace *w, const struct list *l)
{
    const size_t want = (size_t)l->listed + 1;

    return want <= w->slots ? STATUS_DONE : take_places(w, want + want / 16);
}

/* Of `pressed` one number of each, until a pressure that looks ahead asks for forces. */
static double solids_written(const struct plan *p, const struct workspace *w)
{
    const double solids = p->particles->n - particles_count(p->particles, KIND_FLUID);
    const double wet = sizeof *w->wet.met + sizeof *w->wet.has + sizeof *w->wet.row + sizeof *w->wet.other
                       + sizeof *w->wet.f;
    const double press = sizeof *w->rho + sizeof *w->p2 + sizeof *w->rows
                         + (w->law ? DIM + 2 : 1) * sizeof *w->pressed;

    return solids * (wet + (p->passes.press ? press : 0));
}

double workspace_written(const struct plan *p, const struct workspace *w)
{
    const double place = (RECORD + DIM + 1) * sizeof *w->record + sizeof *w->wet.seen + sizeof *w->busy.of;
    double each = 0; /* of the fluid */

    each += p->passes.fields > 0 ? sizeof *w->rho : 0;
    each += w->drift ? sizeof *w->drift : 0;
    each += w->sourced ? sizeof *w->sourced : 0;
    return (double)w->slots * place + each * particles_count(p->particles, KIND_FLUID)
           + (w->sum ? p->particles->n * (double)sizeof *w->sum : 0) + solids_written(p, w);
}

void workspace_free(const struct plan *p, struct workspace **workspace)
{
    struct workspace *w = *workspace;

    if (!w)
        return;
    free(w->record);
    free(w->busy.of);
    free(w->f);
    free(w->drho);
    free(w->power);
    free(w->rho);
    free(w->p2);
    free(w->mean);
    free(w->law);
    free(w->pressed);
    wet_free(&w->wet);
    free(w->rows);
    if (w->press)
        p->passes.press->part->as.wall->press->work_free(&w->press);
    free(w->sum);
    free(w->drift);
    free(w->sourced);
    free(w->points);
    free(w->speeds);
    free(w->rates);
    free(w->scratch.power);
    free(w->scratch.cut);
    free(w->scratch.record);
    free(w);
    *workspace = NULL;
}
