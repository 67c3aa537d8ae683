/* contacts-table.c -- which pairs may touch, and where each of them remembers. */
#include "bodies/contacts-table.h"

#include "base/status.h"

#include <math.h>

/* Numbers that xi of all pairs may have; with more than the first, bodies have seats. */
enum { ENOUGH_NUMBERS = 200000, MOST_NUMBERS = 2000000 };

/* For each body, each of them for two.  In the plane, bodies that touch are at most three times as
 * many pairs as they are bodies (a planar graph); cubes in a heap about as many in space. */
enum { SEATS = DIM == 2 ? 5 : 8 };

/* Does solid i, of a body, feel that solid? */
static bool meets(const struct contacts *c, int i, int solid)
{
    if (c->part_of[solid] == c->part_of[i])
        return false;
    return c->part_of[solid] < c->bodies + c->walls
           || (c->solid[i].stops & c->solid[solid].stops) != 0;
}

struct contacts_rub contacts_table_rub(const struct contacts *c, const struct contacts_scene *s,
                                       int part, int solid)
{
    return contacts_rules_of(s, contacts_rules_path(s, part),
                             contacts_rules_path(s, c->part_of[solid]));
}

static void add_pair(struct contacts *c, const struct contacts_scene *s, int i, int j)
{
    struct contacts_pair *p = &c->pair[c->pairs];
    const struct contacts_rub rub = contacts_table_rub(c, s, c->part_of[i], j);

    contacts_pair_make(p, &c->solid[i], &c->solid[j], &rub, !c->scales.fluid);
    p->first = i;
    p->second = j;
    c->slow = fmin(c->slow, p->slow);
    if (c->always < 0 || p->always > c->pair[c->always].always)
        c->always = c->pairs;
    c->pair_of[(long)i * c->solids + j] = c->pairs++;
}

/* Each of them has one place or more. */
static long count_pairs(const struct contacts *c)
{
    long n = 0;

    for (int i = 0; i < c->movers; i++)
        for (int j = i + 1; j < c->solids; j++)
            n += meets(c, i, j);
    return n;
}

static int list_pairs(struct contacts *c, const struct contacts_scene *s)
{
    const size_t all = (size_t)c->movers * (size_t)c->solids + 1;
    const long pairs = count_pairs(c);

    if (pairs * DIM > MOST_NUMBERS)
        return status_fail(STATUS_BAD_SCENE, "%d convex parts of bodies and %d of walls and sides make %ld "
                           "pairs that may touch, and at most %d are allowed; use fewer bodies, or clumps "
                           "of fewer balls (a larger pitch)", c->movers, c->solids - c->movers, pairs,
                           MOST_NUMBERS / DIM);
    c->pair = status_alloc((size_t)pairs + 1, sizeof *c->pair);
    c->pair_of = status_alloc(all, sizeof *c->pair_of);
    if (!c->pair || !c->pair_of)
        return STATUS_FAILED;
    c->always = -1;
    c->slow = HUGE_VAL;
    for (int i = 0; i < c->movers; i++) {
        c->most.around = fmax(c->most.around, c->solid[i].around);
        c->most.film = fmax(c->most.film, c->solid[i].film);
        for (int j = 0; j < c->solids; j++) {
            c->pair_of[(long)i * c->solids + j] = -1;
            if (j > i && meets(c, i, j))
                add_pair(c, s, i, j);
        }
    }
    return STATUS_DONE;
}

/* Of pairs of bodies the largest; how many pairs there are. */
static int largest(const struct contacts *c, int *block)
{
    int n = 0;

    *block = 0;
    for (int i = 0; i < c->pairs; i++)
        if (c->pair[i].second < c->movers) {
            *block = c->pair[i].places > *block ? c->pair[i].places : *block;
            n++;
        }
    return n;
}

/* Each pair has places of its own; where that is too much, those of bodies have seats. */
static int place_pairs(struct contacts *c)
{
    int block, pairs = largest(c, &block);
    long all = 0;

    for (int i = 0; i < c->pairs; i++)
        all += c->pair[i].places;
    const bool seated = all * DIM > ENOUGH_NUMBERS;
    for (int i = 0; i < c->pairs; i++) {
        const bool sits = seated && c->pair[i].second < c->movers;
        c->pair[i].from = sits ? -1 : c->places;
        c->places += sits ? 0 : c->pair[i].places;
    }
    if (!seated || pairs == 0)
        return STATUS_DONE;
    c->seats.n = pairs < SEATS * c->movers ? pairs : SEATS * c->movers;
    c->seats.block = block;
    c->seats.from = c->places;
    c->places += (long)c->seats.n * block;
    c->seats.first = status_alloc((size_t)c->seats.n, sizeof *c->seats.first);
    return c->seats.first ? STATUS_DONE : STATUS_FAILED;
}

int contacts_table_make(struct contacts *c, const struct contacts_scene *s)
{
    TRY(list_pairs(c, s));
    return place_pairs(c);
}

int contacts_table_check(const struct contacts *c)
{
    if (c->places * DIM > MOST_NUMBERS)
        return status_fail(STATUS_BAD_SCENE, "bodies and walls may touch at %ld places, each of which "
                           "remembers how far it is bent: %ld numbers, and at most %d are allowed, "
                           "though of all pairs of bodies only %d for each body are counted; use "
                           "fewer bodies, or bodies with fewer corners and edges: discs and spheres "
                           "have one place for each pair", c->places, c->places * DIM, MOST_NUMBERS,
                           SEATS);
    return STATUS_DONE;
}
