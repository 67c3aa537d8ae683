/* exact-sum.h -- sums of doubles that do not depend on the order of their terms.
 *
 *     struct exact_sum sum = { 0 };
 *     exact_sum_add(&sum, n, x);             as often as needed, by any n
 *     exact_sum_merge(&sum, &other);         of another thread or machine
 *     exact_sum_value(&sum)
 *
 * A sum is kept exactly, as a whole number of 2^-1074, the least double there is. So
 * its value is the same for any order and partition of the terms, on any number of
 * threads and for registers of any width; adding and merging are associative. The value
 * is the exact sum rounded once (to nearest, ties to even): off by half a unit of its
 * last place at most, however many terms cancel. No bound on the terms need be known.
 *
 * An infinite term makes the value infinite, a NaN or both infinities make it NaN,
 * wherever they come; a sum beyond the largest double is infinite, but one that only
 * passes through there is not.  A sum of 0 is +0.  Room is for 2^62 terms.
 *
 * A term costs about as much as two passes over numbers in the nearest cache, if the
 * terms of a call are some dozens and all are larger than 10^-10 of the largest, or 0; a
 * third pass goes down to 10^-23.  Smaller ones, and terms beyond 10^301, are added one
 * by one, which takes ten times as long. */
#ifndef ALGEBRA_EXACT_SUM_H
#define ALGEBRA_EXACT_SUM_H

#include <stdint.h>

enum {
    EXACT_SUM_DIGITS = 69, /* of 32 bits; the last one has the sign            */
    EXACT_SUM_NAN = EXACT_SUM_DIGITS, /* words after them are not 0 when a term is
                              NaN,                                             */
    EXACT_SUM_PLUS,        /* ... infinite,                                    */
    EXACT_SUM_MINUS,       /* ... infinite and below 0                         */
    EXACT_SUM_WORDS
};

/* { 0 }: a sum without terms. */
struct exact_sum {
    int64_t word[EXACT_SUM_WORDS]; /* sum of word[k] 2^(32 k - 1074), and marks */
    long full;             /* |digits| are at most so many times 2^32          */
};

void exact_sum_add(struct exact_sum *s, long n, const double *x);

/* The same, one term after the other: for a few. */
void exact_sum_terms(struct exact_sum *s, int n, const double *x);

/* Constants that cut terms (exact-rows.h); { 0 } serves terms of 0 only. */
struct exact_cut {
    double coarse, fine;   /* adding and taking off again rounds to what adds up without
                              rounding, and what is left to what is 2^44 times finer   */
    double limit;          /* |terms| served                                   */
};

/* Serves terms that are at most 64 times larger than `most`; nothing is left of those that
 * are no less than 10^-8 of it.  Stays as it is where `most` is 0 or too large. */
void exact_sum_choose(struct exact_cut *cut, double most);

/* Terms that come one by one, and are added some dozens at a time:
 *
 *     struct exact_terms t = { .to = &sum };
 *     exact_terms_add(&t, x);                as often as needed
 *     exact_terms_end(&t);                   now all are in the sum */
enum { EXACT_TERMS = 64 };
struct exact_terms {
    struct exact_sum *to;
    int n;
    double x[EXACT_TERMS];
};

static inline void exact_terms_end(struct exact_terms *t)
{
    exact_sum_add(t->to, t->n, t->x);
    t->n = 0;
}

static inline void exact_terms_add(struct exact_terms *t, double x)
{
    t->x[t->n++] = x;
    if (t->n == EXACT_TERMS)
        exact_terms_end(t);
}

void exact_sum_merge(struct exact_sum *to, const struct exact_sum *from);
double exact_sum_value(const struct exact_sum *s);

/* Makes all digits but the last one 0 to 2^32 - 1: the words of as many as 2^30 such
 * sums may then be added one by one (by MPI, say) and are those of their sum. */
void exact_sum_carry(struct exact_sum *s);

/* Each of n sums of this rank becomes that of all ranks, which call it together. */
void exact_sum_share(int n, struct exact_sum *const *sum);

#endif
