/* pack-busy.c -- which records pairs read: those of fluid, of solids that something meets, and on many
 * ranks of own rows and the halo. */
#include "eval/pack.h"
#include "eval/share.h"

#include <string.h>

/* Do the solids of this kind tell which of them are read?  Those whom they meet must be in their rows. */
static bool tells(const struct list *l, int k)
{
    bool all = k != KIND_FLUID;

    for (int other = 0; other < KINDS; other++)
        if (l->def.acts[other] & KIND_BIT(k))
            all &= (l->def.acts[k] & KIND_BIT(other)) != 0;
    return all;
}

bool pack_spares(const struct moment *m, unsigned kinds)
{
    return kinds == KIND_BIT(KINDS) - 1 && !m->ahead && !m->solver && !m->face;
}

/* Own fluid, and the halo: what else the list has of others is not read.  Blocks without others ask none
 * of their rows where it is. */
static void note_fluid(const struct moment *m, unsigned char *of)
{
    const struct moment_share *s = m->share;
    const struct list *l = m->list;
    const int end = l->start[KIND_FLUID + 1];

    for (int from = 0; from < end; from += PACK_BLOCK) {
        int mine = 0, to = from + PACK_BLOCK < end ? from + PACK_BLOCK : end;
        for (int place = from; place < to; place++)
            mine += s->mine[l->order[place]];
        of[from / PACK_BLOCK] = mine == 0 ? PACK_IDLE : mine == to - from ? PACK_OWN : PACK_BUSY;
    }
    for (int i = 0; i < s->halo.n; i++)
        if (s->halo.row[i] < m->particles->from[KIND_FLUID + 1])
            of[l->slot[s->halo.row[i]] / PACK_BLOCK] = PACK_BUSY;
}

void pack_note(struct moment *m, const struct pack_chunks *c)
{
    struct workspace *w = m->work;
    const struct list *l = m->list;

    wet_mark(m);
    memset(w->busy.of, PACK_BUSY, (size_t)c->n * PACK_BLOCKS);
    if (moment_is_packed(m))
        note_fluid(m, w->busy.of);
    for (int k = KIND_WALL; k < KINDS; k++) {
        unsigned char *of = w->busy.of + (size_t)c->of[k] * PACK_BLOCKS;
        if (!tells(l, k))
            continue;
        memset(of, PACK_IDLE, (size_t)(c->of[k + 1] - c->of[k]) * PACK_BLOCKS);
        for (int s = l->start[k]; s < l->start[k + 1]; s++)
            if (wet_is_near(m, l->order[s]))
                of[(s - l->start[k]) / PACK_BLOCK] = PACK_BUSY;
    }
    w->busy.list = l;
    w->busy.builds = l->builds;
}
