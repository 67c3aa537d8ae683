/* sum-single.c -- laws on rows of neighbours in single precision. */
#include "plan/sum-single.h"

#include "effects/fused.h"
#include "space/gather.h"
#include "space/single-row.h"

#include <limits.h>
#include <string.h>

/* The groups at hand. */
struct walk {
    const struct list *list;
    const struct list_segment *next[2], *last[2]; /* that are still to come   */
    int nowhere[SINGLE_HALF];                     /* a row of dummies         */
};

/* Laws one after the other, each on all rows. */
static void laws_in_turn(const struct pairs_table *table, const struct side *a,
                         struct block *b, struct sum *sum)
{
    for (int i = 0; i < table->n; i++) {
        const struct pairs_work *w = &table->work[i];

        gather_kernel(w->needs, w->kernel, b);
        w->law(w->self, a, b, &sum[w->slot]);
    }
}

static void arrange(struct pairs_table *table, bool fuse)
{
    pairs_laws *const fused = fuse ? fused_laws(table) : NULL;

    table->laws = fused ? fused : laws_in_turn;
    table->straight = fuse ? fused_straight(table) : NULL;
}

/* Here and below structs are filled member by member where they stand: a copy of what was
 * just written in parts would wait for all of them. */
static void start(const struct list *list, int g, bool both, struct walk *w)
{
    w->list = list;
    for (int h = 0; h < 2; h++) {
        const bool has = h == 0 || both;

        w->next[h] = has ? list->segment + list->segment_from[g + h] : NULL;
        w->last[h] = has ? list->segment + list->segment_from[g + h + 1] : NULL;
    }
    for (int l = 0; l < SINGLE_HALF; l++)
        w->nowhere[l] = list_entry(list->listed);
}

static struct single_owners owners(const struct list *list, int g, bool both)
{
    return (struct single_owners){
        .first = { list->group_slot[g], both ? list->group_slot[g + 1] : list->listed },
        .end = list->start[list->group_kind[g] + 1], .dummy = list->listed,
    };
}

/* The partner whose rows come next, -1: there is none. */
static int partner_of(const struct walk *w)
{
    int partner = KINDS;

    for (int h = 0; h < 2; h++)
        if (w->next[h] < w->last[h] && w->next[h]->partner < partner)
            partner = w->next[h]->partner;
    return partner < KINDS ? partner : -1;
}

/* Where rows of that partner stand, and how many of each half; dummies where one has none. */
static void take(struct walk *w, int partner, struct single_places from[2], int *rows)
{
    for (int h = 0; h < 2; h++) {
        const bool has = w->next[h] < w->last[h] && w->next[h]->partner == partner;

        rows[h] = has ? w->next[h]->rows : 0;
        from[h].j = has ? w->next[h]->j : w->nowhere;
        from[h].step = has ? SINGLE_HALF : 0;
        w->next[h] += has;
    }
}

static int least(int a, int b)
{
    return a < b ? a : b;
}

/* How many rows come next that both halves have, or one, and dummies beside it; at most
 * `most`. */
static int come(const struct walk *w, struct single_places from[2], const int *rows, int most)
{
    for (int h = 0; h < 2; h++) {
        if (rows[h] > 0) {
            most = least(most, rows[h]);
        } else {
            from[h].j = w->nowhere;
            from[h].step = 0;
        }
    }
    return most;
}

/* n rows are done. */
static void leave(struct single_places from[2], int *rows, int n)
{
    for (int h = 0; h < 2; h++) {
        from[h].j += from[h].step * (size_t)n;
        rows[h] -= n;
    }
}

static bool left(const int *rows)
{
    return rows[0] > 0 || rows[1] > 0;
}

/* The next rows of both halves, at most as many as there is room for. */
static void fill(const struct walk *w, const struct single_records *all,
                 struct single_places from[2], int *rows, const struct single_side *own,
                 unsigned needs, struct block *b)
{
    b->n = 0;
    while (b->n < PAIRS_ROWS && left(rows)) {
        const int n = come(w, from, rows, PAIRS_ROWS - b->n);

        single_rows_fill(all, from, n, own, needs, b, b->n);
        b->n += n;
        leave(from, rows, n);
    }
}

_Static_assert(sizeof(struct sum) == (DIM + 1) * sizeof(lanes), "what ends of groups read");

static void groups(const struct sum_job *job, const float *record, int g, bool both, float *sum)
{
    const struct pairs_table *tables = job->table + (size_t)job->list->group_kind[g] * KINDS;
    const struct single_records all = { record, (real)single_count(job->list), (real)job->mass };
    const struct single_owners at = owners(job->list, g, both);
    struct sum *part = (struct sum *)sum;
    struct single_side own;
    struct pairs_source of;
    struct walk w;
    struct block b;

    start(job->list, g, both, &w);
    of.all = &all;
    of.own = &own;
    single_rows_side(&all, &at, &own);
    memset(part, 0, (size_t)job->slots * sizeof *part);
    for (int partner = partner_of(&w), rows[2]; partner >= 0; partner = partner_of(&w)) {
        const struct pairs_table *table = &tables[partner];

        take(&w, partner, of.from, rows);
        if (table->n == 0) /* the list also serves summed densities */
            continue;
        while (table->straight && left(rows)) {
            const int n = come(&w, of.from, rows, INT_MAX);

            table->straight(table, &of, n, part);
            leave(of.from, rows, n);
        }
        while (left(rows)) {
            fill(&w, &all, of.from, rows, &own, table->needs, &b);
            table->laws(table, &own.a, &b, part);
        }
    }
}

const struct sum_single LANE_NAME(sum_single) = { .arrange = arrange, .groups = groups };
