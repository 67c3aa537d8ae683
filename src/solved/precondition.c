/* precondition.c -- all that a solve can be preconditioned with. */
#include "solved/precondition.h"

#include <string.h>

static const struct precondition *const table[] = { &precondition_ic0, &precondition_multigrid, NULL };

const struct precondition *precondition_named(const char *name)
{
    for (int i = 0; table[i]; i++)
        if (strcmp(table[i]->name, name) == 0)
            return table[i];
    return NULL;
}
