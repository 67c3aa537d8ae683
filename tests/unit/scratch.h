/* scratch.h -- a directory that a unit test may fill, and numbers that are near. */
#ifndef TESTS_SCRATCH_H
#define TESTS_SCRATCH_H

extern char scratch[64];

/* Setup and teardown of cmocka: makes it, removes it with all that is in it. */
int scratch_make(void **state);
int scratch_remove(void **state);

/* Fails unless |found - wanted| <= tolerance. */
void near(double found, double wanted, double tolerance);

#endif
