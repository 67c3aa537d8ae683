/* single-pack.c -- from records in double precision to such of pairs in single precision. */
#include "space/single-pack.h"

#include "base/threads.h"
#include "space/record.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

enum { CHUNK = 512 };

/* Beyond this x stands only what takes no part: see moment_pack(). */
static double edge(const struct list_def *def)
{
    const double end = def->period[0] > 0 ? def->side[0] + def->period[0] : def->high[0];

    return end + 5 * def->support;
}

/* The numbers that both kinds of records begin with, side by side. */
typedef double eight __attribute__((vector_size(8 * sizeof(double))));
typedef int64_t eight_bits __attribute__((vector_size(8 * sizeof(int64_t))));
typedef int32_t eight_counts __attribute__((vector_size(8 * sizeof(int32_t))));
typedef float eight_floats __attribute__((vector_size(8 * sizeof(float))));

_Static_assert(RECORD_X == 0 && RECORD >= 8, "positions come first");

/* The first DIM numbers as the nearest whole number of counts, modulo 2^32: the low digits of
 * a sum that has no room for a fraction.  All others as they are. */
static inline eight_floats convert(const double *r, double per)
{
    eight x;

    memcpy(&x, r, sizeof x);
    const eight_bits sum = (eight_bits)(x * per + 6755399441055744.0); /* 3 2^51 */
    const eight_floats counts = (eight_floats)__builtin_convertvector(sum, eight_counts);
    const eight_floats values = __builtin_convertvector(x, eight_floats);
#if DIM == 2
    return __builtin_shufflevector(counts, values, 0, 1, 10, 11, 12, 13, 14, 15);
#else
    return __builtin_shufflevector(counts, values, 0, 1, 2, 11, 12, 13, 14, 15);
#endif
}

/* What stands beyond `far` is marked: see single.h. */
static inline void pack_short(const double *r, double per, double far, float *to)
{
    const eight_floats f = convert(r, per);

    memcpy(to, &f, sizeof f);
#if DIM == 2
    to[6] = r[RECORD_X] < far ? to[6] : 0;
#else
    to[3] = r[RECORD_X] < far ? to[3] : -to[3];
#endif
}

#if DIM == 3
static inline void pack_long(const double *r, double per, double far, float *to)
{
    pack_short(r, per, far, to);
    to[8] = r[RECORD_X] < far ? (float)r[RECORD_M] : 0;
    to[9] = (float)r[RECORD_IRHO];
}
#endif

/* Places from..to-1. */
static void pack_places(const double *r, double per, double far, size_t floats, int from, int to,
                        float *record)
{
#if DIM == 3
    for (int s = from; s < to && floats > 8; s++)
        pack_long(r + (size_t)s * RECORD, per, far, record + (size_t)s * floats);
#endif
    for (int s = from; s < to && floats == 8; s++)
        pack_short(r + (size_t)s * RECORD, per, far, record + (size_t)s * 8);
}

static void pack_all(const struct list *list, const double *from, double mass, float *record)
{
    const int n = list->listed + 1;
    const size_t floats = (size_t)single_floats(mass);
    const double per = 1 / single_count(list), far = edge(&list->def);

#pragma omp for schedule(static) nowait
    for (int begin = 0; begin < n; begin += CHUNK)
        pack_places(from, per, far, floats, begin, begin + CHUNK < n ? begin + CHUNK : n, record);
}

void single_pack(const struct list *list, const double *from, double mass, float *record)
{
    THREADS(list->listed + 1 > 4 * CHUNK, pack_all(list, from, mass, record));
}
