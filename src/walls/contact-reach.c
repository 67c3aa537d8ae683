/* contact-reach.c -- which solids a right-hand side asks for. */
#include "walls/contact-reach.h"

#include "base/status.h"

#include <stdlib.h>
#include <string.h>

static int *take(const struct contact_mean *mean)
{
    return status_alloc((unsigned long)mean->slices + 1, sizeof(int));
}

static bool take_chosen(struct contact_chosen *c, const struct contact_mean *mean)
{
    bool taken = true;

    c->in = status_alloc((unsigned long)mean->slices + 1, sizeof *c->in);
    for (int stage = 0; stage < CONTACT_STAGES; stage++) {
        c->slices.slice[stage] = take(mean);
        taken = taken && c->slices.slice[stage];
    }
    return taken && c->in;
}

static void free_chosen(struct contact_chosen *c)
{
    for (int stage = 0; stage < CONTACT_STAGES; stage++)
        free(c->slices.slice[stage]);
    free(c->in);
}

int contact_reach_create(struct contact_reach *r, const struct contact_mean *mean)
{
    int *every = take(mean);
    bool taken = every;

    *r = (struct contact_reach){ .mean = mean };
    taken = take_chosen(&r->met, mean) && taken;
    taken = take_chosen(&r->own, mean) && taken;
    for (int stage = 0; stage < CONTACT_STAGES; stage++) {
        r->all.slice[stage] = every;
        r->all.n[stage] = mean->slices;
    }
    for (int s = 0; every && s < mean->slices; s++)
        every[s] = s;
    if (taken)
        return STATUS_DONE;
    contact_reach_free(r);
    return STATUS_FAILED;
}

void contact_reach_free(struct contact_reach *r)
{
    free_chosen(&r->met);
    free_chosen(&r->own);
    free(r->all.slice[0]);
    *r = (struct contact_reach){ 0 };
}

/* With one choice: a process that is alone does not ask for its own. */
double contact_reach_memory(const struct contact_mean *mean)
{
    return (double)mean->slices * ((CONTACT_STAGES + 1) * sizeof(int) + 1);
}

static void collect(const struct contact_mean *m, struct contact_chosen *c, enum contact_stage stage)
{
    int n = 0;

    for (int s = 0; s < m->slices; s++)
        if (c->in[s] & 1u << stage)
            c->slices.slice[stage][n++] = s;
    c->slices.n[stage] = n;
}

/* From slices of a stage to those that its means are taken of. */
static void spread(const struct contact_mean *m, struct contact_chosen *c, enum contact_stage stage)
{
    for (int k = 0; k < c->slices.n[stage]; k++) {
        const int s = c->slices.slice[stage][k];
        for (long e = m->reads_from[s]; e < m->reads_from[s + 1]; e++)
            c->in[m->reads[e]] |= 1u << (stage - 1);
    }
}

static void settle(const struct contact_mean *m, struct contact_chosen *c)
{
    collect(m, c, CONTACT_Q);
    spread(m, c, CONTACT_Q);
    collect(m, c, CONTACT_PI);
    spread(m, c, CONTACT_PI);
    collect(m, c, CONTACT_R);
}

void contact_reach_choose(struct contact_reach *r, enum part_solids which, const bool *solid)
{
    struct contact_chosen *c = which == PART_SOLIDS_OWN ? &r->own : &r->met;
    const struct contact_mean *m = r->mean;

    memset(c->in, 0, (size_t)m->slices);
    for (int i = 0; i < m->n; i++)
        if (solid[m->solid[i]])
            c->in[i / CONTACT_ROWS] = 1u << CONTACT_Q;
    settle(m, c);
    r->made += which == PART_SOLIDS_MET;
}

const struct contact_slices *contact_reach_of(const struct contact_reach *r, enum part_solids which)
{
    return which == PART_SOLIDS_ALL ? &r->all : which == PART_SOLIDS_OWN ? &r->own.slices : &r->met.slices;
}

void contact_reach_widen(struct contact_reach *r, const bool *also)
{
    unsigned char *in = r->met.in;
    bool more = false;

    for (int i = 0; i < r->mean->n; i++)
        if (also[i] && !(in[i / CONTACT_ROWS] & 1u << CONTACT_Q)) {
            in[i / CONTACT_ROWS] |= 1u << CONTACT_Q;
            more = true;
        }
    if (!more)
        return;
    settle(r->mean, &r->met);
    r->made++;
}
