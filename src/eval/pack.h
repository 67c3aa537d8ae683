/* pack.h -- records that are packed together: inside of eval. */
#ifndef EVAL_PACK_H
#define EVAL_PACK_H

#include "eval/inside.h"

enum {
    PACK_CHUNK = 128,
    PACK_BLOCK = 16, /* places of a chunk that are packed or not              */
    PACK_BLOCKS = PACK_CHUNK / PACK_BLOCK
};

/* Is a block packed, and does it have rows of others that stand beyond own ones? */
enum pack_busy { PACK_IDLE, PACK_BUSY, PACK_OWN };

/* The chunks of all kinds, one after the other: in one region, as each costs its start. */
struct pack_chunks {
    int n, of[KINDS + 1]; /* kind k: chunks of[k] .. of[k+1]-1 */
    const unsigned char *busy; /* [n][PACK_BLOCKS] enum pack_busy of blocks; NULL: of all PACK_BUSY */
};

/* Are records read by pairs alone, so that those of solids that nothing meets need not change?  What else
 * has a pressure of its own, or forces between faces, goes over all places. */
bool pack_spares(const struct moment *m, unsigned kinds);

/* All records of a list are there: from now on those blocks are busy that have a place that is read. */
void pack_note(struct moment *m, const struct pack_chunks *c);

#endif
