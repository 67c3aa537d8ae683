/* kernels.c -- looks kernels up.  struct kernel has the same layout at every
 * lane width (function pointers only), so one compiled width reads both. */
#include "plan/kernels.h"

#include "base/status.h"
#define LANES 2
#include "space/kernel.h"

#include <math.h>
#include <string.h>

void kernels_names(const struct engine *engine, const char **names, int most)
{
    int n = 0;

    while (engine->kernels[n] && n < most - 1) {
        names[n] = engine->kernels[n]->name;
        n++;
    }
    names[n] = NULL;
}

void kernels_list(const struct engine *engine, FILE *to)
{
    for (int i = 0; engine->kernels[i]; i++)
        fprintf(to, "%-22s %s\n", engine->kernels[i]->name, engine->kernels[i]->about);
}

static const struct kernel *find(const struct engine *engine, const char *name)
{
    for (int i = 0; engine->kernels[i]; i++)
        if (strcmp(engine->kernels[i]->name, name) == 0)
            return engine->kernels[i];
    return NULL;
}

bool kernels_explain(const struct engine *engine, const char *name, FILE *to)
{
    const struct kernel *k = find(engine, name);

    if (!k)
        return false;
    fprintf(to, "%s -- %s\n  W(r) = sigma/H^D w(r/H), sigma = %.6g in 2D, %.6g in 3D\n"
            "  source: %s\n", k->name, k->about, k->sigma[2], k->sigma[3], k->source);
    return true;
}

struct kernel_use *kernels_use(const struct engine *engine, const char *name, double support)
{
    struct kernel_use *use = status_alloc(1, sizeof *use);

    if (!use)
        return NULL;
    use->kernel = find(engine, name);
    use->support = support;
    use->scale = use->kernel->sigma[DIM] / pow(support, DIM);
    return use;
}
