/* choice.c -- what decided on the length of a step, in words. */
#include "time/choice.h"

#include <stdio.h>

void choice_where(const struct choice *c, const struct moment *moment, char where[96])
{
    if (c->limiter == METHOD_OUTPUT)
        snprintf(where, 96, "end of the segment");
    else if (c->limiter == METHOD_STABILITY && c->limit.where >= 0)
        snprintf(where, 96, "%s, particle %d", c->limit.part, c->limit.where);
    else if (c->limiter == METHOD_STABILITY)
        snprintf(where, 96, "%s", c->limit.part);
    else if (c->refusal[0])
        snprintf(where, 96, "refused: %.80s", c->refusal);
    else
        snprintf(where, 96, "%.95s", c->entry >= 0 ? moment_entry(moment, c->entry) : "first step");
}
