/* room.c -- tests of src/ranks on as many ranks as it is started on. */
#include "ranks/ranks.h"

#include "algebra/exact-sum.h"
#include "algebra/vector.h"
#include "alike.h"
#include "base/status.h"
#include "claims.h"
#include "waits.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TERMS = 3000, POINTS = 4000, DIMENSIONS = 3 };

/* --- what all know --------------------------------------------------------------------- */

/* From 10^-9 to 10^9, of either sign: a sum in another order has other bits. */
static double term(int i)
{
    return (claims_random((unsigned)i) - 0.5) * pow(10, 18 * claims_random((unsigned)i + TERMS) - 9);
}

/* Term i is on the rank that `where` says. */
static double sum_over_ranks(int (*where)(int i))
{
    struct exact_sum sum = { 0 };

    for (int i = 0; i < TERMS; i++) {
        const double x = term(i);
        if (where(i) == ranks_me())
            exact_sum_add(&sum, 1, &x);
    }
    exact_sum_share(1, (struct exact_sum *[]){ &sum });
    return exact_sum_value(&sum);
}

static int in_turn(int i)
{
    return i % ranks_count();
}

static int all_on_the_last(int i)
{
    (void)i;
    return ranks_count() - 1;
}

static int by_size(int i)
{
    return fabs(term(i)) < 1 ? 0 : ranks_count() - 1;
}

static void sums_have_no_order(void)
{
    double terms[TERMS], whole;
    struct exact_sum alone = { 0 };

    for (int i = 0; i < TERMS; i++)
        terms[i] = term(i);
    exact_sum_add(&alone, TERMS, terms);
    whole = exact_sum_value(&alone);
    claim(sum_over_ranks(in_turn) == whole, "a sum of %d terms is that of one rank: %a", TERMS, whole);
    claim(sum_over_ranks(all_on_the_last) == whole, "... when the last rank has all of them");
    claim(sum_over_ranks(by_size) == whole, "... when one has the small ones, another the large");
}

static bool two_at_once(void)
{
    const int me = ranks_me(), last = ranks_count() - 1;
    const double key[2] = { me, -me };
    const long order[2] = { 0, 0 };
    int said[2] = { 10 + me, 20 + me }, rank[2];

    ranks_firsts(2, key, order, said, sizeof *said, rank);
    return rank[0] == 0 && said[0] == 10 && rank[1] == last && said[1] == 20 + last;
}

/* Ranks bring the same key by twos, and the last has a lower order than the others. */
static void who_is_first_is_heard(void)
{
    const int me = ranks_me(), last = ranks_count() - 1;
    int said = 100 + me, none = 7;

    claim(ranks_first(me / 2, me == last ? -1 : 5, &said, sizeof said) == (last <= 1 ? last : 0)
          && said == 100 + (last <= 1 ? last : 0), "of the least keys the least order is heard");
    claim(two_at_once(), "... of two things at once, each for itself");
    claim(ranks_first(HUGE_VAL, 0, &none, sizeof none) == -1 && none == 7, "... and nobody, where all are silent");
}

static void all_get_all(void)
{
    const int me = ranks_me(), ranks = ranks_count();
    int count[64], mine[64], all[64 * 64], n = 0;
    bool good = true;

    for (int r = 0; r < ranks; r++)
        count[r] = r % 3; /* some have none */
    for (int i = 0; i < count[me]; i++)
        mine[i] = 10 * me + i;
    ranks_gather(count, sizeof *mine, mine, all);
    for (int r = 0; r < ranks; r++)
        for (int i = 0; i < count[r]; i++)
            good &= all[n++] == 10 * r + i;
    claim(good, "rows of all ranks stand in their order");
    for (int i = 0, r = 0, at = 0; i < n; i++) { /* only own ones are there before */
        while (i >= at + count[r])
            at += count[r++];
        all[i] = r == me ? 50 * me + i - at : -1;
    }
    ranks_gather(count, sizeof *mine, NULL, all);
    n = 0;
    for (int r = 0; r < ranks; r++)
        for (int i = 0; i < count[r]; i++)
            good &= all[n++] == 50 * r + i;
    claim(good, "... also where own rows are there already");
    for (int i = 0; i < n; i++)
        all[i] = -1;
    ranks_bring(count, sizeof *mine, mine, all);
    n = 0;
    for (int r = 0; r < ranks; r++)
        for (int i = 0; i < count[r]; i++)
            good &= all[n++] == (me == 0 ? 10 * r + i : -1);
    claim(good, "... or come to the first rank alone");
}

static void the_largest_is_known_to_all(void)
{
    const int me = ranks_me(), last = ranks_count() - 1;
    double x[2] = { me, -me };

    ranks_most(2, x);
    claim(x[0] == last && x[1] == 0, "the largest of two numbers each");
}

/* What a first step without a bound goes by: each rank has rates in its own entries alone, and the
 * last rank the largest. */
static void the_haste_of_all_is_known_to_all(void)
{
    enum { ENTRIES = 5 };
    double rate[ENTRIES] = { 0 }, weight[ENTRIES] = { 1, 1, 1, 2, 1 };
    const int me = ranks_me(), last = ranks_count() - 1;

    rate[me == last ? 3 : 1] = -1 - me;
    claim(vector_most(ENTRIES, rate, weight) == 2.0 * (1 + last), "the largest weighted rate");
    claim(vector_bad_anywhere(ENTRIES, rate, &(struct vector_own){ 0 }) == -1, "rates that are numbers on all ranks");
    if (me == last)
        rate[2] = INFINITY;
    claim(vector_bad_anywhere(ENTRIES, rate, &(struct vector_own){ 0 }) == 2, "a rate of one rank that is no number");
}

/* Ranks from `first` on bring a failure. */
static void the_lowest_that_fails_is_heard(int first)
{
    const int me = ranks_me(), count = ranks_count();
    char want[40] = "";
    int status = STATUS_DONE, agreed;

    status_forgive();
    if (me >= first)
        status = status_fail(me == first ? STATUS_IO : STATUS_FAILED, "rank %d has no disk", me);
    if (first < count)
        snprintf(want, sizeof want, "rank %d has no disk", first);
    agreed = ranks_agree(status);
    claim(agreed == (first < count ? STATUS_IO : STATUS_DONE)
          && strcmp(status_message(), want) == 0,
          "ranks from %d of %d on fail: status %d, \"%s\"", first, count, agreed, want);
    status_forgive();
}

static void a_refusal_without_a_message_is_agreed_on_too(void)
{
    const int status = ranks_agree(ranks_me() == ranks_count() - 1 ? STATUS_FAILED : STATUS_DONE);

    claim(status == STATUS_FAILED && status_message()[0] == '\0', "a status without a message");
}

/* Rank `fails` never comes to what the others ask within, or comes there (none: none does) with what it failed
 * at; afterwards all are still at the same question. */
static void a_failure_is_met_within_and_after(int fails, bool comes)
{
    const int me = ranks_me(), want = fails < ranks_count() ? STATUS_IO : STATUS_DONE;
    int status = STATUS_DONE, again;
    double most = me;

    status_forgive();
    if (me == fails)
        status = status_fail(STATUS_IO, "rank %d has no memory", me);
    for (int i = 0; i < 2 && (me != fails || comes) && (i == 0 || status == STATUS_DONE); i++)
        status = ranks_agree_within(status);
    status = ranks_agree_after(status);
    claim(status == want && (want == STATUS_DONE || strstr(status_message(), "has no memory")),
          "rank %d fails, %s: status %d, \"%s\"", fails, comes ? "within" : "before", status, status_message());
    status_forgive();
    again = ranks_agree_after(me == 0 ? status_fail(STATUS_FAILED, "another one") : STATUS_DONE);
    ranks_most(1, &most);
    claim(again == STATUS_FAILED && most == ranks_count() - 1, "afterwards: status %d, most %g", again, most);
    status_forgive();
}

/* --- cuts ------------------------------------------------------------------------------ */

/* A crowd in a corner: even boxes would share it badly. */
static void place(int i, double x[DIMENSIONS])
{
    for (int d = 0; d < DIMENSIONS; d++)
        x[d] = pow(claims_random((unsigned)(i * DIMENSIONS + d)), 2);
}

static double weight_of(int i)
{
    return 1 + i % 3;
}

/* The points of this rank, before they are cut. */
static struct ranks_cut *cut_points(int dim)
{
    double *x = calloc(POINTS, DIMENSIONS * sizeof *x), *weight = calloc(POINTS, sizeof *weight);
    struct ranks_cut *cut;
    int n = 0, status;

    for (int i = ranks_me(); i < POINTS; i += ranks_count(), n++) {
        double at[DIMENSIONS];
        place(i, at);
        memcpy(x + (size_t)n * dim, at, (size_t)dim * sizeof *x);
        weight[n] = weight_of(i);
    }
    status = ranks_cut_create(&cut, dim, n, x, weight);
    claim(status == STATUS_DONE, "%d points in %dD are cut", POINTS, dim);
    free(x);
    free(weight);
    return cut;
}

static void all_find_the_same_owners(const struct ranks_cut *cut)
{
    double same[2 * POINTS];
    bool good = true;

    for (int i = 0; i < POINTS; i++) {
        double x[DIMENSIONS];
        place(i, x);
        same[2 * i] = ranks_cut_owner(cut, x);
        same[2 * i + 1] = -same[2 * i];
        good &= same[2 * i] >= 0 && same[2 * i] < ranks_count();
    }
    ranks_most(2 * POINTS, same);
    for (int i = 0; i < POINTS; i++)
        good &= same[2 * i] == -same[2 * i + 1];
    claim(good, "each point has one owner, and all ranks name the same");
}

static void weights_are_shared_evenly(const struct ranks_cut *cut)
{
    double mine = 0, all = 0;

    for (int i = 0; i < POINTS; i++) {
        double x[DIMENSIONS];
        place(i, x);
        all += weight_of(i);
        mine += ranks_cut_owner(cut, x) == ranks_me() ? weight_of(i) : 0;
    }
    mine *= ranks_count() / all;
    ranks_most(1, &mine);
    claim(mine <= 1.10, "the heaviest rank has %.3f of the mean, at most 1.10", mine);
}

/* Ten columns: ranks that are no divisor of ten get parts of some. */
static void columns_are_shared_evenly(void)
{
    enum { COLUMNS = 10, N = 400 };
    double x[N][2], weight[N], mine = 0;
    struct ranks_cut *cut;
    int n = 0, status;

    for (int i = ranks_me(); i < N; i += ranks_count(), n++) {
        x[n][0] = i % COLUMNS;
        x[n][1] = i / COLUMNS;
        weight[n] = 1;
    }
    status = ranks_cut_create(&cut, 2, n, x[0], weight);
    for (int i = 0; i < N && status == STATUS_DONE; i++)
        mine += ranks_cut_owner(cut, (double[2]){ i % COLUMNS, i / COLUMNS }) == ranks_me();
    mine *= (double)ranks_count() / N;
    ranks_most(1, &mine);
    claim(status == STATUS_DONE && mine <= 1.02, "of a lattice the heaviest rank has %.3f of the mean, at most 1.02", mine);
    ranks_cut_free(&cut);
}

static double distance_outside(const double *x, const double *low, const double *high, int dim)
{
    double far = 0;

    for (int d = 0; d < dim; d++)
        far = fmax(far, fmax(low[d] - x[d], x[d] - high[d]));
    return far;
}

/* Whose points are in a box is near it. */
static void owners_in_a_box_are_near_it(const struct ranks_cut *cut, int dim)
{
    const double radius = 0.1;
    bool good = true;

    for (int k = 0; k < 50; k++) {
        double centre[DIMENSIONS], low[DIMENSIONS], high[DIMENSIONS], x[DIMENSIONS];
        int rank[64], n;

        place(POINTS + k, centre);
        for (int d = 0; d < dim; d++) {
            low[d] = centre[d] - radius;
            high[d] = centre[d] + radius;
        }
        n = ranks_cut_near(cut, low, high, rank);
        for (int i = 0; i < POINTS; i++) {
            int r = 0;
            place(i, x);
            if (distance_outside(x, low, high, dim) > 0)
                continue;
            while (r < n && rank[r] != ranks_cut_owner(cut, x))
                r++;
            good &= r < n;
        }
        for (int r = 1; r < n; r++)
            good &= rank[r] > rank[r - 1];
    }
    claim(good, "ranks near a box are all that have a point in it, ascending");
}

static void far_boxes_are_not_near(const struct ranks_cut *cut, int dim)
{
    const double low[DIMENSIONS] = { -9, -9, -9 }, high[DIMENSIONS] = { -8, -8, -8 };
    int rank[64], n = ranks_cut_near(cut, low, high, rank);

    (void)dim;
    claim(n == 1, "a box beyond a corner is near %d rank", n);
}

/* --- routes ---------------------------------------------------------------------------- */

struct record {
    int id;
    double x[DIMENSIONS];
};

static struct record record_of(int id)
{
    struct record r = { .id = id };

    place(id, r.x);
    return r;
}

static bool same_record(const struct record *a, int id)
{
    const struct record b = record_of(id);

    return a->id == id && memcmp(a->x, b.x, sizeof b.x) == 0;
}

/* Rank r sends id i, one of r's, to rank i % count, unless that is r. */
static bool goes(int from, int i, int to)
{
    return i % ranks_count() == to && to != from && i / ranks_count() % ranks_count() == from;
}

static void rows_arrive_in_order(void)
{
    struct record all[POINTS], in[POINTS];
    int to[POINTS], row[POINTS], n = 0, came = 0;
    struct ranks_route *route;
    bool good = true;

    for (int i = POINTS - 1; i >= 0; i--) { /* the order in which they are named counts */
        all[i] = record_of(i);
        for (int r = 0; r < ranks_count(); r++)
            if (goes(ranks_me(), i, r)) {
                to[n] = r;
                row[n++] = i;
            }
    }
    if (ranks_route_create(&route, STATUS_DONE, sizeof *all, n, to, row) != STATUS_DONE)
        n = -1;
    ranks_route_go(route, sizeof *all, all, in);
    for (int r = 0; r < ranks_count(); r++)
        for (int i = POINTS - 1; i >= 0; i--)
            if (goes(r, i, ranks_me()))
                good &= same_record(&in[came++], i);
    claim(n >= 0 && good && came == ranks_route_coming(route) && n == ranks_route_leaving(route),
          "rows arrive by rank, and of one rank in its order");
    ranks_route_free(&route);
}

/* Rows of one number and of three, to all others; those of a rank in the order in which it named them. */
static void rows_of_a_route_may_be_uneven(void)
{
    enum { ROWS = 5 };
    const int me = ranks_me(), ranks = ranks_count();
    double all[3 * ROWS], in[64 * 3 * ROWS];
    int to[64 * ROWS], row[64 * ROWS], units[64 * ROWS], n = 0, came = 0;
    struct ranks_route *route;
    bool good;

    for (int i = 0; i < 3 * ROWS; i++)
        all[i] = 100 * me + i;
    for (int i = ROWS - 1; i >= 0; i--)
        for (int r = 0; r < ranks; r++) {
            if (r == me || ranks > 64)
                continue;
            to[n] = r;
            row[n] = 3 * i;
            units[n++] = i % 2 ? 3 : 1;
        }
    good = ranks_route_create_uneven(&route, STATUS_DONE, sizeof *all, n, to, row, units) == STATUS_DONE;
    ranks_route_go(route, sizeof *all, all, in);
    for (int r = 0; r < ranks; r++)
        for (int i = ROWS - 1; i >= 0 && r != me; i--)
            for (int k = 0; k < (i % 2 ? 3 : 1); k++)
                good &= in[came++] == 100 * r + 3 * i + k;
    claim(good && came == ranks_route_coming(route) && came == ranks_route_leaving(route),
          "rows of a route may be of one number and of three");
    ranks_route_free(&route);
}

/* A number to all others, and back, both under way while all ask each other. */
static void routes_may_be_under_way_together(void)
{
    const int me = ranks_me(), ranks = ranks_count();
    double there[64], back[64], came[2][64], most = me;
    int to[64], row[64], n = 0;
    struct ranks_route *one, *other;
    bool good;

    for (int r = 0; r < ranks && r < 64; r++) {
        there[r] = 100 * me + r;
        back[r] = -there[r];
        if (r == me)
            continue;
        to[n] = r;
        row[n++] = r;
    }
    good = ranks_route_create(&one, STATUS_DONE, sizeof *there, n, to, row) == STATUS_DONE;
    good &= ranks_route_create(&other, STATUS_DONE, sizeof *back, n, to, row) == STATUS_DONE;
    ranks_route_begin(one, sizeof *there, there, came[0]);
    ranks_route_begin(other, sizeof *back, back, came[1]);
    ranks_most(1, &most);
    ranks_route_end(other);
    ranks_route_end(one);
    for (int r = 0, i = 0; r < ranks; r++) {
        if (r == me)
            continue;
        good &= came[0][i] == 100 * r + me && came[1][i] == -(100 * r + me);
        i++;
    }
    claim(good && most == ranks - 1, "two routes may be under way while all ask each other");
    ranks_route_free(&one);
    ranks_route_free(&other);
}

static void a_route_may_be_empty(void)
{
    struct ranks_route *route;
    const int status = ranks_route_create(&route, STATUS_DONE, sizeof(double), 0, NULL, NULL);
    double none = 7;

    ranks_route_go(route, sizeof none, &none, &none);
    claim(status == STATUS_DONE && ranks_route_coming(route) == 0 && none == 7
          && ranks_route_partners(route) == 0, "nothing goes where nothing is sent");
    ranks_route_free(&route);
}

static void a_route_fails_for_all(void)
{
    const int last = ranks_count() - 1, mine = ranks_me() == last
        ? status_fail(STATUS_IO, "the last has no room") : STATUS_DONE;
    struct ranks_route *route;
    const int status = ranks_route_create(&route, mine, sizeof(double), 0, NULL, NULL);

    claim(status == STATUS_IO && !route && strstr(status_message(), "the last has no room"),
          "a rank that cannot have a route is heard by all");
    status_clear();
}

/* Each rank names its points to all whose boxes they are near: who gets what is known here. */
static void halos_are_complete(const struct ranks_cut *cut, int dim)
{
    enum { MOST = 20 * POINTS };
    const double radius = 0.05;
    struct record *all = calloc(POINTS, sizeof *all), *in = calloc(MOST, sizeof *in);
    int *to = calloc(MOST, sizeof *to), *row = calloc(MOST, sizeof *row), n = 0, k = 0;
    struct ranks_route *route;
    bool good = true;

    for (int i = 0; i < POINTS; i++) {
        double low[DIMENSIONS], high[DIMENSIONS];
        int rank[64], near;

        all[i] = record_of(i);
        for (int d = 0; d < dim; d++) {
            low[d] = all[i].x[d] - radius;
            high[d] = all[i].x[d] + radius;
        }
        near = ranks_cut_owner(cut, all[i].x) == ranks_me() ? ranks_cut_near(cut, low, high, rank) : 0;
        for (int r = 0; r < near; r++)
            if (rank[r] != ranks_me()) {
                to[n] = rank[r];
                row[n++] = i;
            }
    }
    good &= ranks_route_create(&route, STATUS_DONE, sizeof *all, n, to, row) == STATUS_DONE;
    ranks_route_go(route, sizeof *all, all, in);
    for (int r = 0; r < ranks_count(); r++)
        for (int i = 0; i < POINTS; i++) {
            double low[DIMENSIONS], high[DIMENSIONS];
            int rank[64], near, at = 0;

            if (r == ranks_me() || ranks_cut_owner(cut, all[i].x) != r)
                continue;
            for (int d = 0; d < dim; d++) {
                low[d] = all[i].x[d] - radius;
                high[d] = all[i].x[d] + radius;
            }
            near = ranks_cut_near(cut, low, high, rank);
            while (at < near && rank[at] != ranks_me())
                at++;
            good &= at == near || same_record(&in[k++], i);
        }
    claim(good && k == ranks_route_coming(route), "a halo of %g m in %dD is complete", radius, dim);
    ranks_route_free(&route);
    free(all);
    free(in);
    free(to);
    free(row);
}

static void try_cuts(int dim)
{
    struct ranks_cut *cut = cut_points(dim);

    all_find_the_same_owners(cut);
    weights_are_shared_evenly(cut);
    owners_in_a_box_are_near_it(cut, dim);
    far_boxes_are_not_near(cut, dim);
    halos_are_complete(cut, dim);
    ranks_cut_free(&cut);
}

int main(int argc, char **argv)
{
    int status = ranks_begin(&argc, &argv);

    claim(status == STATUS_DONE && argc == 2 && ranks_count() == atoi(argv[1])
          && ranks_me() >= 0 && ranks_me() < ranks_count(), "they are as many as were asked for");
    sums_have_no_order();
    the_largest_is_known_to_all();
    the_haste_of_all_is_known_to_all();
    who_is_first_is_heard();
    all_get_all();
    for (int first = 0; first <= ranks_count(); first++)
        the_lowest_that_fails_is_heard(first);
    a_refusal_without_a_message_is_agreed_on_too();
    for (int fails = 0; fails <= ranks_count(); fails++)
        for (int comes = 0; comes < 2; comes++)
            a_failure_is_met_within_and_after(fails, comes);
    rows_arrive_in_order();
    rows_of_a_route_may_be_uneven();
    routes_may_be_under_way_together();
    a_route_may_be_empty();
    a_route_fails_for_all();
    try_cuts(2);
    try_cuts(3);
    columns_are_shared_evenly();
    alike_claims();
    waits_claims();
    status = claims_end();
    ranks_end();
    return status;
}
