/* check-ranks.c -- memory of each rank, and messages of a right-hand side, counted in one. */
#include "run/check-ranks.h"

#include "base/status.h"
#include "eval/observe.h"
#include "implicit/release.h"
#include "plan/memory.h"
#include "ranks/ranks.h"
#include "ranks/traffic.h"
#include "run/ranks.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* What messages and cuts take in any case: without it 5.5 to 9 MB were missing on 3 ranks in 2D, and
 * -1 to 11 MB on 2 and 4 ranks in 3D (Open MPI 4.1 on one machine) [bytes]. */
static const double messages = 6e6;

/* Cuts and lists that are made later have other rows and entries: in 2D and 3D, on 2 to 8 ranks, rows of y took
 * 1.00 to 1.13 of what they take after the second cut, and what is told is to be right early and late. */
static const double later_rows = 1.05, later_lists = 1.03;

/* Of tables, columns and their names [bytes]. */
static const double tables = 7e4;

/* What a rank says of itself. */
struct rank {
    double pairs;                  /* entries of its list */
    double program, shared, list, sums; /* bytes */
    double spared;                 /* numbers of y that are others' alone */
    struct ranks_traffic sends;    /* for one right-hand side */
    double read;                   /* numbers that passes read of what it sends to partners */
    double near;                   /* particles of others that may be company of its own */
};

static struct ranks_traffic since(const struct ranks_traffic *was)
{
    const struct ranks_traffic now = ranks_traffic();

    return (struct ranks_traffic){
        .asked = now.asked - was->asked, .asked_bytes = now.asked_bytes - was->asked_bytes,
        .gathers = now.gathers - was->gathers,
        .gathered_bytes = now.gathered_bytes - was->gathered_bytes,
        .exchanges = now.exchanges - was->exchanges, .messages = now.messages - was->messages,
        .sent_bytes = now.sent_bytes - was->sent_bytes,
    };
}

/* Once a list stands. */
static void note(const struct run *r, struct rank *me)
{
    me->pairs = moment_pairs(r->moment);
    me->list = moment_list_bytes(r->moment);
    me->sums = moment_sums_bytes(r->moment);
    me->spared = moment_size(r->moment) - moment_numbers(r->moment);
    me->shared = moment_share_bytes(r->moment);
    me->near = moment_nears(r->moment);
}

/* The list is as it is; what a new one takes comes on top. */
static int ask_once(struct run *r, struct rank *me)
{
    double *ydot = status_alloc((size_t)plan_size(r->plan) + 1, sizeof *ydot);
    int status = ranks_agree(ydot ? STATUS_DONE : STATUS_FAILED);

    if (status == STATUS_DONE) {
        const struct ranks_traffic was = ranks_traffic();
        status = moment_eval(r->moment, ASK_ALL, 0, r->y, ydot);
        me->sends = since(&was);
        me->read = moment_share_read(r->moment);
    }
    free(ydot);
    return status;
}

/* What arrays have been written for stays theirs when own rows get fewer; a method's come afterwards. */
static void keep_most(struct rank *me, const struct rank *was)
{
    me->list = fmax(me->list, was->list);
    me->sums = fmax(me->sums, was->sums);
    me->shared = fmax(me->shared, was->shared);
    me->near = fmax(me->near, was->near);
}

/* By the first cut, which knows how many particles there are, and by the next, which knows their pairs. */
static int ask_twice(struct run *r, struct rank *me)
{
    struct rank first = *me;

    note(r, &first);
    TRY(run_ranks_balance(r));
    note(r, me);
    keep_most(me, &first);
    return ask_once(r, me);
}

/* While fluid is let go, where it is; else 0.  Pairs are those of own rows. */
static double before(const struct run *r, const struct rank *rank, const struct plan_memory *own)
{
    const double release = release_memory(r->plan);

    return release > 0 ? release + rank->program + messages + 8.0 * plan_size(r->plan) + own->particles
                             - own->idle - own->beside + own->lists / 2 + own->sums + moment_share_bytes_all(r->moment)
                       : 0;
}

/* What a rank takes memory for [bytes]. */
enum item { PROGRAM, STATE, LISTS, SUMS, PARTICLES, SHARED, OUTPUTS, ITEMS };
struct items {
    double of[ITEMS], all;
    double before; /* what it took before, if that is more; else 0 */
};

static const char *const item_names[ITEMS] = { "program, libraries and messages", "state and vectors like it",
                                               "pair list", "sums over pairs", "particles",
                                               "what ranks share, and with whom", "outputs" };

/* The first rank has them; of frames each has its part, and own fluid with that of others near it is company,
 * but where all rows are the first one's. */
static double outputs_of(const struct plan_memory *own, const struct rank *rank, bool packed, bool first)
{
    const double shared = own->frames + own->company, alone = first ? own->outputs - shared : 0;

    if (packed)
        return tables + alone + own->frames / ranks_count() + own->company + PLAN_COMPANY * rank->near;
    return tables + alone + (first ? shared : 0);
}

/* A second moment, to look through, has a list of all pairs, on the first rank and on each that looks at sums
 * over sums for itself, and works where the run does; where own rows are packed, it has the run's list. */
static bool has_all_pairs(const struct run *r, bool first)
{
    return !moment_is_packed(r->moment) && (first || observe_each(r->moment));
}

static void add_up(struct items *to)
{
    for (int i = 0; i < ITEMS; i++)
        to->all += to->of[i];
}

/* Vectors of a run, and of looks at it, in which a rank has rows of its own alone.  Where a method has all rows of
 * some, run->y has too. */
static int own_vectors(const struct run *r, int vectors, bool first, bool packed)
{
    const int own = r->method->room.own ? r->method->room.own(r->method, r->plan) : 0;

    if (own == vectors)
        return own + (first ? packed : 2);
    return packed ? own + 1 : 0;
}

/* The first rank has all of y to look at.  Solids of a run that has no list of all pairs are those in an order of
 * their own. */
static struct items items_of(const struct run *r, const struct rank *rank, double writing, double all)
{
    const int vectors = r->method->room.vectors(r->method, r->plan);
    const bool first = writing > 0, packed = moment_is_packed(r->moment), looks = has_all_pairs(r, first);
    struct plan_memory own, whole;
    struct items to;

    plan_memory(r->plan, rank->pairs, vectors, &own);
    plan_memory(r->plan, all, vectors, &whole);
    to = (struct items){ .of = {
        [PROGRAM] = rank->program + messages + writing, [STATE] = own.state,
        [LISTS] = later_lists * rank->list + (looks ? whole.lists / 2 : 0),
        [SUMS] = (looks ? whole : own).sums - own.records + rank->sums,
        [PARTICLES] = own.particles - own.idle - (looks ? 0 : own.beside),
        [SHARED] = rank->shared, [OUTPUTS] = outputs_of(&own, rank, packed, first),
    } };
    to.of[STATE] -= 8 * rank->spared * own_vectors(r, vectors, first, packed);
    if (packed)
        to.of[STATE] *= later_rows;
    else if (!first) /* has no rates to look at */
        to.of[STATE] -= 8.0 * plan_size(r->plan);
    add_up(&to);
    to.before = before(r, rank, &own);
    to.before = to.before > to.all ? to.before : 0;
    return to;
}

static double peak_of(const struct items *items)
{
    return fmax(items->all, items->before);
}

static void add_bytes(void *self, const void *array, size_t bytes)
{
    (void)array;
    *(double *)self += (double)bytes;
}

/* As a cut later in the run may give one rank what another has now, each item is told for itself. */
static void grow(struct items *most, const struct items *one)
{
    for (int i = 0; i < ITEMS; i++)
        most->of[i] = fmax(most->of[i], one->of[i]);
    most->all = fmax(most->all, one->all);
    most->before = fmax(most->before, one->before);
}

/* A small scene has hundredths. */
static void print_two(const char *what, double first, double others)
{
    const int digits = fmax(first, others) < 10 ? 2 : 1;

    printf("  %-32s %8.*f MB %8.*f MB\n", what, digits, first, digits, others);
}

/* Of the first rank, and the most of the others. */
static void print_items(const struct items *first, const struct items *others)
{
    printf("  %-32s %11s %11s\n", "", "the first", "others");
    for (int i = 0; i < ITEMS; i++)
        print_two(item_names[i], first->of[i] / 1e6, others->of[i] / 1e6);
    if (first->before > 0 || others->before > 0)
        print_two("while the start is solved for, all", peak_of(first) / 1e6, peak_of(others) / 1e6);
}

static void print_memory(const struct run *r, const struct rank *rank, int n, double writing)
{
    struct items first, others = { .all = 0 };
    double all = 0, most = 0, alike = 0;

    plan_show(r->plan, add_bytes, &alike);
    for (int i = 0; i < n; i++) {
        all += rank[i].pairs;
        most = fmax(most, rank[i].pairs);
    }
    first = items_of(r, &rank[0], writing, all);
    for (int i = 1; i < n; i++) {
        const struct items one = items_of(r, &rank[i], 0, all);
        grow(&others, &one);
    }
    printf("memory: about %.3g MB at its peak on the first rank, at most %.3g MB on others; %.3g MB "
           "of that are there once on each machine\n",
           peak_of(&first) / 1e6, peak_of(&others) / 1e6, alike / 1e6);
    print_items(&first, &others);
    if (all > 0)
        printf("sums over pairs: %.3g entries, the busiest rank has %.2f times the mean\n", all,
               most * n / all);
}

static void print_traffic(const struct rank *rank, int n)
{
    const struct ranks_traffic *first = &rank[0].sends;
    double letters = 0, sent = 0, gathered = 0, read = 0;

    for (int i = 0; i < n; i++) {
        letters = fmax(letters, rank[i].sends.messages);
        read = rank[i].sends.sent_bytes > sent ? rank[i].read : read;
        sent = fmax(sent, rank[i].sends.sent_bytes);
        gathered = fmax(gathered, rank[i].sends.gathered_bytes);
    }
    printf("a right-hand side, while a list stands, sends\n"
           "  %6.0f questions to all, of %.3g kB together\n"
           "  %6.0f times own rows to all, of at most %.3g kB a rank together\n"
           "  %6.0f messages to partners at most, of at most %.3g kB a rank together: %.0f numbers that "
           "passes read\n",
           first->asked, first->asked_bytes / 1e3, first->gathers, gathered / 1e3, letters, sent / 1e3,
           read);
}

int check_ranks_print(struct run *r, double program, double writing)
{
    const int n = ranks_count();
    struct rank me = { .program = program }, all[n];
    int count[n];

    TRY(ask_twice(r, &me));
    for (int i = 0; i < n; i++)
        count[i] = 1;
    ranks_gather(count, sizeof me, &me, all);
    printf("shared between %d ranks: %s\n", n,
           me.shared == 0 ? "nothing, as there is no fluid: each computes all"
           : moment_is_full(r->moment)
               ? "sums over pairs; each has all rows, and does the rest for itself"
           : moment_is_packed(r->moment)
               ? "sums over pairs and rows, of y, too; neighbours of others come"
               : "sums over pairs and rows; neighbours of others come");
    print_memory(r, all, n, writing);
    print_traffic(all, n);
    return STATUS_DONE;
}
