/* lanes-max.h -- the larger of a number and 0 in one instruction, where the compiler makes two of
 * lanes_positive(): for the loops in which that counts. */
#ifndef BASE_LANES_MAX_H
#define BASE_LANES_MAX_H

#include "base/lanes.h"

#ifdef __SSE2__
#include <immintrin.h>
#endif

/* max(a, 0), and 0 for what is no number: what lanes_positive() gives, to the bit. */
LANES_INLINE lanes lanes_positive_at_once(lanes a)
{
#ifndef __SSE2__
    return lanes_positive(a);
#elif LANES == 16
    return (lanes)_mm512_max_ps((__m512)a, _mm512_setzero_ps());
#elif LANES == 8 && defined SINGLE
    return (lanes)_mm256_max_ps((__m256)a, _mm256_setzero_ps());
#elif LANES == 8
    return (lanes)_mm512_max_pd((__m512d)a, _mm512_setzero_pd());
#elif LANES == 4 && defined SINGLE
    return (lanes)_mm_max_ps((__m128)a, _mm_setzero_ps());
#elif LANES == 4
    return (lanes)_mm256_max_pd((__m256d)a, _mm256_setzero_pd());
#else
    return (lanes)_mm_max_pd((__m128d)a, _mm_setzero_pd());
#endif
}

#endif
