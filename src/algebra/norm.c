/* norm.c -- the norms by name. */
#include "algebra/norm.h"

#include <stddef.h>
#include <string.h>

const char *const vector_norm_words[] = {
    [VECTOR_NORM_MAX] = "max",
    [VECTOR_NORM_P8] = "p8",
    [VECTOR_NORM_WRMS] = "wrms",
    NULL
};

enum vector_norm vector_norm_of(const char *word)
{
    for (int i = 0; vector_norm_words[i]; i++)
        if (strcmp(vector_norm_words[i], word) == 0)
            return (enum vector_norm)i;
    return VECTOR_NORM_MAX;
}
