/* claims.h -- claims that all ranks make together.
 *
 * cmocka leaves a test at the first assertion that fails; a rank that did so alone would leave
 * the others waiting for it.  Here every rank goes on, and a claim is true where it is true on all. */
#ifndef TESTS_RANKS_CLAIMS_H
#define TESTS_RANKS_CLAIMS_H

#include <stdbool.h>

/* Collective: the first rank prints it. */
void claim(bool true_here, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Exit status of the program, on all ranks. */
int claims_end(void);

/* Numbers that all ranks can make for themselves: between 0 and 1, by number. */
double claims_random(unsigned number);

#endif
