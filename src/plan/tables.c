/* tables.c -- which laws act between which kinds, in table order. */
#include "plan/inside.h"

#include "base/status.h"
#define LANES 2 /* only sizes without lanes are used here */
#include "space/pairs.h"

static int add_law(struct plan *p, const struct plan_part *part, int owner, int partner)
{
    struct pairs_table *t = &p->table[owner * KINDS + partner];

    if (!(part->part->acts[owner] & KIND_BIT(partner)))
        return STATUS_DONE;
    if (t->n == PAIRS_LAWS)
        return status_fail(STATUS_BAD_SCENE, "more than %d effects between particles", PAIRS_LAWS);
    t->work[t->n++] = (struct pairs_work){
        .law = part->part->choose ? part->part->choose(part->self) : part->part->pairs,
        .self = part->self,
        .kernel = p->kernel,
        .slot = part->slot,
    };
    t->needs |= part->part->rows;
    return STATUS_DONE;
}

int plan_tables_make(struct plan *p)
{
    p->table = status_alloc(KINDS * KINDS, sizeof *p->table);
    if (!p->table)
        return STATUS_FAILED;
    for (int i = 0; i < p->parts; i++)
        for (int a = 0; a < KINDS && p->part[i].slot >= 0; a++)
            for (int b = 0; b < KINDS; b++)
                TRY(add_law(p, &p->part[i], a, b));
    return STATUS_DONE;
}
