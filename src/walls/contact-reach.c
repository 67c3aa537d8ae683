/* contact-reach.c -- which solids a right-hand side asks for. */
#include "walls/contact-reach.h"

#include "base/status.h"

#include <stdlib.h>
#include <string.h>

static int *take(const struct contact_mean *mean)
{
    return status_alloc((unsigned long)mean->slices + 1, sizeof(int));
}

int contact_reach_create(struct contact_reach *r, const struct contact_mean *mean)
{
    int *every = take(mean);
    bool taken = every;

    *r = (struct contact_reach){ .mean = mean };
    r->in = status_alloc((unsigned long)mean->slices + 1, sizeof *r->in);
    for (int stage = 0; stage < CONTACT_STAGES; stage++) {
        r->near.slice[stage] = take(mean);
        r->all.slice[stage] = every;
        r->all.n[stage] = mean->slices;
        taken = taken && r->near.slice[stage];
    }
    for (int s = 0; every && s < mean->slices; s++)
        every[s] = s;
    if (taken && r->in)
        return STATUS_DONE;
    contact_reach_free(r);
    return STATUS_FAILED;
}

void contact_reach_free(struct contact_reach *r)
{
    for (int stage = 0; stage < CONTACT_STAGES; stage++)
        free(r->near.slice[stage]);
    free(r->all.slice[0]);
    free(r->in);
    *r = (struct contact_reach){ 0 };
}

double contact_reach_memory(const struct contact_mean *mean)
{
    return (double)mean->slices * ((CONTACT_STAGES + 1) * sizeof(int) + 1);
}

static void collect(struct contact_reach *r, enum contact_stage stage)
{
    int n = 0;

    for (int s = 0; s < r->mean->slices; s++)
        if (r->in[s] & 1u << stage)
            r->near.slice[stage][n++] = s;
    r->near.n[stage] = n;
}

/* From slices of a stage to those that its means are taken of. */
static void spread(struct contact_reach *r, enum contact_stage stage)
{
    const struct contact_mean *m = r->mean;

    for (int k = 0; k < r->near.n[stage]; k++) {
        const int s = r->near.slice[stage][k];
        for (long e = m->reads_from[s]; e < m->reads_from[s + 1]; e++)
            r->in[m->reads[e]] |= 1u << (stage - 1);
    }
}

static void settle(struct contact_reach *r)
{
    r->made++;
    collect(r, CONTACT_Q);
    spread(r, CONTACT_Q);
    collect(r, CONTACT_PI);
    spread(r, CONTACT_PI);
    collect(r, CONTACT_R);
}

void contact_reach_narrow(struct contact_reach *r, const bool *met)
{
    const struct contact_mean *m = r->mean;

    memset(r->in, 0, (size_t)m->slices);
    for (int i = 0; i < m->n; i++)
        if (met[m->solid[i]])
            r->in[i / CONTACT_ROWS] = 1u << CONTACT_Q;
    settle(r);
}

void contact_reach_widen(struct contact_reach *r, const bool *also)
{
    bool more = false;

    for (int i = 0; i < r->mean->n; i++)
        if (also[i] && !(r->in[i / CONTACT_ROWS] & 1u << CONTACT_Q)) {
            r->in[i / CONTACT_ROWS] |= 1u << CONTACT_Q;
            more = true;
        }
    if (more)
        settle(r);
}
