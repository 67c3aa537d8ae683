/* particles.c -- the memory of struct particles: one block, taken once. */
#include "state/particles.h"

#include "base/status.h"
#include "state/particles-private.h"
#include <stdlib.h>
#include <string.h>

enum { ALIGNED = 16 }; /* every array starts as malloc() would start it [bytes] */

/* Hands out the next bytes of a block; with block NULL it only counts them. */
static void *take(char *block, size_t *used, size_t bytes)
{
    void *start = block ? block + *used : NULL;

    *used += (bytes + ALIGNED - 1) / ALIGNED * ALIGNED;
    return start;
}

/* What stays as it is created. */
static size_t place_fixed(struct particles *p, char *block)
{
    const size_t n = p->n;
    size_t used = 0;

    take(block, &used, sizeof *p);
    p->m = take(block, &used, n * sizeof *p->m);
    p->x0 = take(block, &used, n * sizeof *p->x0);
    p->object_of = take(block, &used, n * sizeof *p->object_of);
    p->object = take(block, &used, p->objects * sizeof *p->object);
    p->dye = take(block, &used, n * sizeof *p->dye);
    return used;
}

/* What moves; rows that are rearranged bring their own. */
static size_t place_moving(struct particles *p, char *block)
{
    const size_t n = p->n;
    size_t used = 0;

    p->x = take(block, &used, n * sizeof *p->x);
    p->u = take(block, &used, n * sizeof *p->u);
    return used;
}

static size_t place_objects(struct particles *p, char *block)
{
    size_t used = 0;

    take(block, &used, sizeof *p);
    p->object = take(block, &used, p->objects * sizeof *p->object);
    return used;
}

static int create(struct particles head, size_t (*place)(struct particles *p, char *block),
                  struct particles **out)
{
    char *block = status_alloc(place(&head, NULL), 1);

    *out = NULL;
    if (!block)
        return STATUS_FAILED;
    place(&head, block);
    *out = (struct particles *)block;
    **out = head;
    return STATUS_DONE;
}

int particles_create(int n, int objects, const struct scales *scales, struct particles **out)
{
    return create((struct particles){ .scales = scales, .n = n, .objects = objects },
                  place_fixed, out);
}

/* Most solids never move: where all is 0 already, nothing is written, and no memory is found for it. */
static void move(size_t bytes, const void *x, void *to)
{
    if (memcmp(to, x, bytes) != 0)
        memcpy(to, x, bytes);
}

/* Where solids stand at t = 0. */
static void stand(struct particles *p)
{
    static const double rest[DIM];

    for (int i = p->from[KIND_FLUID + 1]; i < p->n; i++) {
        memcpy(p->x[i], p->x0[i], sizeof *p->x0);
        move(sizeof rest, rest, p->u[i]);
    }
}

/* Positions of the fluid are y's: theirs are not touched, and take no memory. */
int particles_create_beside(const struct particles *of, struct particles **out)
{
    TRY(create(*of, place_objects, out));
    (*out)->own = status_alloc(place_moving(*out, NULL) + 1, 1);
    if (!(*out)->own) {
        particles_free(out);
        return STATUS_FAILED;
    }
    place_moving(*out, (*out)->own);
    memcpy((*out)->object, of->object, of->objects * sizeof *of->object);
    stand(*out);
    return STATUS_DONE;
}

void particles_follow(struct particles *p, const struct particles *of)
{
    p->m = of->m;
    p->x0 = of->x0;
    p->object_of = of->object_of;
    p->dye = of->dye;
    memcpy(p->id, of->id, sizeof p->id);
    memcpy(p->row, of->row, sizeof p->row);
    stand(p);
}

/* What moves with its row.  Places of the fluid are y's: none is kept of them, nor of where it was at t = 0. */
static size_t place_rows(struct particles *p, char *block)
{
    const size_t n = p->n;
    size_t used = 0;
    int *id, *row;

    p->m = take(block, &used, n * sizeof *p->m);
    p->x0 = take(block, &used, n * sizeof *p->x0);
    p->object_of = take(block, &used, n * sizeof *p->object_of);
    p->dye = take(block, &used, n * sizeof *p->dye);
    p->x = take(block, &used, n * sizeof *p->x);
    p->u = take(block, &used, n * sizeof *p->u);
    id = take(block, &used, n * sizeof *id);
    row = take(block, &used, n * sizeof *row);
    for (int k = 0; k < KINDS && block; k++) {
        p->id[k] = id + p->from[k];
        p->row[k] = row + p->from[k];
    }
    return used;
}

/* Rows of one kind, the first is `first`. */
static void move_rows(size_t bytes, int first, int n, const int *from, const void *old, void *to)
{
    const char *x = (const char *)old + first * bytes;
    char *y = (char *)to + first * bytes;

    for (int i = 0; i < n; i++)
        move(bytes, x + (from ? from[i] : i) * bytes, y + i * bytes);
}

static void move_kind(const struct particles *p, enum kind k, const int *from,
                      const struct particles *to)
{
    const int first = p->from[k], n = particles_count(p, k);

    move_rows(sizeof *p->m, first, n, from, p->m, to->m);
    move_rows(sizeof *p->object_of, first, n, from, p->object_of, to->object_of);
    move_rows(sizeof *p->dye, first, n, from, p->dye, to->dye);
    for (int i = 0; i < n; i++) {
        const int was = from ? from[i] : i;
        to->id[k][i] = p->id[k] ? p->id[k][was] : was;
        to->row[k][to->id[k][i]] = i;
    }
    if (k == KIND_FLUID)
        return;
    move_rows(sizeof *p->x0, first, n, from, p->x0, to->x0);
    move_rows(sizeof *p->x, first, n, from, p->x, to->x);
    move_rows(sizeof *p->u, first, n, from, p->u, to->u);
}

/* --- rows that change places in pairs ------------------------------------------------------- */

static bool in_pairs(const struct particles *p, const int *const from[KINDS])
{
    bool all = true;

    for (int k = 0; k < KINDS; k++)
        for (int i = 0; from[k] && i < particles_count(p, k); i++)
            all &= from[k][from[k][i]] == i;
    return all;
}

static void swap_rows(size_t bytes, void *of, int i, int j)
{
    char *x = (char *)of + i * bytes, *y = (char *)of + j * bytes, was[DIM * sizeof(double)];

    memcpy(was, x, bytes);
    move(bytes, y, x);
    move(bytes, was, y);
}

/* Rows i and j, counted over all kinds. */
static void swap(struct particles *p, enum kind k, int i, int j)
{
    const int first = p->from[k];

    swap_rows(sizeof *p->m, p->m, i, j);
    swap_rows(sizeof *p->object_of, p->object_of, i, j);
    swap_rows(sizeof *p->dye, p->dye, i, j);
    swap_rows(sizeof *p->id[k], p->id[k], i - first, j - first);
    p->row[k][p->id[k][i - first]] = i - first;
    p->row[k][p->id[k][j - first]] = j - first;
    if (k == KIND_FLUID)
        return;
    swap_rows(sizeof *p->x0, p->x0, i, j);
    swap_rows(sizeof *p->x, p->x, i, j);
    swap_rows(sizeof *p->u, p->u, i, j);
}

static void swap_kind(struct particles *p, enum kind k, const int *from)
{
    const int first = p->from[k];

    for (int i = 0; from && i < particles_count(p, k); i++)
        if (from[i] > i)
            swap(p, k, first + i, first + from[i]);
}

/* Where rows are its own already, and change places in pairs, no other memory is needed. */
int particles_rearrange(struct particles *p, const int *const from[KINDS])
{
    struct particles to = *p;

    if (p->id[KIND_FLUID] && in_pairs(p, from)) {
        for (int k = 0; k < KINDS; k++)
            swap_kind(p, k, from[k]);
        return STATUS_DONE;
    }
    to.own = status_alloc(place_rows(&to, NULL) + 1, 1);
    if (!to.own)
        return STATUS_FAILED;
    place_rows(&to, to.own);
    for (int k = 0; k < KINDS; k++)
        move_kind(p, k, from[k], &to);
    free(p->own);
    *p = to;
    return STATUS_DONE;
}

void particles_free(struct particles **p)
{
    if (*p)
        free((*p)->own);
    free(*p);
    *p = NULL;
}
