/* segments.c -- where segments of a run end: f jumps or y does, or contacts of other bodies are to
 * be remembered.  A checkpoint (checkpoint.c) ends one as well. */
#include "run/inside.h"

#include "base/status.h"

/* Where f jumps, or y does, a segment ends, and the method starts anew. */
static int jump(struct run *r)
{
    const double t = r->past.tally.t;

    if (t < r->event)
        return STATUS_DONE;
    r->event = plan_event(r->plan, t);
    moment_take(r->moment, r->method->state(r->self), r->y);
    TRY(moment_event(r->moment, t, r->y));
    return r->method->restart(r->self, t, r->y, NULL);
}

/* Bodies come near that have no place for what a contact remembers. */
static int settle(struct run *r)
{
    const double t = r->past.tally.t;

    if (!moment_lacks(r->moment, t, r->method->state(r->self)))
        return STATUS_DONE;
    moment_take(r->moment, r->method->state(r->self), r->y);
    TRY(moment_settle(r->moment, t, r->y));
    return r->method->restart(r->self, t, r->y, NULL);
}

int run_next_segment(struct run *r)
{
    TRY(jump(r));
    return settle(r);
}
