/* viscous-guess.c -- what the velocities of a stage will be, from those before it.
 *
 * The parabola through the last stage and the starts of the last steps: a solve then
 * begins with an error of some h^3 instead of h.  More nodes would carry more of what
 * solves have left into the guess: 16 % more products, and twice the error. */
#include "implicit/viscous.h"

#include <math.h>
#include <string.h>

enum { NODES = 3 };

void viscous_read(struct moment *m, const double *y, double *v)
{
    const int n = particles_count(m->particles, KIND_FLUID) * DIM;

    memcpy(v, y + layout_at(&m->layout, m->plan->row.u), (size_t)n * sizeof *v);
    v += n;
    for (int i = 0; i < m->plan->bodies; i++) {
        m->body[i].kind->role.coupled->read(m->body[i].body, &m->layout, y, v);
        v += viscous_body(m->plan, i);
    }
}

/* Makes room at the front and returns what is to be filled. */
static struct viscous_past *push(struct viscous_past *past, int *n, int most)
{
    const struct viscous_past last = past[most - 1];

    memmove(past + 1, past, (size_t)(most - 1) * sizeof *past);
    past[0] = last;
    *n += *n < most;
    return past;
}

/* The same moment twice is a step that is tried again. */
void viscous_begin(struct moment *m, double t, const double *y)
{
    struct viscous *u = viscous_of(m);
    struct viscous_past *to = u->known.start;

    while (u->known.starts > 0 && u->known.start[0].t >= t) { /* time was set back */
        const struct viscous_past gone = u->known.start[0];
        memmove(u->known.start, u->known.start + 1, (VISCOUS_STARTS - 1) * sizeof gone);
        u->known.start[VISCOUS_STARTS - 1] = gone;
        u->known.starts--;
    }
    to = push(u->known.start, &u->known.starts, VISCOUS_STARTS);
    to->t = t;
    viscous_read(m, y, to->v);
    u->known.stages = 0;
}

void viscous_keep(struct viscous *u, double t, const double *v)
{
    struct viscous_past *to = push(u->known.past, &u->known.stages, VISCOUS_STAGES);

    to->t = t;
    memcpy(to->v, v, (size_t)u->unknowns * sizeof *v);
}

void viscous_forget(void *self)
{
    struct viscous *u = self;

    u->known.starts = u->known.stages = 0;
}

/* Takes a node unless it stands too close to another: such weights grow large. */
static int take(const struct viscous_past *one, double apart, const struct viscous_past **node,
                int n)
{
    for (int i = 0; i < n; i++)
        if (fabs(node[i]->t - one->t) < apart)
            return n;
    if (n < NODES)
        node[n++] = one;
    return n;
}

static int choose(const struct viscous *u, double t, const struct viscous_past **node)
{
    const double h = u->known.starts > 0 ? t - u->known.start[0].t : 0;
    int n = 0;

    if (!(h > 0))
        return 0;
    for (int i = 0; i < u->known.stages; i++)
        n = take(&u->known.past[i], 0.1 * h, node, n);
    for (int i = 0; i < u->known.starts; i++)
        if (t - u->known.start[i].t < 5 * h)
            n = take(&u->known.start[i], 0.3 * h, node, n);
    return n;
}

/* What is known goes along with the rows of the fluid. */
int viscous_rearrange(struct moment *m, const int *from)
{
    struct viscous *u = viscous_of(m);
    const struct vector_rows fluid = { .n = u->fluid / DIM, .components = DIM, .from = from };
    double *known[VISCOUS_STARTS + VISCOUS_STAGES];

    for (int i = 0; i < VISCOUS_STARTS; i++)
        known[i] = u->known.start[i].v;
    for (int i = 0; i < VISCOUS_STAGES; i++)
        known[VISCOUS_STARTS + i] = u->known.past[i].v;
    return vector_rows_move(1, &fluid, VISCOUS_STARTS + VISCOUS_STAGES, known);
}

void viscous_guess(struct moment *m, double t, const double *z, double *v)
{
    const struct viscous *u = viscous_of(m);
    const struct viscous_past *node[NODES];
    const int n = choose(u, t, node);

    if (n == 0) {
        viscous_read(m, z, v);
        return;
    }
    memset(v, 0, (size_t)u->unknowns * sizeof *v);
    for (int i = 0; i < n; i++) {
        double weight = 1;
        for (int k = 0; k < n; k++)
            if (k != i)
                weight *= (t - node[k]->t) / (node[i]->t - node[k]->t);
        for (int k = 0; k < u->unknowns; k++)
            v[k] += weight * node[i]->v[k];
    }
}
