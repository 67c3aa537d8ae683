/* balance.c -- when ranks cut anew, and what then goes where. */
#include "eval/share.h"

#include "base/status.h"
#include "ranks/ranks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double tolerable = 1.1; /* imbalance */
static const double worth = 1.05;    /* more than a cut leaves, before the next; few particles
                                        cannot be shared any better           */
enum { TRIES = 3 };                  /* cuts, one after the other: what groups take that are in part
                                        another's is known of the cut before  */

/* Who owns what from now on, and the rows of y that go there. */
struct balance_move {
    int *owner;            /* [n] by id                                        */
    int *from;             /* [n] row i of a kind becomes what row from[i] was */
    int *place;            /* [n] where that row stands then                   */
    int *was, *now;        /* [n] rows that stay and move                      */
    int *to, *row;         /* [n] scratch: of routes                           */
    int *out, *in;         /* [n] rows that leave, that come, kind by kind     */
    double *weight;        /* [n] rows of pairs                                */
    struct vector_travel travel[KINDS];
};

struct balance balance_start(void)
{
    const char *wish = getenv("STIFFWATER_BALANCE");

    return (struct balance){ .every = !wish ? 0 : strcmp(wish, "never") == 0 ? -1 : atoi(wish),
                             .now = 1, .left = 1, .before = NAN, .after = NAN };
}

void balance_never(struct moment *m)
{
    if (m->share)
        m->share->balance.every = -1;
}

void balance_count(struct moment *m)
{
    if (m->share)
        m->share->balance.steps = 0;
}

struct balance balance_told(const struct moment *m)
{
    return m->share ? m->share->balance : (struct balance){ .before = NAN, .after = NAN };
}

void balance_free(struct balance_move **move)
{
    struct balance_move *b = *move;

    if (!b)
        return;
    for (int k = 0; k < KINDS; k++) {
        ranks_route_free(&b->travel[k].route);
        free(b->travel[k].room);
    }
    free(b->owner);
    free(b->from);
    free(b->place);
    free(b->was);
    free(b->now);
    free(b->to);
    free(b->row);
    free(b->out);
    free(b->in);
    free(b->weight);
    free(b);
    *move = NULL;
}

/* --- when ------------------------------------------------------------------------- */

/* Is there to be a cut after this step? */
static bool is_due(const struct moment *m)
{
    struct balance *b = &m->share->balance;

    if (b->tries > 0)
        return true;
    b->steps++;
    if (b->every < 0 || !m->own->stands || (b->every > 0 && b->steps % b->every != 0)
        || (b->every == 0 && b->builds == m->own->builds))
        return false;
    b->builds = m->own->builds;
    if (b->every == 0 && !(b->now > fmax(tolerable, worth * b->left)))
        return false;
    b->before = fmax(b->before, b->now); /* of a NAN and a number, the number */
    return true;
}

/* --- what goes where -------------------------------------------------------------- */

static int take_memory(const struct moment_share *s, struct balance_move **out)
{
    struct balance_move *b = *out = status_alloc(1, sizeof *b);
    const size_t n = (size_t)s->n + 1;

    if (!b)
        return STATUS_FAILED;
    b->owner = status_alloc(n, sizeof *b->owner);
    b->from = status_alloc(n, sizeof *b->from);
    b->place = status_alloc(n, sizeof *b->place);
    b->was = status_alloc(n, sizeof *b->was);
    b->now = status_alloc(n, sizeof *b->now);
    b->to = status_alloc(n, sizeof *b->to);
    b->row = status_alloc(n, sizeof *b->row);
    b->out = status_alloc(n, sizeof *b->out);
    b->in = status_alloc(n, sizeof *b->in);
    b->weight = status_alloc(n, sizeof *b->weight);
    return b->owner && b->from && b->place && b->was && b->now && b->to && b->row && b->out && b->in && b->weight ? STATUS_DONE : STATUS_FAILED;
}

/* Where rows of kind k stand afterwards, counted within it, and which move. */
static void plan_places(const struct moment *m, struct balance_move *b, int k)
{
    const int first = m->particles->from[k], n = particles_count(m->particles, k);
    const int mine = moment_rows_of(m, (enum kind)k);
    struct vector_travel *t = &b->travel[k];

    t->rows = own_exchange(m, k, b->owner, b->from + first);
    t->to = b->place + first;
    t->was = b->was + first;
    t->now = b->now + first;
    for (int i = 0; i < n; i++) {
        const int was = b->from[first + i];
        b->place[first + was] = i;
        if (i < t->rows && was < mine && was != i) {
            b->was[first + t->moving] = was;
            b->now[first + t->moving++] = i;
        }
    }
}

/* Rows of kind k, counted within it, that leave and that come: by rank, by id. */
static int plan_travel(const struct moment *m, struct balance_move *b, int k)
{
    const struct moment_share *s = m->share;
    const int first = m->particles->from[k];
    struct vector_travel *t = &b->travel[k];
    int *out = b->out + first, *in = b->in + first;

    plan_places(m, b, k);
    t->out = out;
    t->in = in;
    for (int r = 0; r < s->ranks; r++)
        for (int i = s->from[r][k]; i < s->from[r][k + 1]; i++) {
            const int row = s->row[i], to = b->owner[particles_id_of(m->particles, row)];
            if (r == s->me && to != r) {
                b->to[t->leaving] = to;
                out[t->leaving++] = row - first;
            } else if (r != s->me && to == s->me) {
                in[t->coming++] = b->place[row];
            }
        }
    t->room = status_alloc((size_t)t->coming + 1, DIM * sizeof *t->room);
    return ranks_route_create(&t->route, t->room ? STATUS_DONE : STATUS_FAILED, DIM * sizeof(double),
                              t->leaving, b->to, out);
}

static int find_travels(struct moment *m, long *moved)
{
    struct moment_share *s = m->share;

    TRY(ranks_agree(take_memory(s, &s->move)));
    TRY(balance_where(m, s->move->weight, s->move->owner, moved));
    for (int k = 0; k < KINDS && *moved > 0; k++)
        if (k == KIND_FLUID || m->plan->row.density[k] >= 0)
            TRY(plan_travel(m, s->move, k));
    return STATUS_DONE;
}

/* Was this the last cut for now? */
static void finish(struct balance *b, bool last)
{
    b->tries = last ? 0 : b->tries + 1;
    if (!last)
        return;
    b->cuts++;
    b->after = fmax(b->after, b->left);
}

bool balance_goes_on(const struct moment *m)
{
    return m->share && m->share->balance.tries > 0;
}

int balance_cut(struct moment *m, struct vector_rows row[MOMENT_ROWS], int *blocks)
{
    const struct vector_travel *travel[KINDS];
    struct moment_share *s = m->share;
    long moved;

    *blocks = 0;
    if (!s || !is_due(m))
        return STATUS_DONE;
    TRY(find_travels(m, &moved));
    s->balance.moved += moved;
    for (int k = 0; k < KINDS; k++)
        travel[k] = s->move->travel[k].route ? &s->move->travel[k] : NULL;
    if (moved > 0) {
        *blocks = moment_travels(m, travel, row);
        return STATUS_DONE;
    }
    balance_free(&s->move);
    if (s->balance.tries > 0)
        finish(&s->balance, true);
    return STATUS_DONE;
}

static void swap_places(double *x, double *y)
{
    double was[DIM];

    memcpy(was, x, sizeof was);
    memcpy(x, y, sizeof was);
    memcpy(y, was, sizeof was);
}

/* Places of fluid where the list was made go where their rows go. */
static int move_fluid(const struct moment *m)
{
    const struct vector_rows row = { .n = particles_count(m->particles, KIND_FLUID), .components = DIM,
                                     .travel = &m->share->move->travel[KIND_FLUID] };

    return row.travel->route ? vector_rows_move(1, &row, 1, &m->share->built) : STATUS_DONE;
}

/* Owners of the rows as they will be, and places of solids where the list was made. */
static void move_rows(const struct moment *m)
{
    const struct moment_share *s = m->share;
    const struct particles *p = m->particles;
    const struct balance_move *b = s->move;

    for (int k = 0; k < KINDS; k++)
        for (int i = p->from[k]; i < p->from[k + 1]; i++) {
            const int row = b->travel[k].route ? p->from[k] + b->from[i] : i;
            if (k != KIND_FLUID && !share_stands(m, k) && row > i) /* they change places in pairs */
                swap_places(s->built + (size_t)i * DIM, s->built + (size_t)row * DIM);
            s->mine[i] = b->owner[particles_id_of(p, row)] == s->me;
        }
}

/* The list by ids stays what it was, and has rows of other owners. */
int balance_carry_out(struct moment *m)
{
    struct moment_share *s = m->share;
    struct balance *b = &s->balance;
    const int *from[KINDS];
    struct cloud cloud;
    long builds;
    int status;

    for (int k = 0; k < KINDS; k++)
        from[k] = s->move->travel[k].route ? s->move->from + m->particles->from[k] : NULL;
    move_rows(m);
    status = move_fluid(m);
    if (status == STATUS_DONE)
        status = moment_rearrange(m, from);
    share_own(m, s->move->owner);
    balance_free(&s->move);
    TRY(ranks_agree(status));
    wet_forget(m);
    share_cloud(m, &cloud);
    builds = m->own->builds;
    TRY(share_make(m, &cloud, s->built));
    m->own->builds = builds;
    wet_forget(m);
    b->left = b->now;
    finish(b, b->left <= tolerable || b->tries == TRIES - 1);
    return STATUS_DONE;
}
