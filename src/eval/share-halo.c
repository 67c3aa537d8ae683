/* share-halo.c -- what rows of the list of pairs need of other ranks.
 *
 * Beside what makes the list (share-near.c), a halo costs two Alltoalls of counts, one gather of some
 * words, one of solids' ids, and two exchanges with partners: who fails brings that along, and only
 * then all are asked by themselves. */
#include "eval/share.h"

#include "base/status.h"
#include "ranks/ranks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool share_comes(const struct moment *m, int kind)
{
    return kind == KIND_FLUID || (m->plan->row.density[kind] >= 0 && !m->share->halo.any);
}

int share_reads(const struct moment *m, int kind)
{
    const struct plan_passes *passes = &m->plan->passes;
    unsigned fields = 0;

    for (int i = 0; i < passes->n; i++)
        fields |= passes->pass[i].neighbours;
    if (kind != KIND_FLUID)
        return share_comes(m, kind) && fields & PASS_SOLID_DENSITY ? 1 : 0;
    return (fields & PASS_POSITION ? DIM : 0) + (fields & PASS_VELOCITY ? DIM : 0)
           + (fields & PASS_DENSITY ? 1 : 0);
}

double moment_share_read(const struct moment *m)
{
    return m->share ? m->share->halo.leaving : 0;
}

/* Places whose particles others own: most entries of rows ask for one, and few are. */
static const bool *note_others(const struct moment *m)
{
    const struct list *l = m->own;
    bool *other = (bool *)m->share->all;

    for (int s = 0; s < l->listed; s++)
        other[s] = !m->share->mine[l->order[s]];
    other[l->listed] = false; /* the dummy */
    return other;
}

enum { ENTRIES = 4 }; /* that are asked together: lanes are whole times as many */

/* Rows that others own and that are neighbours of rows here, of which numbers come. */
static void mark_neighbours(const struct moment *m, const struct list_segment *of, const bool *other,
                            bool *needed)
{
    const struct list *l = m->own;
    const int *j = of->j, *end = j + (size_t)of->rows * (size_t)l->lanes;

    for (; j < end; j += ENTRIES) {
        if (!(other[list_place(j[0])] | other[list_place(j[1])] | other[list_place(j[2])]
              | other[list_place(j[3])]))
            continue;
        for (int i = 0; i < ENTRIES; i++)
            if (other[list_place(j[i])])
                needed[l->order[list_place(j[i])]] = true;
    }
}

/* Solids that press here by densities of others than themselves: of which ones?  False: of any. */
static bool mark_pressing(struct moment *m, bool *needed)
{
    const struct plan_part *wall = m->plan->passes.press;
    const int first = m->particles->from[KIND_WALL], n = m->share->n - first;
    bool *read = (bool *)m->share->pack, some;

    memset(read, 0, (size_t)n * sizeof *read);
    press_narrow(m);
    some = wall->part->as.wall->press->reads(wall->self, m->work->press, read);
    for (const bool *at = read; some && (at = memchr(at, true, (size_t)(read + n - at))); at++) {
        const int row = particles_row_of(m->particles, first + (int)(at - read));
        needed[row] |= !m->share->mine[row];
    }
    return some;
}

/* Marks rows that others own and whose numbers are read here. */
static void mark_needed(struct moment *m, bool *needed)
{
    const bool press = m->plan->passes.press != NULL;
    const struct list *l = m->own;
    const bool *other = note_others(m);

    drift_mark(l, other);
    m->share->halo.any = press && !mark_pressing(m, needed);
    for (int g = 0; g < l->groups; g++) {
        const int end = drift_near_group(l, g) ? l->segment_from[g + 1] : l->segment_from[g];
        for (int k = l->segment_from[g]; k < end; k++) {
            const int kind = l->segment[k].partner;
            if (kind == KIND_FLUID || (!press && share_comes(m, kind)))
                mark_neighbours(m, &l->segment[k], other, needed);
        }
    }
}

/* What a rank asks another for. */
struct request {
    int rank, id;
};

static int kind_of(const struct moment *m, int row)
{
    return m->particles->object[m->particles->object_of[row]].kind;
}

/* What all hear of a list: has a rank no memory for what it is asked, how are entries of rows
 * shared, and which solids have neighbours? */
static int tell(struct moment *m, int status)
{
    int *wet = (int *)m->share->pack, count[m->share->ranks];
    struct {
        double entries, fails;
        int wet;
    } mine = { list_entries(m->own), status != STATUS_DONE, share_wet(m, wet) }, all[m->share->ranks];
    double most = 0, sum = 0, fails = 0;

    for (int r = 0; r < m->share->ranks; r++)
        m->share->count[r] = 1;
    ranks_gather(m->share->count, sizeof mine, &mine, all);
    for (int r = 0; r < m->share->ranks; r++) {
        most = fmax(most, all[r].entries);
        sum += all[r].entries;
        fails += all[r].fails;
        count[r] = all[r].wet;
    }
    m->share->balance.now = sum > 0 ? most * m->share->ranks / sum : 1;
    if (fails > 0)
        return ranks_agree(status);
    share_hear_wet(m, count, wet);
    return STATUS_DONE;
}

/* Owners hear who needs which of their rows, and so know what to send to whom; from then on the
 * halo is what comes next. */
static int answer(struct moment *m, struct ranks_route *questions, const struct request *mine,
                  struct share_halo *next)
{
    struct moment_share *s = m->share;
    const int n = ranks_route_coming(questions);
    struct request *asked = status_alloc((size_t)n + 1, sizeof *asked);
    int *to = status_alloc((size_t)n + 1, sizeof *to), *row = status_alloc((size_t)n + 1, sizeof *row);
    int *units = status_alloc((size_t)n + 1, sizeof *units);
    int status;

    next->leaves = n;
    next->out = status_alloc((size_t)n + 1, sizeof *next->out);
    next->sent = status_alloc((size_t)n * SHARE_HALO + 1, sizeof *next->sent);
    status = tell(m, asked && to && row && units && next->out && next->sent ? STATUS_DONE : STATUS_FAILED);
    if (status == STATUS_DONE) {
        const struct share_halo was = s->halo;
        next->any = was.any;
        s->halo = *next;
        *next = was;
        s->halo.leaving = 0;
        ranks_route_go(questions, sizeof *mine, mine, asked);
        for (int i = 0, at = 0; i < n; i++) {
            const int k = kind_of(m, s->halo.out[i] = particles_row_of(m->particles, asked[i].id));
            to[i] = asked[i].rank;
            row[i] = at;
            at += units[i] = share_width(k);
            s->halo.leaving += share_reads(m, k);
        }
        ranks_route_free(&s->route);
        status = ranks_route_create_uneven(&s->route, STATUS_DONE, sizeof *s->halo.sent, n, to, row, units);
    }
    free(asked);
    free(to);
    free(row);
    free(units);
    return status;
}

/* Asks owners for rows that are to come. */
static int request(struct moment *m, int status, struct share_halo *next)
{
    struct moment_share *s = m->share;
    const int n = next->n;
    struct request *mine = status_alloc((size_t)n + 1, sizeof *mine);
    int *to = status_alloc((size_t)n + 1, sizeof *to), *row = status_alloc((size_t)n + 1, sizeof *row);
    struct ranks_route *questions = NULL;

    if (status == STATUS_DONE && !(mine && to && row))
        status = STATUS_FAILED;
    for (int i = 0; i < n && status == STATUS_DONE; i++) {
        mine[i] = (struct request){ s->me, particles_id_of(m->particles, next->row[i]) };
        to[i] = s->owner[mine[i].id];
        row[i] = i;
    }
    status = ranks_route_create(&questions, status, sizeof *mine, n, to, row);
    if (status == STATUS_DONE)
        status = answer(m, questions, mine, next);
    ranks_route_free(&questions);
    free(mine);
    free(to);
    free(row);
    return status;
}

/* Rows that are needed, by owner, and room for what comes of them. */
static int collect(const struct moment *m, const bool *needed, struct share_halo *next)
{
    const struct moment_share *s = m->share;
    size_t numbers = 0, all = 0;

    for (int k = 0; k < KINDS; k++) {
        size_t n = 0;
        for (int i = m->particles->from[k]; i < m->particles->from[k + 1]; i++)
            n += needed[i];
        all += n;
        numbers += n * (size_t)share_width(k);
    }
    next->row = status_alloc(all + 1, sizeof *next->row);
    next->in = status_alloc(numbers + 1, sizeof *next->in);
    if (!next->row || !next->in)
        return STATUS_FAILED;
    for (int r = 0; r < s->ranks; r++)
        for (int i = s->from[r][0]; r != s->me && i < s->from[r][KINDS]; i++)
            if (needed[s->row[i]])
                next->row[next->n++] = s->row[i];
    return STATUS_DONE;
}

void share_free_halo(struct share_halo *halo)
{
    free(halo->row);
    free(halo->in);
    free(halo->out);
    free(halo->sent);
}

int share_halo(struct moment *m, int status)
{
    bool *needed = status == STATUS_DONE ? status_alloc((size_t)m->share->n + 1, sizeof *needed) : NULL;
    struct share_halo next = { 0 };

    if (status == STATUS_DONE && !needed)
        status = STATUS_FAILED;
    if (needed) {
        mark_needed(m, needed);
        status = collect(m, needed, &next);
    }
    free(needed);
    status = request(m, status, &next);
    share_free_halo(&next);
    return status;
}
