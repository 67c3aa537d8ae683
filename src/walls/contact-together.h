/* contact-together.h -- where all ranks make a plan at once, each measures a part of its solids, and hears of
 * the others'.  Where not, a part is all there is. */
#ifndef WALLS_CONTACT_TOGETHER_H
#define WALLS_CONTACT_TOGETHER_H

#include "state/part.h"

struct contact_part {
    int from, to;
};

/* Of n things in an order that all ranks know, this rank's. */
struct contact_part contact_together_part(const struct part_places *at, int n);

/* The first failure of all ranks, on all. */
int contact_together_agree(const struct part_places *at, int status);

/* Have all ranks so many solids?  If not, all refuse: of one scene, which they have read, they
 * place different particles. */
int contact_together_compare(const struct part_places *at, int n);

/* Each of n things is one row of so many bytes: this rank's part of them are in `rows`, and all are from now on. */
void contact_together_hear(const struct part_places *at, int n, size_t bytes, void *rows);

/* The same where thing i is rows start[i]..start[i + 1], of which `each` count as one of so many bytes. */
void contact_together_hear_uneven(const struct part_places *at, int n, const long *start, int each, size_t bytes,
                                  void *rows);

/* Becomes the sum of all ranks' numbers. */
long contact_together_sum(const struct part_places *at, long number);

#endif
