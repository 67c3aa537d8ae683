/* kernels.h -- kernels as rooms without lanes may see them. */
#ifndef PLAN_KERNELS_H
#define PLAN_KERNELS_H

#include "plan/engine.h"
#include <stdbool.h>
#include <stdio.h>

struct kernel_use;

/* Fills names (room for `most`, NULL-ended). */
void kernels_names(const struct engine *engine, const char **names, int most);
void kernels_list(const struct engine *engine, FILE *to);
bool kernels_explain(const struct engine *engine, const char *name, FILE *to);

/* A new kernel of that name (which exists) and support H [m]; NULL without
 * memory.  Free with free(). */
struct kernel_use *kernels_use(const struct engine *engine, const char *name, double support);

#endif
