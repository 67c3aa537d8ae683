/* share-halo.c -- what rows of the list of pairs need of other ranks.
 *
 * A list costs two Alltoalls of counts, one gather of a word, and two exchanges with partners: who
 * fails brings that along, and only then all are asked by themselves. */
#include "eval/share.h"

#include "base/status.h"
#include "ranks/ranks.h"

#include <math.h>
#include <stdlib.h>

/* Do numbers of this kind come from neighbours that have them in y?  Where solids press by more than
 * a density of their own, they read those of others than neighbours. */
bool share_comes(const struct moment *m, int kind)
{
    return kind == KIND_FLUID || (m->plan->row.density[kind] >= 0 && !m->plan->passes.press);
}

/* Marks rows that others own and that are neighbours of rows here. */
static void mark_needed(const struct moment *m, bool *needed)
{
    const struct moment_share *s = m->share;
    const struct list *l = m->own;

    for (int g = 0; g < l->groups; g++)
        for (int k = l->segment_from[g]; k < l->segment_from[g + 1]; k++) {
            const struct list_segment *of = &l->segment[k];
            for (int i = 0; share_comes(m, of->partner) && i < of->rows * l->lanes; i++) {
                const int j = list_place(of->j[i]);
                if (j < l->listed && !s->mine[l->order[j]])
                    needed[l->order[j]] = true;
            }
        }
}

/* What a rank asks another for. */
struct request {
    int rank, id;
};

/* The number of a particle among those of this rank, which are in order of ids. */
static int own_number(const struct moment *m, int id)
{
    const struct moment_share *s = m->share;
    const int *own = s->row + s->from[s->me][0];
    int low = 0, high = s->from[s->me][KINDS] - s->from[s->me][0] - 1;

    while (low < high) {
        const int middle = (low + high) / 2;
        if (particles_id_of(m->particles, own[middle]) < id)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* What all hear of a list: has a rank no memory for what it is asked, and how are entries of rows
 * shared? */
static int tell(struct moment *m, int status)
{
    struct {
        double entries, fails;
    } mine = { list_entries(m->own), status != STATUS_DONE }, all[m->share->ranks];
    double most = 0, sum = 0, fails = 0;

    for (int r = 0; r < m->share->ranks; r++)
        m->share->count[r] = 1;
    ranks_gather(m->share->count, sizeof mine, &mine, all);
    for (int r = 0; r < m->share->ranks; r++) {
        most = fmax(most, all[r].entries);
        sum += all[r].entries;
        fails += all[r].fails;
    }
    m->share->balance.now = sum > 0 ? most * m->share->ranks / sum : 1;
    return fails > 0 ? ranks_agree(status) : STATUS_DONE;
}

/* Owners hear who needs which of their rows, and so know what to send to whom. */
static int answer(struct moment *m, struct ranks_route *questions, const struct request *mine)
{
    struct moment_share *s = m->share;
    const int n = ranks_route_coming(questions);
    struct request *asked = status_alloc((size_t)n + 1, sizeof *asked);
    int *to = status_alloc((size_t)n + 1, sizeof *to), *row = status_alloc((size_t)n + 1, sizeof *row);
    int status = tell(m, asked && to && row ? STATUS_DONE : STATUS_FAILED);

    if (status == STATUS_DONE) {
        ranks_route_go(questions, sizeof *mine, mine, asked);
        for (int i = 0; i < n; i++) {
            to[i] = asked[i].rank;
            row[i] = own_number(m, asked[i].id);
        }
        ranks_route_free(&s->route);
        status = ranks_route_create(&s->route, STATUS_DONE, SHARE_HALO * sizeof(double), n, to, row);
    }
    free(asked);
    free(to);
    free(row);
    return status;
}

/* Asks for s->halo [n], sorted by owner. */
static int request(struct moment *m, int status, int n)
{
    struct moment_share *s = m->share;
    struct request *mine = status_alloc((size_t)n + 1, sizeof *mine);
    int *to = status_alloc((size_t)n + 1, sizeof *to), *row = status_alloc((size_t)n + 1, sizeof *row);
    struct ranks_route *questions = NULL;

    if (status == STATUS_DONE) { /* else the halo that stands is heard on */
        free(s->in);
        s->in = status_alloc((size_t)n + 1, SHARE_HALO * sizeof *s->in);
    }
    if (status == STATUS_DONE && !(mine && to && row && s->in))
        status = STATUS_FAILED;
    for (int i = 0; i < n && status == STATUS_DONE; i++) {
        mine[i] = (struct request){ s->me, particles_id_of(m->particles, s->halo[i]) };
        to[i] = s->owner[mine[i].id];
        row[i] = i;
    }
    status = ranks_route_create(&questions, status, sizeof *mine, n, to, row);
    if (status == STATUS_DONE)
        status = answer(m, questions, mine);
    ranks_route_free(&questions);
    free(mine);
    free(to);
    free(row);
    return status;
}

int share_halo(struct moment *m, int status)
{
    struct moment_share *s = m->share;
    bool *needed = status == STATUS_DONE ? status_alloc((size_t)s->n + 1, sizeof *needed) : NULL;
    int n = 0;

    if (status == STATUS_DONE && !needed)
        status = STATUS_FAILED;
    if (needed)
        mark_needed(m, needed);
    for (int r = 0; r < s->ranks && needed; r++)
        for (int i = s->from[r][0]; i < s->from[r][KINDS]; i++)
            if (needed[s->row[i]])
                s->halo[n++] = s->row[i];
    free(needed);
    return request(m, status, n);
}
