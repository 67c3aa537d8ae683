/* press.c -- solids that press by more than a density of their own. */
#include "eval/share.h"

#include "base/status.h"

#include <string.h>

/* Solids that fluid meets are those with fluid in the list, as long as it stands. */
void press_narrow(struct moment *m)
{
    const struct plan_part *wall = m->plan->passes.press;
    struct workspace *w = m->work;

    if (w->narrowed == m->list && w->narrowed_builds == m->list->builds)
        return;
    wet_mark(m);
    wall->part->as.wall->press->choose(wall->self, w->press, PART_SOLIDS_MET, w->wet.met);
    w->narrowed = m->list;
    w->narrowed_builds = m->list->builds;
}

/* This rank's own stay the same until there is another cut. */
static void choose_own(struct moment *m)
{
    const struct plan_part *wall = m->plan->passes.press;
    const int first = m->particles->from[KIND_WALL];
    struct moment_share *s = m->share;
    bool *own = (bool *)s->pack;

    if (s->wet.pressed)
        return;
    for (int id = first; id < s->n; id++)
        own[id - first] = s->owner[id] == s->me;
    wall->part->as.wall->press->choose(wall->self, m->work->press, PART_SOLIDS_OWN, own);
    s->wet.pressed = true;
}

/* From densities of rows of y to what is shown, which may be the same, and p/rho^2 (NULL: not wanted), all
 * [solids]. */
static void press(struct moment *m, const double *rho, double *shown, double *p2, enum part_solids which)
{
    const struct plan_part *wall = m->plan->passes.press;
    const struct part_pressed io = { .rho = rho, .shown = shown, .p2 = p2, .mean = m->work->mean,
                                     .which = which };

    wall->part->as.wall->press->press(wall->self, m->work->press, m->particles, &io);
}

/* Densities of all solids where they are one array already; NULL: they are several. */
static const double *one_array(const struct view *v)
{
    const int *from = v->p->from;
    const double *first = NULL;

    for (int k = KIND_WALL; k < KINDS; k++) {
        if (particles_count(v->p, k) == 0)
            continue;
        first = first ? first : v->rho[k]; /* kinds before have none: it is that of the first solid */
        if (v->rho[k] != first + (from[k] - from[KIND_WALL]))
            return NULL;
    }
    return first;
}

static void press_rows(struct moment *m, struct view *v, enum part_solids which)
{
    struct workspace *w = m->work;
    const int *from = v->p->from;
    const double *one = one_array(v);

    for (int k = KIND_WALL; k < KINDS; k++) {
        const int n = particles_count(v->p, k);
        if (n == 0)
            continue;
        if (!one)
            memcpy(w->rho + from[k], v->rho[k], (size_t)n * sizeof *w->rho);
        v->rho[k] = w->rho + from[k];
        v->p2[k] = w->p2 + (from[k] - from[KIND_WALL]);
    }
    press(m, one ? one : w->rho + from[KIND_WALL], w->rho + from[KIND_WALL], w->p2, which);
}

/* What solids show to who looks stands apart: forces go on with what they were found by.  This rank has
 * densities of all solids or, together, of its own. */
static void press_apart(struct moment *m, struct view *v, bool together)
{
    const int *from = v->p->from;

    for (int k = KIND_WALL; k < KINDS; k++) {
        double *rho = m->work->pressed + (from[k] - from[KIND_WALL]);
        if (particles_count(v->p, k) == 0)
            continue;
        if (together)
            share_gather(m->share, v->p, (enum kind)k, 1, v->rho[k], rho);
        else
            memcpy(rho, v->rho[k], (size_t)particles_count(v->p, k) * sizeof *rho);
        v->rho[k] = rho;
    }
    press(m, m->work->pressed, m->work->pressed, NULL, together ? PART_SOLIDS_OWN : PART_SOLIDS_ALL);
}

void moment_press(struct moment *m, struct view *v)
{
    if (m->plan->passes.press)
        press_apart(m, v, false);
}

void press_together(struct moment *m, struct view *v)
{
    if (!m->plan->passes.press)
        return;
    choose_own(m);
    press_apart(m, v, true);
}

/* Rates ask for solids that fluid meets, fields that are looked at for all. */
int passes_press(struct evaluation *e, const struct plan_field *of)
{
    (void)of;
    if (e->ask)
        press_narrow(e->m);
    /* Sums of others meet any. */
    press_rows(e->m, &e->view, !e->ask || moment_is_full(e->m) ? PART_SOLIDS_ALL : PART_SOLIDS_MET);
    return STATUS_DONE;
}

/* Rate of density of the solid with this id [kg/m^D/s]. */
static double rate_of(const struct moment *m, int id)
{
    const int place = m->list->slot[particles_row_of(m->particles, id)];

    return place < 0 ? 0 : m->work->drho[place];
}

/* Densities of rows of y, as they will be in the time looked ahead. */
static void lead(const struct evaluation *e, double *rho)
{
    const struct particles *p = e->m->particles;

    for (int id = p->from[KIND_WALL]; id < p->n; id++) {
        const enum kind k = p->object[p->object_of[id]].kind;
        const int row = particles_row_of(p, id);
        const double *now = e->y + layout_at(&e->m->layout, e->m->plan->row.density[k]);
        rho[row - p->from[KIND_WALL]] = now[row - p->from[k]]
                                        + e->job.ahead * rate_of(e->m, id);
    }
}

/* The law that gives solids their rates. */
static int slot_of(const struct plan *p)
{
    for (int i = 0; i < p->parts; i++)
        if ((p->part[i].part->provides & FIELD_DENSITY_RATE) && p->part[i].slot >= 0)
            return p->part[i].slot;
    return 0;
}

/* A pressure that depends on rates of other places than its own is not the sums' to look
 * ahead: what it changes of the power of solids is added here.  (Rates of solids are there as
 * soon as powers are: the laws between particles give both.) */
int passes_press_ahead(struct evaluation *e, const struct plan_field *of)
{
    const struct particles *p = e->m->particles;
    struct workspace *w = e->m->work;
    const int first = p->from[KIND_WALL], n = p->n - first;
    double *rho = w->pressed, *p2 = rho + n, power = 0;

    (void)of;
    if (e->job.ahead == 0 || e->job.table == e->m->plan->table.velocities)
        return STATUS_DONE;
    lead(e, rho);
    press(e->m, rho, rho, p2, moment_is_full(e->m) ? PART_SOLIDS_ALL : PART_SOLIDS_MET);
    for (int id = first; id < p->n; id++) {
        const int row = particles_row_of(p, id);
        power += (p2[row - first] - w->p2[row - first]) * p->m[row] * rate_of(e->m, id);
    }
    w->power[slot_of(e->m->plan)] += power;
    return STATUS_DONE;
}

void press_between(struct moment *m, const double *p2)
{
    const struct plan_part *wall = m->plan->passes.press;
    const struct particles *p = m->particles;
    struct workspace *w = m->work;
    struct wet_solids *wet = &w->wet;
    double (*f)[DIM] = (double (*)[DIM])w->pressed;
    const int n = wall->part->as.wall->press->meet(wall->self, w->press, p, p2, f, w->rows);

    for (int k = 0; k < n; k++) {
        const int i = w->rows[k];
        if (!wet_counts(m, p->from[KIND_WALL] + i))
            continue;
        wet->other[wet->others++] = p->from[KIND_WALL] + i;
        for (int d = 0; d < DIM; d++)
            wet->f[i][d] += f[i][d];
    }
}

int passes_meet(struct evaluation *e, const struct plan_field *of)
{
    (void)of;
    press_between(e->m, e->m->work->between);
    return STATUS_DONE;
}
