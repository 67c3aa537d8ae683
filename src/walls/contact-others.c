/* contact-others.c -- how much of the kernel around a particle of a solid other solids fill. */
#include "walls/contact-others.h"

#include "base/status.h"
#include "kernels/kernel.h"
#include "state/period.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- once --------------------------------------------------------------------------------- */

static int group_of(const struct part_places *at, const struct contact_mean *mean, int i)
{
    const struct particles *p = at->p;

    return at->solid[p->object_of[p->from[KIND_WALL] + mean->solid[i]]].group;
}

/* Groups that there are come one after the other, particles of each by id. */
static void sort(struct contact_others *o, const struct part_places *at,
                 const struct contact_mean *mean)
{
    int most = 0, n = 0;

    for (int i = 0; i < o->n; i++)
        most = group_of(at, mean, i) > most ? group_of(at, mean, i) : most;
    for (int g = 0; g <= most; g++) {
        o->from[o->groups] = n;
        for (int k = 0; k < o->n; k++)
            if (group_of(at, mean, mean->by_solid[k]) == g)
                o->member[n++] = mean->by_solid[k];
        o->groups += n > o->from[o->groups];
    }
    o->from[o->groups] = n;
    o->still = o->groups > 0 && group_of(at, mean, o->member[0]) == 0 ? o->from[1] : 0;
}

int contact_others_create(struct contact_others *o, const struct part_places *at,
                          const struct contact_mean *mean, const struct contact_share *share)
{
    *o = (struct contact_others){ .kernel = at->kernel, .scales = at->p->scales, .n = mean->n };
    o->from = status_alloc((unsigned long)at->p->objects + 2, sizeof *o->from);
    o->member = status_alloc((unsigned long)o->n + 1, sizeof *o->member);
    o->room = status_alloc((unsigned long)o->n + 1, sizeof *o->room);
    if (!o->from || !o->member || !o->room) {
        contact_others_free(o);
        return STATUS_FAILED;
    }
    for (int i = 0; i < o->n; i++)
        o->room[i] = o->scales->rho0 * share[mean->solid[i]].open;
    sort(o, at, mean);
    return STATUS_DONE;
}

void contact_others_free(struct contact_others *o)
{
    free(o->from);
    free(o->member);
    free(o->room);
    *o = (struct contact_others){ 0 };
}

int contact_others_work(const struct contact_others *o, struct contact_others_work *w)
{
    const unsigned long n = o->groups > 1 ? (unsigned long)o->n : 0;

    w->x = status_alloc(n + 1, sizeof *w->x);
    w->low = status_alloc((unsigned long)o->groups + 1, sizeof *w->low);
    w->high = status_alloc((unsigned long)o->groups + 1, sizeof *w->high);
    w->box = status_alloc(n / CONTACT_BLOCK + (unsigned long)o->groups + 1, sizeof *w->box);
    w->one = status_alloc(n + 1, sizeof *w->one);
    w->other = status_alloc(n + 1, sizeof *w->other);
    w->last = status_alloc(n + 1, sizeof *w->last);
    w->before = status_alloc(n + 1, sizeof *w->before);
    return w->x && w->low && w->high && w->box && w->one && w->other && w->last && w->before
               ? STATUS_DONE : STATUS_FAILED;
}

void contact_others_work_free(struct contact_others_work *w)
{
    free(w->x);
    free(w->low);
    free(w->high);
    free(w->box);
    free(w->one);
    free(w->other);
    free(w->last);
    free(w->before);
    *w = (struct contact_others_work){ 0 };
}

double contact_others_near(const struct contact_others *o, int i, double around, double *slope)
{
    const double h = CONTACT_SOFT, off = around / o->room[i] - 1, root = sqrt(off * off + h * h);

    *slope = -off / root;
    return o->room[i] * (sqrt(1 + h * h) - root);
}

/* --- pairs ---------------------------------------------------------------------------------- */

/* A search between two groups. */
struct search {
    const struct contact_others *o;
    const struct contact_others_work *w;
    contact_others_see *see;
    void *self;
    double low[DIM], high[DIM]; /* where both may be [m]                          */
    int axis, bins;             /* others are sorted along it; -1: along none     */
    double width;               /* of a bin [m]                                   */
};

static void empty(double *low, double *high)
{
    for (int d = 0; d < DIM; d++) {
        low[d] = HUGE_VAL;
        high[d] = -HUGE_VAL;
    }
}

/* A box becomes large enough for another one, or for a point: low = high. */
static void widen(double *low, double *high, const double *other_low, const double *other_high)
{
    for (int d = 0; d < DIM; d++) {
        low[d] = other_low[d] < low[d] ? other_low[d] : low[d];
        high[d] = other_high[d] > high[d] ? other_high[d] : high[d];
    }
}

/* Number of a group's first block: no two groups share one. */
static int block_of(const struct contact_others *o, int g)
{
    return o->from[g] / CONTACT_BLOCK + g;
}

static int block_end(const struct contact_others *o, int g, int from)
{
    return from + CONTACT_BLOCK < o->from[g + 1] ? from + CONTACT_BLOCK : o->from[g + 1];
}

void contact_others_place(const struct contact_others *o, struct contact_others_work *w)
{
    for (int g = w->placed > 0; g < o->groups; g++) {
        double (*box)[2][DIM] = w->box + block_of(o, g);
        empty(w->low[g], w->high[g]);
        for (int from = o->from[g]; from < o->from[g + 1]; from += CONTACT_BLOCK, box++) {
            empty(box[0][0], box[0][1]);
            for (int k = from; k < block_end(o, g, from); k++)
                widen(box[0][0], box[0][1], w->x[o->member[k]], w->x[o->member[k]]);
            widen(w->low[g], w->high[g], box[0][0], box[0][1]);
        }
    }
    w->placed = o->still;
}

/* The box in which groups a and b may be near each other; false: nowhere. */
static bool common(struct search *s, int a, int b)
{
    const double H = s->o->kernel->support;
    double longest = 0;

    s->axis = -1;
    for (int d = 0; d < DIM; d++) {
        s->low[d] = -HUGE_VAL;
        s->high[d] = HUGE_VAL;
        if (s->o->scales->period[d] > 0)
            continue;
        s->low[d] = fmax(s->w->low[a][d], s->w->low[b][d]) - H;
        s->high[d] = fmin(s->w->high[a][d], s->w->high[b][d]) + H;
        if (!(s->low[d] <= s->high[d]))
            return false;
        if (s->high[d] - s->low[d] > longest) {
            longest = s->high[d] - s->low[d];
            s->axis = d;
        }
    }
    s->bins = s->axis < 0 ? 1 : (int)fmin(fmax(floor(longest / H), 1), s->o->n);
    s->width = longest / s->bins;
    return true;
}

static bool overlaps(const struct search *s, const double *low, const double *high)
{
    bool some = true;

    for (int d = 0; d < DIM; d++)
        some = some && high[d] >= s->low[d] && low[d] <= s->high[d];
    return some;
}

static int collect(const struct search *s, int g, int *to)
{
    const struct contact_others *o = s->o;
    double (*box)[2][DIM] = s->w->box + block_of(o, g);
    int n = 0;

    for (int from = o->from[g]; from < o->from[g + 1]; from += CONTACT_BLOCK, box++) {
        if (!overlaps(s, box[0][0], box[0][1]))
            continue;
        for (int k = from; k < block_end(o, g, from); k++) {
            const double *x = s->w->x[o->member[k]];
            to[n] = o->member[k];
            n += overlaps(s, x, x);
        }
    }
    return n;
}

static int bin_of(const struct search *s, int i)
{
    if (s->axis < 0)
        return 0;
    return (int)fmin((s->w->x[i][s->axis] - s->low[s->axis]) / s->width, s->bins - 1);
}

static void see_pair(const struct search *s, int i, int j)
{
    double step[DIM], r2 = 0;

    for (int d = 0; d < DIM; d++) {
        step[d] = period_nearest(s->o->scales, d, s->w->x[j][d] - s->w->x[i][d]);
        r2 += step[d] * step[d];
    }
    if (r2 < s->o->kernel->support * s->o->kernel->support)
        s->see(s->self, i, j, sqrt(r2), step);
}

/* Each of the one side with those of the other in its bin and the two beside it; a bin is a
 * chain from its last number to its first. */
static void see_groups(const struct search *s, int a, int b)
{
    const struct contact_others_work *w = s->w;
    const int ones = collect(s, a, w->one), others = collect(s, b, w->other);

    for (int k = 0; k < s->bins; k++)
        w->last[k] = -1;
    for (int k = 0; k < others; k++) {
        const int bin = bin_of(s, w->other[k]);
        w->before[k] = w->last[bin];
        w->last[bin] = k;
    }
    for (int m = 0; m < ones; m++) {
        const int bin = bin_of(s, w->one[m]), end = bin + 1 < s->bins ? bin + 1 : bin;
        for (int c = bin > 0 ? bin - 1 : 0; c <= end; c++)
            for (int k = w->last[c]; k >= 0; k = w->before[k])
                see_pair(s, w->one[m], w->other[k]);
    }
}

void contact_others_visit(const struct contact_others *o, struct contact_others_work *w,
                          contact_others_see *see, void *self)
{
    struct search s = { .o = o, .w = w, .see = see, .self = self };

    if (o->groups < 2)
        return;
    for (int a = 0; a < o->groups; a++)
        for (int b = a + 1; b < o->groups; b++)
            if (common(&s, a, b))
                see_groups(&s, a, b);
}
