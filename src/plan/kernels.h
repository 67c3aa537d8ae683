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

/* The kernels of a scene, one for each use; names[k] "same" means `type`.  Uses
 * with the same kernel share it.  STATUS_FAILED without memory. */
int kernels_make(const struct engine *engine, const char *type,
                 const char *const names[PART_KERNELS], double support,
                 struct kernel_use *use[PART_KERNELS]);
void kernels_free(struct kernel_use *use[PART_KERNELS]);

/* The same with the rows that sums of pairs take: laws[] is use[] itself, or has uses of its
 * own for pairs in another precision.  STATUS_FAILED without memory. */
int kernels_laws(const struct engine *engine, struct kernel_use *const use[PART_KERNELS],
                 struct kernel_use *laws[PART_KERNELS]);

/* Sets wave, laplace_*, laplacian and centre of s; its dx is known. */
void kernels_scales(const struct engine *engine, struct kernel_use *const use[PART_KERNELS],
                    struct scales *s);

/* NULL, or what forbids the kernel of its use to a part: its name in *kernel. */
const char *kernels_forbid(struct kernel_use *const use[PART_KERNELS], const struct part *part,
                           const char **kernel);

#endif
