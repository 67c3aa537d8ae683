/* alike.h -- claims of what ranks of one machine have alike. */
#ifndef TESTS_RANKS_ALIKE_H
#define TESTS_RANKS_ALIKE_H

void alike_claims(void);

#endif
