/* press.c -- walls = "contact" asked for other solids than before: what it leaves in its arrays is what it
 * leaves in new ones. */
#include "../physics/tank.h"

#include "plan/inside.h"

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
    int solids;
    double *rho; /* [solids] */
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
    b->rho = calloc((size_t)b->solids, sizeof *b->rho);
    b->met = calloc((size_t)b->solids, sizeof *b->met);
    for (int i = 0; i < b->solids; i++)
        b->rho[i] = b->tank.plan->scales.rho0 * (1.02 + 0.01 * tank_random(&seed));
    assert_int_equal(b->press->work(b->wall->self, &b->work), 0);
}

static void tear_down(struct bench *b)
{
    b->press->work_free(&b->work);
    free(b->rho);
    free(b->met);
    tank_free(&b->tank);
}

static void ask(struct bench *b, int third)
{
    for (int i = 0; i < b->solids; i++)
        b->met[i] = i * ASKED / b->solids == third;
    b->press->narrow(b->wall->self, b->work, b->met);
}

static void fill(struct bench *b, const struct filled *f)
{
    const struct part_pressed io = { .rho = b->rho, .shown = f->shown, .p2 = f->p2 };

    b->press->press(b->wall->self, b->work, b->tank.plan->particles, &io);
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

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(arrays_are_as_new) };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
