/* group.h -- groups of keys inside of a body, as in body = { NAME = { hinge = { ... }; }; }. */
#ifndef BODIES_GROUP_H
#define BODIES_GROUP_H

#include "base/param.h"

#include <stdio.h>

enum { GROUP_KEY = 80 };

struct body_group {
    const char *name, *about;   /* name NULL: the end of a table                   */
    const struct param *params;
    size_t at, count;           /* of values and of the number of them (int), in the
                                   body's parameters                               */
    size_t size;                /* of one                                          */
    int most;                   /* 1: the keys stand in the group itself; more: in named
                                   groups inside of it, and values begin with the name,
                                   a const char * that the scene owns              */
};

/* "hinge.at", "spring.NAME.on", for readers; room [GROUP_KEY]. */
static inline const char *group_key(const struct body_group *g, const char *key, char *room)
{
    snprintf(room, GROUP_KEY, "%s%s.%s", g->name, g->most > 1 ? ".NAME" : "", key);
    return room;
}

#endif
