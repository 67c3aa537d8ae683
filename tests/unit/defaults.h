/* defaults.h -- parameters as a scene would fill them, and numbers by chance, for tests. */
#ifndef TESTS_UNIT_DEFAULTS_H
#define TESTS_UNIT_DEFAULTS_H

#include "base/param.h"

#include <stdbool.h>

static inline double noise(unsigned *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (*seed >> 8) / 8388608.0 - 1;
}

/* Defaults of the rows, as a scene would fill them. */
static inline void fill_defaults(const struct param *rows, void *into)
{
    for (const struct param *r = rows; r->key; r++) {
        char *to = (char *)into + r->offset;
        if (r->type == PARAM_NUMBER)
            *(double *)(void *)to = r->fallback;
        else if (r->type == PARAM_INTEGER)
            *(int *)(void *)to = (int)r->fallback;
        else if (r->type == PARAM_FLAG)
            *(bool *)(void *)to = r->fallback != 0;
        else if (r->type == PARAM_WORD)
            *(const char **)(void *)to = r->words[0];
    }
}

#endif
