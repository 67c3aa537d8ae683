/* buckets.c -- which points are near a place. */
#include "shapes/buckets.h"

#include "base/status.h"
#include <math.h>
#include <stdlib.h>

static uint64_t bucket_of(const struct buckets *b, const double *x, const int *shift)
{
    static const uint64_t stride[3] = { 1, 73856093, 19349663 };
    uint64_t number = 0;

    for (int d = 0; d < DIM; d++)
        number += stride[d] * (uint64_t)((int64_t)floor(x[d] / b->width) + shift[d]);
    return number & b->mask;
}

/* Counting sort: counts, ends of buckets, then members from the back. */
static void sort(const struct buckets *b, int n)
{
    const int here[3] = { 0 };

    for (int i = 0; i < n; i++)
        b->start[bucket_of(b, b->x[i], here)]++;
    for (uint64_t k = 0; k <= b->mask; k++)
        b->start[k + 1] += b->start[k];
    for (int i = n - 1; i >= 0; i--)
        b->member[--b->start[bucket_of(b, b->x[i], here)]] = i;
}

int buckets_create(struct buckets *b, const double (*x)[DIM], int n, double width)
{
    *b = (struct buckets){ .x = x, .width = width, .mask = 1 };
    while (b->mask < (uint64_t)n)
        b->mask = 2 * b->mask + 1;
    b->start = status_alloc(b->mask + 2, sizeof *b->start);
    b->member = status_alloc(n + 1, sizeof *b->member);
    if (!b->start || !b->member) {
        buckets_free(b);
        return STATUS_FAILED;
    }
    sort(b, n);
    return STATUS_DONE;
}

void buckets_free(struct buckets *b)
{
    free(b->start);
    free(b->member);
    b->start = b->member = NULL;
}

double buckets_distance2(const double *a, const double *b)
{
    double r2 = 0;

    for (int d = 0; d < DIM; d++)
        r2 += (a[d] - b[d]) * (a[d] - b[d]);
    return r2;
}

int buckets_find(const struct buckets *b, const double *x, double reach,
                 bool (*counts)(const void *self, int j), const void *self)
{
    const int block = DIM == 2 ? 9 : 27;

    for (int k = 0; k < block; k++) {
        const int shift[3] = { k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1 };
        const uint64_t bucket = bucket_of(b, x, shift);

        for (int m = b->start[bucket]; m < b->start[bucket + 1]; m++) {
            const int j = b->member[m];

            if (buckets_distance2(x, b->x[j]) < reach * reach && (!counts || counts(self, j)))
                return j;
        }
    }
    return -1;
}
