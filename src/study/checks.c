/* checks.c -- the scene at all points, whatever the method. */
#include "study/checks.h"

#include "base/status.h"
#include "study/crew.h"
#include "study/point.h"

#include <stdio.h>
#include <stdlib.h>

struct checks {
    struct study *study;
    struct member *member; /* [points] */
};

static struct member *member(void *self, int i)
{
    struct checks *c = self;

    return &c->member[i];
}

static char *settings(void *self, int i)
{
    const struct checks *c = self;

    return point_settings(c->study, &c->study->point[i]);
}

static int refuse(const struct study *s, const struct member *m)
{
    for (int i = 0; i < s->points; i++)
        if (m[i].code == STATUS_BAD_SCENE || m[i].code == STATUS_IO)
            return status_fail(m[i].code, "%s%s%s", s->point[i].label,
                               *s->point[i].label ? ": " : "", m[i].message);
    return STATUS_DONE;
}

int checks_run(struct study *s)
{
    struct member_home home = s->home;
    struct checks c = { s, status_alloc(s->points, sizeof *c.member) };
    const struct crew crew = {
        .home = &home, .what = "scenes checked", .n = s->points, .jobs = s->order->jobs,
        .quiet = s->order->quiet, .member = member, .settings = settings, .self = &c,
    };
    int status = c.member ? STATUS_DONE : STATUS_FAILED;

    home.command = "check";
    for (int i = 0; i < s->points && c.member; i++)
        snprintf(c.member[i].name, sizeof c.member[i].name, "check-%d", i + 1);
    if (status == STATUS_DONE)
        status = crew_run(&crew);
    if (status == STATUS_DONE)
        status = refuse(s, c.member);
    free(c.member);
    return status;
}
