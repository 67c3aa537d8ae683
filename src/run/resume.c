/* resume.c -- goes on with a run from its last checkpoint. */
#include "run/checkpoint.h"

#include "base/status.h"
#include "output/aside.h"
#include "ranks/ranks.h"
#include "run/saved.h"

#include <stdio.h>
#include <string.h>

/* Another setting would make another run of it. */
static int check_settings(const struct run_order *order)
{
    for (int i = 0; i < order->overrides; i++)
        if (strncmp(order->override[i], "until=", strlen("until=")) != 0)
            return status_fail(STATUS_BAD_SCENE, "%s: resume goes on with the run as it was; only "
                               "until=T can be set: for another run, `stiffwater run`",
                               order->override[i]);
    return STATUS_DONE;
}

static int go_on(const struct run_order *order, struct archive *a)
{
    char scene[ASIDE_PATH], until[64];
    const char *const as_before = until;
    struct run_order of = *order;
    double t;

    TRY(aside_join(scene, order->directory, "scene.used"));
    TRY(ranks_agree(checkpoint_check(order->directory, a, &t)));
    snprintf(until, sizeof until, "until=%.17g", t);
    of.scene = scene;
    if (order->overrides == 0) {
        of.overrides = 1;
        of.override = &as_before;
    }
    return run_carry_out(&of, a);
}

int run_resume(const struct run_order *order)
{
    struct archive *a = NULL;
    int status;

    TRY(check_settings(order));
    status = ranks_agree(saved_read(order->directory, &a));
    if (status == STATUS_DONE)
        status = go_on(order, a);
    archive_free(&a);
    return status;
}
