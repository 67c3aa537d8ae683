/* memory.h -- what solves work in, about: bytes of a full lattice. */
#ifndef SOLVED_MEMORY_H
#define SOLVED_MEMORY_H

#include "plan/inside.h"

/* Neighbours nearer than `reach` spacings of all particles of the fluid of a plan, and, if asked
 * for, of solids, which have fluid or each other on some sides only. */
double memory_pairs(const struct plan *p, double reach, bool solids);

/* A list of all with all, support and margin together being `reach` spacings. */
double memory_list(const struct plan *p, double reach);

#endif
