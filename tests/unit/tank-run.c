/* tank-run.c -- a tank that runs for a while. */
#include "tank-run.h"

#include "base/status.h"
#include "time/method.h"

#include <string.h>

void tank_run(struct tank *t, const char *name, double tol, double until)
{
    struct method_def method = method_def_default();
    struct method_step step = { 0 };
    const struct method *m;
    void *self;

    assert_int_equal(method_find(name, &method, &m), STATUS_DONE);
    method.tol = tol;
    if (m->create(m, &method, t->moment, 0, t->y, &self) != STATUS_DONE)
        fail_msg("%s: %s", name, status_message());
    while (step.t < until)
        if (m->step(self, until, &step) != STATUS_DONE)
            fail_msg("%s: %s", name, status_message());
    memcpy(t->y, m->state(self), (size_t)t->n * sizeof *t->y);
    m->free(&self);
}
