/* elastica-swing.c -- methods on the program's own beam that bends far: a free swing keeps
 * its energy, the tip converges, and a solve that finds nothing is a refusal. */
#include "eval/observe.h"
#include "plan/plan.h"

#include "base/status.h"
#include "scene/scene.h"
#include "time/method.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

struct swing { /* of data/scenes/elastica.scene, nearly half a period */
    double defect;  /* largest change of energy over the energy          */
    double tip;     /* across, at the end [m]                            */
    long solves;
};

static const struct plan *plan_of(struct scene **scene)
{
    const struct plan *plan;
    char path[1024];

    snprintf(path, sizeof path, "%s/data/scenes/elastica.scene",
             getenv("top_srcdir") ? getenv("top_srcdir") : ".");
    if (scene_read(path, scene) != STATUS_DONE || plan_create(*scene, &plan) != STATUS_DONE)
        fail_msg("%s", status_message());
    return plan;
}

static struct swing swing(const char *name, double tol)
{
    struct method_def def = method_def_default();
    const struct method *method;
    struct method_step step = { .t = 0 };
    struct book_sheet sheet;
    struct body_view view;
    struct swing out = {0};
    struct scene *scene;
    const struct plan *plan = plan_of(&scene);
    struct moment *moment;
    double *y = test_calloc((size_t)plan_size(plan), sizeof *y), energy;
    void *self;

    assert_int_equal(method_find(name, &def, &method), STATUS_DONE);
    def.tol = tol;
    if (moment_create(plan, &moment) != STATUS_DONE)
        fail_msg("%s", status_message());
    plan_start(plan, y);
    observe_sheet(moment, 0, y, &sheet);
    energy = sheet.total;
    if (method->create(method, &def, moment, 0, y, &self) != STATUS_DONE)
        fail_msg("%s", status_message());
    while (step.t < 0.4) {
        if (method->step(self, 0.4, &step) != STATUS_DONE)
            fail_msg("%s", status_message());
        observe_sheet(moment, step.t, method->state(self), &sheet);
        out.defect = fmax(out.defect, fabs(sheet.total / energy - 1));
    }
    assert_int_equal(observe_forces(moment, 0.4, method->state(self)), STATUS_DONE);
    observe_body(moment, 0, 0.4, method->state(self), &view);
    out.tip = view.tip[1];
    out.solves = moment_counts(moment)->solves;
    method->free(&self);
    test_free(y);
    moment_free(&moment);
    plan_free(&plan);
    scene_free(&scene);
    return out;
}

static void check(const char *name, double tol, double exact, double defect, double off)
{
    const struct swing s = swing(name, tol);

    if (!(s.defect < defect && fabs(s.tip - exact) < off))
        fail_msg("%s at %g: energy defect %g, the tip is off by %g m", name, tol, s.defect,
                 s.tip - exact);
}

/* Against a method that takes the same beam explicitly and solves nothing. */
static void a_free_swing_keeps_its_energy(void **state)
{
    const struct swing exact = swing("ark436", 1e-2);

    (void)state;
    if (!(exact.defect < 1e-6 && exact.tip < -0.2 && exact.solves == 0))
        fail_msg("ark436: energy defect %g, tip at %g m", exact.defect, exact.tip);
    check("imex3", 1e-2, exact.tip, 1e-2, 3e-4);
    check("imex3", 1e-3, exact.tip, 1e-3, 1e-4);
    check("imex4", 1e-2, exact.tip, 5e-4, 1e-4);
    check("imex4", 1e-3, exact.tip, 3e-5, 1e-5);
    check("imex5", 1e-3, exact.tip, 4e-4, 1e-5);
    check("bdf", 1e-2, exact.tip, 1e-2, 3e-4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_free_swing_keeps_its_energy),
    };

    return cmocka_run_group_tests_name("elastica-swing", tests, NULL, NULL);
}
