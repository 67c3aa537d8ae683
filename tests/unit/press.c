/* press.c -- walls = "contact" asked for other solids than before: what it leaves in its arrays is what it
 * leaves in new ones, whoever looked at solids of a rank in between; slices have what stands together. */
#include "../physics/tank.h"

#include "plan/inside.h"
#include "walls/contact-press.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ASKED = 3 }; /* thirds of the solids, one after the other */

/* Arrays that a press() fills, [solids]. */
struct filled {
    double *shown, *p2;
};

struct bench {
    struct tank tank;
    const struct plan_part *wall;
    const struct part_press *press;
    struct part_press_work *work;
    struct particles particles; /* of the tank, but for rows */
    int solids, *row;           /* row [solids] for those */
    double *rho;                /* [solids] */
    bool *met;
};

static struct filled take(const struct bench *b)
{
    return (struct filled){ calloc((size_t)b->solids, sizeof(double)), calloc((size_t)b->solids, sizeof(double)) };
}

static void drop(struct filled *f)
{
    free(f->shown);
    free(f->p2);
}

static void set_up(struct bench *b)
{
    unsigned seed = 5;

    tank_make(&b->tank, tank_bare_water, tank_frame, "walls = \"contact\";" TANK_EFFECTS TANK_ONE_KERNEL, NULL);
    b->wall = b->tank.plan->passes.press;
    b->press = b->wall->part->as.wall->press;
    b->solids = b->tank.plan->particles->n - b->tank.plan->particles->from[KIND_WALL];
    b->particles = *b->tank.plan->particles;
    b->row = calloc((size_t)b->solids, sizeof *b->row);
    b->rho = calloc((size_t)b->solids, sizeof *b->rho);
    b->met = calloc((size_t)b->solids, sizeof *b->met);
    for (int i = 0; i < b->solids; i++)
        b->rho[i] = b->tank.plan->scales.rho0 * (1.02 + 0.01 * tank_random(&seed));
    assert_int_equal(b->press->work(b->wall->self, &b->work), 0);
}

static void tear_down(struct bench *b)
{
    b->press->work_free(&b->work);
    free(b->row);
    free(b->rho);
    free(b->met);
    tank_free(&b->tank);
}

static void choose(struct bench *b, enum part_solids which, int third)
{
    for (int i = 0; i < b->solids; i++)
        b->met[i] = i * ASKED / b->solids == third;
    b->press->choose(b->wall->self, b->work, which, b->met);
}

static void ask(struct bench *b, int third)
{
    choose(b, PART_SOLIDS_MET, third);
}

/* Walls stand in another order from now on: `turn` places on. */
static void rearrange(struct bench *b, int turn)
{
    for (int i = 0; i < b->solids; i++)
        b->row[i] = (i + turn) % b->solids;
    b->particles.row[KIND_WALL] = b->row;
}

/* What solids show: rho becomes that. */
static void look(struct bench *b, enum part_solids which, double *rho)
{
    const struct part_pressed io = { .rho = rho, .shown = rho, .which = which };

    memcpy(rho, b->rho, (size_t)b->solids * sizeof *rho);
    b->press->press(b->wall->self, b->work, &b->particles, &io);
}

static void fill_with(struct bench *b, enum part_solids which, const struct filled *f)
{
    const struct part_pressed io = { .rho = b->rho, .shown = f->shown, .p2 = f->p2, .which = which };

    b->press->press(b->wall->self, b->work, &b->particles, &io);
}

static void fill(struct bench *b, const struct filled *f)
{
    fill_with(b, PART_SOLIDS_MET, f);
}

static bool are_alike(const struct bench *b, const struct filled *f, const struct filled *g)
{
    const size_t bytes = (size_t)b->solids * sizeof *f->shown;

    return memcmp(f->shown, g->shown, bytes) == 0 && memcmp(f->p2, g->p2, bytes) == 0;
}

static int pressing(const struct bench *b, const struct filled *f)
{
    int n = 0;

    for (int i = 0; i < b->solids; i++)
        n += f->p2[i] > 0;
    return n;
}

static void arrays_are_as_new(void **state)
{
    struct bench b;
    struct filled old;

    (void)state;
    set_up(&b);
    old = take(&b);
    for (int third = 0; third < ASKED; third++)
        for (int again = 0; again < 2; again++) {
            struct filled anew = take(&b);
            ask(&b, third);
            fill(&b, &old);
            fill(&b, &old);
            fill(&b, &anew);
            check(pressing(&b, &anew) > 0 && pressing(&b, &anew) < b.solids, "%d of %d solids press",
                  pressing(&b, &anew), b.solids);
            check(are_alike(&b, &old, &anew), "third %d: %d solids press, of new arrays %d", third,
                  pressing(&b, &old), pressing(&b, &anew));
            fill(&b, &old);
            drop(&anew);
        }
    drop(&old);
    tear_down(&b);
}

/* Solids of a third show what they show among all. */
static void check_shown(const struct bench *b, int third, const double *own, const double *all)
{
    int n = 0, off = 0;

    for (int i = 0; i < b->solids; i++) {
        const int row = particles_row(&b->particles, KIND_WALL, i);
        if (i * ASKED / b->solids != third)
            continue;
        off += own[row] != all[row];
        n += all[row] != b->tank.plan->scales.rho0;
    }
    check(n > 0, "third %d shows nothing", third);
    check(off == 0, "%d solids of third %d show something else than among all", off, third);
}

static void looks_leave_forces_alone(void **state)
{
    struct bench b;
    struct filled old;
    double *own, *all;

    (void)state;
    set_up(&b);
    old = take(&b);
    own = calloc((size_t)b.solids, sizeof *own);
    all = calloc((size_t)b.solids, sizeof *all);
    for (int turn = 0; turn < 2 * ASKED; turn++) {
        struct filled anew = take(&b);
        ask(&b, turn % ASKED);
        fill(&b, &old);
        rearrange(&b, turn * b.solids / 7);
        choose(&b, PART_SOLIDS_OWN, turn / 2);
        look(&b, PART_SOLIDS_OWN, own);
        look(&b, PART_SOLIDS_ALL, all);
        check_shown(&b, turn / 2, own, all);
        ask(&b, (turn + 1) % ASKED);
        fill(&b, &old);
        fill(&b, &anew);
        check(are_alike(&b, &old, &anew), "turn %d: %d solids press, of new arrays %d", turn, pressing(&b, &old),
              pressing(&b, &anew));
        fill(&b, &old);
        if (turn % 2) /* the next of those that are met must not take it for its own */
            fill_with(&b, PART_SOLIDS_ALL, &old);
        drop(&anew);
    }
    free(own);
    free(all);
    drop(&old);
    tear_down(&b);
}

/* The longest side of a box around a slice [m]. */
static double side_of(const struct bench *b, const struct contact_mean *m, int slice)
{
    const double (*x)[DIM] = (const double (*)[DIM])(b->particles.x0 + b->particles.from[KIND_WALL]);
    double side = 0;

    for (int i = slice * CONTACT_ROWS; i < m->n && i < (slice + 1) * CONTACT_ROWS; i++)
        for (int d = 0; d < DIM; d++)
            side = fmax(side, fabs(x[m->solid[i]][d] - x[m->solid[slice * CONTACT_ROWS]][d]));
    return side;
}

/* But for those in which Morton's curve leaps. */
static void slices_stand_together(void **state)
{
    struct bench b;
    int wide = 0;

    (void)state;
    set_up(&b);
    const struct contact_mean *m = &((const struct contact_press_self *)b.wall->self)->mean;
    for (int s = 0; s < m->slices; s++)
        wide += side_of(&b, m, s) > 3.1 * b.tank.plan->scales.dx;
    print_message("# %d of %d slices are wide\n", wide, m->slices);
    check(m->slices > 20 && wide * 5 < m->slices, "%d of %d slices are wide", wide, m->slices);
    for (int k = 1; k < m->n; k++)
        check(m->solid[m->by_solid[k]] > m->solid[m->by_solid[k - 1]], "solid %d of %d is out of turn", k, m->n);
    tear_down(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(arrays_are_as_new),
                                        cmocka_unit_test(looks_leave_forces_alone),
                                        cmocka_unit_test(slices_stand_together) };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
