/* coords.h -- all coordinates at once, for what is done with each particle in every
 * right-hand side.  Of a number and a NaN, lesser() and larger() take b. */
#ifndef SPACE_COORDS_H
#define SPACE_COORDS_H

#include "space/kinds.h"
#include <string.h>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

#if DIM == 2 && defined __SSE2__
typedef __m128d coords;

static inline coords coords_at(const double *x)
{
    return _mm_loadu_pd(x);
}

static inline void coords_put(coords a, double *x)
{
    _mm_storeu_pd(x, a);
}

static inline coords less(coords a, coords b)
{
    return _mm_sub_pd(a, b);
}

static inline coords plus(coords a, coords b)
{
    return _mm_add_pd(a, b);
}

static inline coords lesser(coords a, coords b)
{
    return _mm_min_pd(a, b);
}

static inline coords larger(coords a, coords b)
{
    return _mm_max_pd(a, b);
}

static inline double length2(coords a)
{
    const coords square = _mm_mul_pd(a, a);

    return _mm_cvtsd_f64(square) + _mm_cvtsd_f64(_mm_unpackhi_pd(square, square));
}
#elif DIM == 3 && defined __SSE2__
typedef struct {
    __m128d xy, z; /* z: the other half is 0 */
} coords;

static inline coords coords_at(const double *x)
{
    return (coords){ _mm_loadu_pd(x), _mm_load_sd(x + 2) };
}

static inline void coords_put(coords a, double *x)
{
    _mm_storeu_pd(x, a.xy);
    _mm_store_sd(x + 2, a.z);
}

static inline coords less(coords a, coords b)
{
    return (coords){ _mm_sub_pd(a.xy, b.xy), _mm_sub_sd(a.z, b.z) };
}

static inline coords plus(coords a, coords b)
{
    return (coords){ _mm_add_pd(a.xy, b.xy), _mm_add_sd(a.z, b.z) };
}

static inline coords lesser(coords a, coords b)
{
    return (coords){ _mm_min_pd(a.xy, b.xy), _mm_min_sd(a.z, b.z) };
}

static inline coords larger(coords a, coords b)
{
    return (coords){ _mm_max_pd(a.xy, b.xy), _mm_max_sd(a.z, b.z) };
}

static inline double length2(coords a)
{
    const __m128d square = _mm_mul_pd(a.xy, a.xy);

    return _mm_cvtsd_f64(square) + _mm_cvtsd_f64(_mm_unpackhi_pd(square, square))
           + _mm_cvtsd_f64(_mm_mul_sd(a.z, a.z));
}
#else
typedef struct {
    double x[DIM];
} coords;

static inline coords coords_at(const double *x)
{
    coords a;

    memcpy(a.x, x, sizeof a.x);
    return a;
}

static inline void coords_put(coords a, double *x)
{
    memcpy(x, a.x, sizeof a.x);
}

#define EACH(name, result)                                                                 \
    static inline coords name(coords a, coords b)                                          \
    {                                                                                      \
        for (int d = 0; d < DIM; d++)                                                      \
            a.x[d] = result;                                                               \
        return a;                                                                          \
    }
EACH(less, a.x[d] - b.x[d])
EACH(plus, a.x[d] + b.x[d])
EACH(lesser, a.x[d] < b.x[d] ? a.x[d] : b.x[d])
EACH(larger, a.x[d] > b.x[d] ? a.x[d] : b.x[d])

static inline double length2(coords a)
{
    double sum = 0;

    for (int d = 0; d < DIM; d++)
        sum += a.x[d] * a.x[d];
    return sum;
}
#endif

#endif
