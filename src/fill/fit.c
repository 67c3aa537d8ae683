/* fit.c -- does the spacing fit the sides of boxes, and which one would. */
#include "fill/fit.h"

#include "base/status.h"
#include "shapes/shape-kind.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

struct sides {
    const struct fill_item *item;
    int items;
};

static const char *const side_name[] = { "width", DIM == 2 ? "height" : "depth", "height" };

static bool is_domain(const struct fill_item *item)
{
    return shape_kind(item->shape)->domain;
}

/* The side of an item along d that must fit [m]; 0: none. */
static double side_of(const struct fill_item *item, int d)
{
    if (!item->shape || !shape_kind(item->shape)->side
        || !(is_domain(item) || item->kind == KIND_FLUID))
        return 0;
    return shape_kind(item->shape)->side(item->shape, d);
}

/* The first side that dx does not fit: its item, axis in *d; NULL if all do. */
static const struct fill_item *find_misfit(const struct sides *s, double dx, int *d)
{
    long n;

    for (const struct fill_item *item = s->item; item < s->item + s->items; item++)
        for (*d = 0; *d < DIM; ++*d)
            if (!shape_rows_fit(side_of(item, *d), dx, &n))
                return item;
    return NULL;
}

static double shortest(const struct sides *s)
{
    double least = HUGE_VAL;

    for (int i = 0; i < s->items; i++)
        for (int d = 0; d < DIM; d++)
            if (side_of(&s->item[i], d) > 0)
                least = fmin(least, side_of(&s->item[i], d));
    return least;
}

/* The nearest spacing that fits every side: finer than dx for step 1, coarser
 * for step -1; 0 when there is none within a factor of two. */
static double nearest(const struct sides *s, double dx, int step)
{
    const double side = shortest(s), count = side / dx;
    const long first = step > 0 ? (long)floor(count) + 1 : (long)ceil(count) - 1;
    const long tries = 100000; /* enough for all real scenes, over in no time */
    int d;

    for (long n = first; n > 0 && labs(n - first) < tries; n += step) {
        if (n > 2 * count + 1 || 2 * n < count)
            return 0;
        if (!find_misfit(s, side / n, &d))
            return side / n;
    }
    return 0;
}

/* "0.1/33 = 0.0030303030303 m", of the side that did not fit. */
static void print_spacing(char *to, size_t room, double side, double dx)
{
    snprintf(to, room, "%.10g/%ld = %.12g m", side, lrint(side / dx), dx);
}

/* Where no spacing fits all sides, this side has to change: its length, down or up. */
static int refuse_lengths(const struct fill_item *item, int d, double dx)
{
    const double side = side_of(item, d), below = fmax(floor(side / dx), 1);

    return status_fail(STATUS_BAD_SCENE, "%s: %s.%s: %s %s of %.10g m is %.6g spacings of %.10g m"
                       " and must be a whole number of them; no spacing from %.4g m to %.4g m would"
                       " fit the sides of every fluid box and of the framed domain: make it %.10g m"
                       " or %.10g m long", item->where, item->group, item->name,
                       is_domain(item) ? "the domain's" : "its", side_name[d], side, side / dx, dx,
                       dx / 2, 2 * dx, below * dx, (below + 1) * dx);
}

static int refuse(const struct sides *s, const struct fill_item *item, int d, double dx)
{
    const double side = side_of(item, d);
    const double coarser = nearest(s, dx, -1), finer = nearest(s, dx, 1);
    char text[2][96] = { "", "" };

    if (!(coarser > 0) && !(finer > 0))
        return refuse_lengths(item, d, dx);
    if (coarser > 0)
        print_spacing(text[0], sizeof text[0], side, coarser);
    if (finer > 0)
        print_spacing(text[1], sizeof text[1], side, finer);
    return status_fail(STATUS_BAD_SCENE, "%s: %s.%s: %s %s of %.10g m is %.6g spacings of %.10g m"
                       " and must be a whole number of them; %s%s%s would fit the sides of every"
                       " fluid box and of the framed domain", item->where, item->group, item->name,
                       is_domain(item) ? "the domain's" : "its", side_name[d], side, side / dx, dx,
                       text[0], coarser > 0 && finer > 0 ? " or " : "", text[1]);
}

int fit_check(const struct fill_item *item, int items, double dx)
{
    const struct sides s = { item, items };
    int d;
    const struct fill_item *misfit = find_misfit(&s, dx, &d);

    return misfit ? refuse(&s, misfit, d, dx) : STATUS_DONE;
}
