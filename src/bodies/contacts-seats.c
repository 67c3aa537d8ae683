/* contacts-seats.c -- which pairs have a seat: given before they touch, taken back after. */
#include "bodies/contacts-seats.h"

#include "base/status.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Of the reach of the smaller one: nearer, a pair must have a seat; nearer, it gets one when any
 * pair must; farther, it gives its seat back.  What lies between the first two is how far
 * bodies move from one change of seats to the next. */
static const double must = 0.08, may = 0.4, leave = 0.6;

/* Of the scale of a bend: less is none. */
static const double unbent = 1e-6;

static double size_of(const struct contacts_pair *p)
{
    return fmin(p->a->around, p->b->around);
}

static const double *seats_of(const struct contacts *c, const struct layout *l, const double *y)
{
    return y + layout_at(l, c->seats.row);
}

/* Which pair has it, -1: none.  A whole number, but for the last bits of dense output. */
static int holder(const struct contacts *c, const double *seat, int k)
{
    const double number = seat[k];

    return number > 0.5 && number < c->pairs + 0.5 ? (int)lround(number) - 1 : -1;
}

void contacts_seats_open(const struct contacts *c, const struct contacts_moment *m)
{
    for (int k = 0; k < c->seats.n; k++) {
        const int pair = holder(c, seats_of(c, m->layout, m->y), k);
        if (pair >= 0)
            m->work->seat_of[pair] = k;
    }
}

void contacts_seats_close(const struct contacts *c, const struct contacts_moment *m)
{
    for (int k = 0; k < c->seats.n; k++) {
        const int pair = holder(c, seats_of(c, m->layout, m->y), k);
        if (pair >= 0)
            m->work->seat_of[pair] = -1;
    }
}

static long place_of(const struct contacts *c, int seat)
{
    return c->seats.from + (long)seat * c->seats.block;
}

long contacts_seats_at(const struct contacts *c, const struct contacts_work *w, int i)
{
    if (c->pair[i].from >= 0)
        return c->pair[i].from;
    return w->seat_of[i] >= 0 ? place_of(c, w->seat_of[i]) : -1;
}

/* Exact where it is less than `most`. */
static double gap_of(const struct contacts *c, const struct contacts_moment *m, int i, double most)
{
    const struct contacts_pair *p = &c->pair[i];
    struct solid_place at[2];
    const struct contacts_stand s = contacts_list_stand(
        c, contacts_near_of(c, m, p->first, &at[0]), contacts_near_of(c, m, p->second, &at[1]));

    return contacts_pair_gap(p, &s, most);
}

/* Is pair i without a seat and nearer than that share of its size? */
static bool wants(const struct contacts *c, const struct contacts_moment *m, int i, double share)
{
    const double most = share * size_of(&c->pair[i]);

    return contacts_seats_at(c, m->work, i) < 0 && gap_of(c, m, i, most) < most;
}

bool contacts_seats_lack(const struct contacts *c, const struct contacts_moment *m)
{
    bool lacks = false;

    if (c->seats.n == 0)
        return false;
    contacts_near_place(c, m);
    contacts_near_find(c, m, must * c->most.around);
    contacts_seats_open(c, m);
    for (int k = 0; k < m->work->near && !lacks; k++)
        lacks = wants(c, m, m->work->pair[k], must);
    contacts_seats_close(c, m);
    return lacks;
}

/* --- giving and taking -------------------------------------------------------------- */

static bool is_bent(const struct contacts *c, const double *xi)
{
    for (long i = 0; i < (long)c->seats.block * DIM; i++)
        if (fabs(xi[i]) > unbent * c->seats.scale)
            return true;
    return false;
}

static void take_back(const struct contacts *c, const struct contacts_moment *m, double share,
                      double *seat, double *xi)
{
    for (int k = 0; k < c->seats.n; k++) {
        const int pair = holder(c, seat, k);
        double *bend = xi + place_of(c, k) * DIM;
        const double most = pair < 0 ? 0 : share * size_of(&c->pair[pair]);
        if (pair < 0 || is_bent(c, bend) || gap_of(c, m, pair, most) < most)
            continue;
        seat[k] = 0;
        memset(bend, 0, (size_t)c->seats.block * DIM * sizeof *bend);
        m->work->seat_of[pair] = -1;
    }
}

/* How many found none. */
static int give(const struct contacts *c, const struct contacts_moment *m, double share, double *seat)
{
    int k = 0, without = 0;

    for (int i = 0; i < m->work->near; i++) {
        const int pair = m->work->pair[i];
        if (!wants(c, m, pair, share))
            continue;
        while (k < c->seats.n && holder(c, seat, k) >= 0)
            k++;
        if (k == c->seats.n) {
            without++;
            continue;
        }
        seat[k] = pair + 1;
        m->work->seat_of[pair] = k;
    }
    return without;
}

static int too_few(const struct contacts *c, int without, double t, char *text, size_t room)
{
    snprintf(text, room, "at t = %g s, %d pairs of bodies are about to touch, and there are %d "
             "seats, %d for each body, in which contacts remember how far they are bent; bodies "
             "of more even sizes have fewer neighbours", t, c->seats.n + without, c->seats.n,
             c->seats.n / c->movers);
    return STATUS_FAILED;
}

int contacts_seats_settle(const struct contacts *c, const struct contacts_moment *m, double *y,
                          char *text, size_t room)
{
    double *seat = y + layout_at(m->layout, c->seats.row), *xi = y + layout_at(m->layout, c->row);
    int without;

    contacts_near_place(c, m);
    contacts_near_find(c, m, may * c->most.around);
    contacts_seats_open(c, m);
    take_back(c, m, leave, seat, xi);
    without = give(c, m, must, seat);
    if (without > 0) {
        take_back(c, m, must, seat, xi);
        without = give(c, m, must, seat);
    }
    give(c, m, may, seat);
    contacts_seats_close(c, m);
    return without > 0 ? too_few(c, without, m->t, text, room) : STATUS_DONE;
}

/* Those that must have one come first, too. */
int contacts_seats_first(const struct contacts *c, double *seat)
{
    int n = 0, without = 0;

    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < c->pairs && c->seats.n > 0; i++) {
            const struct contacts_pair *p = &c->pair[i];
            const struct contacts_stand s = contacts_list_stand(c, &p->a->start, &p->b->start);
            const double size = size_of(p);
            const double gap = p->from < 0 ? contacts_pair_gap(p, &s, may * size) : HUGE_VAL;
            if (!(pass == 0 ? gap < must * size : gap >= must * size && gap < may * size))
                continue;
            if (n < c->seats.n)
                seat[n++] = i + 1;
            else
                without += pass == 0;
        }
    if (without == 0)
        return STATUS_DONE;
    return status_fail(STATUS_BAD_SCENE, "%d pairs of bodies nearly touch at t = 0, and contacts "
                       "have %d seats, %d for each body, in which they remember how far they are "
                       "bent; leave more room between bodies", c->seats.n + without, c->seats.n,
                       c->seats.n / c->movers);
}

/* --- in the order of pairs ---------------------------------------------------------- */

static void swap(double *a, double *b, long n)
{
    for (long i = 0; i < n; i++) {
        const double one = a[i];
        a[i] = b[i];
        b[i] = one;
    }
}

/* Of seats from k on, the one of the least pair; -1: all are free. */
static int least(const struct contacts *c, const double *seat, int k)
{
    int found = -1;

    for (; k < c->seats.n; k++)
        if (holder(c, seat, k) >= 0 && (found < 0 || seat[k] < seat[found]))
            found = k;
    return found;
}

/* How many are left. */
static int order(const struct contacts *c, double *seat, double *xi)
{
    const long block = (long)c->seats.block * DIM;
    int k = 0;

    for (int i = 0; i < c->seats.n; i++)
        if (!is_bent(c, xi + place_of(c, i) * DIM))
            seat[i] = 0;
    for (int from; (from = least(c, seat, k)) >= 0; k++) {
        swap(&seat[k], &seat[from], from != k);
        swap(xi + place_of(c, k) * DIM, xi + place_of(c, from) * DIM, from != k ? block : 0);
    }
    return k;
}

long contacts_seats_tidy(const struct contacts *c, const struct layout *l, double *y)
{
    const long size = layout_size(l);
    double *seat = y + layout_at(l, c->seats.row), *xi = y + layout_at(l, c->row), *to;
    int held;

    if (c->seats.n == 0)
        return size;
    held = order(c, seat, xi);
    to = xi + place_of(c, held) * DIM;
    memmove(to, seat, (size_t)held * sizeof *to);
    to += held;
    memmove(to, seat + c->seats.n, (size_t)(y + size - (seat + c->seats.n)) * sizeof *to);
    return (long)(to - y) + (long)(y + size - (seat + c->seats.n));
}
