/* time-toy-solved.c -- a toy has no pressure that could be solved for step by step. */
#include "base/status.h"
#include "solved/mps.h"
#include "solved/pcisph.h"

#include <stddef.h>

const char *mps_serves(const struct plan *p)
{
    (void)p;
    return "a toy";
}

int mps_create(struct moment *p, struct mps **out)
{
    (void)p;
    *out = NULL;
    return STATUS_FAILED;
}

void mps_free(struct mps **mps)
{
    *mps = NULL;
}

int mps_step(struct mps *mps, double t, double h, const double *y, const double *f, double *to)
{
    (void)mps, (void)t, (void)h, (void)y, (void)f, (void)to;
    return STATUS_FAILED;
}

double mps_length(const struct mps *mps, double number, double t, const double *y,
                  struct limit *limit)
{
    (void)mps, (void)number, (void)t, (void)y, (void)limit;
    return 0;
}

const char *pcisph_serves(const struct plan *p)
{
    (void)p;
    return "a toy";
}

int pcisph_create(struct moment *moment, struct pcisph **out)
{
    (void)moment;
    *out = NULL;
    return STATUS_FAILED;
}

void pcisph_free(struct pcisph **p)
{
    *p = NULL;
}

int pcisph_solve(struct pcisph *p, double t, double h, const double *rates, double *y)
{
    (void)p, (void)t, (void)h, (void)rates, (void)y;
    return STATUS_FAILED;
}

void pcisph_settle(const struct pcisph *p, double h, const double *y_old, const double *y,
                   double *rates)
{
    (void)p, (void)h, (void)y_old, (void)y, (void)rates;
}

double pcisph_pace(const struct pcisph *p)
{
    (void)p;
    return 0;
}

void pcisph_decay(const struct pcisph *p, double t, const double *y, struct limit *out)
{
    (void)p, (void)t, (void)y, (void)out;
}
