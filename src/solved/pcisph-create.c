/* pcisph-create.c -- memory of prediction and correction. */
#include "eval/given.h"
#include "solved/memory.h"
#include "solved/pcisph-inside.h"

#include "base/status.h"
#include "space/record.h"

#include <stdlib.h>
#include <string.h>

enum { ALL_KINDS = KIND_BIT(KINDS) - 1 };

/* Margin of the list [H]: two particles that near each other at a CFL number of 0.2 and
 * at speeds that nothing but the last pressure gave. */
static const double margin = 0.2;

static int make_list(struct pcisph *p)
{
    struct list_def def = p->m->plan->list_def;

    def.skin = margin * p->m->plan->scales.support;
    for (int k = 0; k < KINDS; k++)
        def.acts[k] = p->meets[k] = ALL_KINDS;
    return p->m->plan->engine->sum->list->create(&p->list, &def);
}

static int take_memory(struct pcisph *p)
{
    const size_t n = (size_t)p->m->particles->n;

    p->sum = workspace_lines(n);
    p->push = workspace_lines(n * DIM);
    TRY(given_make(p->m));
    return p->sum && p->push ? make_list(p) : STATUS_FAILED;
}

/* The list; records at two places, ones and P of places; sums and pushes. */
double pcisph_memory(const struct plan *p)
{
    const double n = p->particles->n;

    return memory_list(p, (1 + margin) * p->in.kernel.support)
         + 8 * n * (1.125 * (2 * RECORD + 2) + 1 + DIM);
}

int pcisph_create(struct moment *moment, struct pcisph **out)
{
    const struct plan *plan = moment->plan;
    struct pcisph *p = *out = status_alloc(1, sizeof *p);
    const bool own = strcmp(plan->in.pcisph.delta, "toth") == 0;

    if (!p)
        return STATUS_FAILED;
    p->m = moment;
    p->set = &plan->in.pcisph;
    p->eos = plan->pressure->self;
    p->density = plan->kernel[PART_DENSITY];
    p->force = plan->kernel[PART_PRESSURE];
    p->full = pcisph_lattice_density(p->density, plan->scales.mass, plan->scales.dx);
    p->response = pcisph_lattice_response(p->density, own ? p->density : p->force,
                                          plan->scales.dx);
    moment->counts.gain = p->set->gain * pcisph_lattice_response(p->density, p->force,
                                                                 plan->scales.dx) / p->response;
    if (take_memory(p) == STATUS_DONE)
        return STATUS_DONE;
    pcisph_free(out);
    return STATUS_FAILED;
}

static void free_places(struct pcisph *p)
{
    free(p->here);
    free(p->there);
    free(p->ones);
    free(p->P);
    p->here = p->there = p->ones = p->P = NULL;
}

void pcisph_free(struct pcisph **of)
{
    struct pcisph *p = *of;

    if (!p)
        return;
    if (p->list)
        p->m->plan->engine->sum->list->free(&p->list);
    free_places(p);
    free(p->sum);
    free(p->push);
    free(p);
    *of = NULL;
}

int pcisph_fit(struct pcisph *p)
{
    const size_t places = (size_t)p->list->listed + 1;

    if (places > p->slots) {
        free_places(p);
        p->slots = places + places / 8;
        p->here = workspace_lines(p->slots * RECORD);
        p->there = workspace_lines(p->slots * RECORD);
        p->ones = workspace_lines(p->slots);
        p->P = workspace_lines(p->slots);
    }
    if (!p->here || !p->there || !p->ones || !p->P)
        return STATUS_FAILED;
    for (size_t s = 0; s < places; s++)
        p->ones[s] = 1;
    memset(p->P, 0, places * sizeof *p->P);
    memset(p->push, 0, (size_t)p->m->particles->n * DIM * sizeof *p->push);
    return STATUS_DONE;
}
