/* waits.h -- claims on ranks that wait: tests/ranks/room.c calls them. */
#ifndef TESTS_RANKS_WAITS_H
#define TESTS_RANKS_WAITS_H

void waits_claims(void);

#endif
