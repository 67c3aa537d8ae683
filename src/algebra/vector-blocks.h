/* vector-blocks.h -- how our vectors are cut: private to vector.c and vector-loops.c. */
#ifndef ALGEBRA_VECTOR_BLOCKS_H
#define ALGEBRA_VECTOR_BLOCKS_H

enum {
    VECTOR_BLOCK = 1024, /* entries whose partial results belong together      */
    VECTOR_LONG = 20000  /* from this length on a second thread pays           */
};

static inline long vector_blocks(long n)
{
    return (n + VECTOR_BLOCK - 1) / VECTOR_BLOCK;
}

static inline int vector_block_size(long n, long b)
{
    const long left = n - b * VECTOR_BLOCK;

    return left < VECTOR_BLOCK ? (int)left : VECTOR_BLOCK;
}

#endif
