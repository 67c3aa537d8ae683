/* single.c -- from records in double precision to such of pairs in single precision. */
#include "space/single.h"

#include "space/record.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

enum { CHUNK = 512 };

double single_count(const struct list *list)
{
    return SINGLE_SUPPORTS * list->def.support / 4294967296.0;
}

/* Beyond this x stands only what takes no part: see moment_pack(). */
static double edge(const struct list_def *def)
{
    const double end = def->period[0] > 0 ? def->side[0] + def->period[0] : def->high[0];

    return end + 5 * def->support;
}

/* The nearest whole number of counts, modulo 2^32: the low digits of a sum that has no
 * room for a fraction. */
static inline float counts(double x, double per)
{
    const double sum = x * per + 6755399441055744.0; /* 3 2^51 */
    int64_t bits;
    float f;

    memcpy(&bits, &sum, sizeof bits);
    const int32_t low = (int32_t)(uint32_t)bits;
    memcpy(&f, &low, sizeof f);
    return f;
}

#if DIM == 2
static inline void pack_one(const double *r, double per, double far, float *to)
{
    to[0] = counts(r[RECORD_X], per);
    to[1] = counts(r[RECORD_X + 1], per);
    for (int i = 2; i < RECORD_M; i++)
        to[i] = (float)r[i];
    to[6] = r[RECORD_X] < far ? (float)r[RECORD_M] : 0;
    to[7] = (float)r[RECORD_IRHO];
}
#else
static inline void pack_short(const double *r, double per, double far, float *to)
{
    to[0] = counts(r[RECORD_X], per);
    to[1] = counts(r[RECORD_X + 1], per);
    to[2] = counts(r[RECORD_Z], per);
    to[3] = (float)(r[RECORD_X] < far ? r[RECORD_RHO] : -r[RECORD_RHO]);
    for (int i = RECORD_V; i < RECORD_M; i++)
        to[i] = (float)r[i];
}

static inline void pack_one(const double *r, double per, double far, float *to)
{
    pack_short(r, per, far, to);
    to[8] = r[RECORD_X] < far ? (float)r[RECORD_M] : 0;
    to[9] = (float)r[RECORD_IRHO];
}
#endif

void single_pack(const struct list *list, const double *from, double mass, float *record)
{
    const int n = list->listed + 1;
    const size_t floats = (size_t)single_floats(mass);
    const double per = 1 / single_count(list), far = edge(&list->def);

#pragma omp parallel for schedule(static) if (n > 4 * CHUNK)
    for (int begin = 0; begin < n; begin += CHUNK) {
        const int end = begin + CHUNK < n ? begin + CHUNK : n;
#if DIM == 3
        for (int s = begin; s < end && floats == 8; s++)
            pack_short(from + (size_t)s * RECORD, per, far, record + (size_t)s * 8);
        if (floats == 8)
            continue;
#endif
        for (int s = begin; s < end; s++)
            pack_one(from + (size_t)s * RECORD, per, far, record + (size_t)s * floats);
    }
}
