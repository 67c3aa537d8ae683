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

/* What moves. */
static size_t place_moving(struct particles *p, char *block)
{
    const size_t n = p->n;
    size_t used = 0;

    take(block, &used, sizeof *p);
    p->x = take(block, &used, n * sizeof *p->x);
    p->u = take(block, &used, n * sizeof *p->u);
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

/* Positions of the fluid are y's: theirs are not touched, and take no memory. */
int particles_create_beside(const struct particles *of, struct particles **out)
{
    const int first = of->from[KIND_FLUID + 1];

    TRY(create(*of, place_moving, out));
    memcpy((*out)->object, of->object, of->objects * sizeof *of->object);
    memcpy((*out)->x + first, of->x0 + first, (of->n - first) * sizeof *of->x0);
    return STATUS_DONE;
}

void particles_free(struct particles **p)
{
    free(*p);
    *p = NULL;
}
