/* kernels.c -- looks kernels up, and says what they change in a scene's scales. */
#include "plan/kernels.h"

#include "base/status.h"
#include "kernels/kernel.h"
#include "space/laws.h"

#include <math.h>
#include <stdlib.h>
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

static struct kernel_use *use_of(const struct kernel *kernel, double support)
{
    struct kernel_use *use = status_alloc(1, sizeof *use);

    if (use)
        *use = kernel_use_make(kernel, support, DIM);
    return use;
}

int kernels_make(const struct engine *engine, const char *type,
                 const char *const names[PART_KERNELS], double support,
                 struct kernel_use *use[PART_KERNELS])
{
    for (int k = 0; k < PART_KERNELS; k++) {
        const struct kernel *kernel = find(engine, strcmp(names[k], "same") ? names[k] : type);

        for (int j = 0; j < k && !use[k]; j++)
            if (use[j]->kernel == kernel)
                use[k] = use[j];
        if (!use[k] && !(use[k] = use_of(kernel, support)))
            return STATUS_FAILED;
    }
    return STATUS_DONE;
}

void kernels_free(struct kernel_use *use[PART_KERNELS])
{
    for (int k = PART_KERNELS - 1; k >= 0; k--) {
        bool shared = false;
        for (int j = 0; j < k; j++)
            shared |= use[j] == use[k];
        if (!shared)
            free(use[k]);
        use[k] = NULL;
    }
}

static const struct kernel *twin(const struct engine *engine, const struct kernel *kernel)
{
    int i = 0;

    while (engine->kernels[i] != kernel)
        i++;
    return engine->law_kernels[i];
}

int kernels_laws(const struct engine *engine, struct kernel_use *const use[PART_KERNELS],
                 struct kernel_use *laws[PART_KERNELS])
{
    for (int k = 0; k < PART_KERNELS; k++) {
        laws[k] = engine->law_kernels == engine->kernels ? use[k] : NULL;
        for (int j = 0; j < k && !laws[k]; j++)
            if (use[j] == use[k])
                laws[k] = laws[j];
        if (!laws[k] && !(laws[k] = use_of(twin(engine, use[k]->kernel), use[k]->support)))
            return STATUS_FAILED;
    }
    return STATUS_DONE;
}

/* What one neighbour adds to an operator on the lattice for a plane wave. */
typedef double term(const struct kernel_use *use, double r, double along, double phase);

/* Of a gradient: W'(r) x/r sin(k x). */
static double gradient_term(const struct kernel_use *use, double r, double along, double phase)
{
    return kernel_gradient(use, r) * along / r * sin(phase);
}

/* Of a Laplacian made of gradients: 2 W'(r) r/(r^2 + eta^2) (1 - cos k x). */
static double laplace_term(const struct kernel_use *use, double r, double along, double phase)
{
    const double eta2 = 0.01 * use->support * use->support / 4;

    (void)along;
    return 2 * kernel_gradient(use, r) * r / (r * r + eta2) * (1 - cos(phase));
}

/* Of the Laplacian of the kernel, W'' + (D - 1) W'/r: lapW (1 - cos k x).  Rows of
 * the kernel cannot be asked here: they may be of another width. */
static double laplacian_term(const struct kernel_use *use, double r, double along, double phase)
{
    const double q = r / use->support, per_h2 = use->scale / (use->support * use->support);

    (void)along;
    return per_h2 * (use->kernel->ddw(q) + (DIM - 1) * use->kernel->dw(q) / q) * (1 - cos(phase));
}

/* The sum over the lattice for wave number k along an axis or a diagonal. */
static double lattice_sum(term *one, const struct kernel_use *use, double dx, double k,
                          bool diagonal)
{
    const int reach = (int)(use->support / dx) + 1, high = DIM == 3 ? reach : 0;
    const double e = diagonal ? 1 / sqrt(DIM) : 1;
    double sum = 0;

    for (int z = -high; z <= high; z++)
        for (int y = -reach; y <= reach; y++)
            for (int x = -reach; x <= reach; x++) {
                const double r = dx * sqrt(x * x + y * y + z * z);
                const double along = dx * e * (diagonal ? x + y + z : x);
                if (r > 0 && r < use->support)
                    sum += one(use, r, along, k * along);
            }
    return sum * pow(dx, DIM);
}

/* Largest eigenvalue of the operator on the lattice, in size. */
static double largest(term *one, const struct kernel_use *use, double dx)
{
    enum { WAVES = 24 };
    double most = 0;

    for (int i = 1; i <= WAVES; i++)
        for (int diagonal = 0; diagonal < 2; diagonal++) {
            const double k = M_PI / dx * i / WAVES * (diagonal ? sqrt(DIM) : 1);
            most = fmax(most, fabs(lattice_sum(one, use, dx, k, diagonal)));
        }
    return most;
}

void kernels_scales(const struct engine *engine, struct kernel_use *const use[PART_KERNELS],
                    struct scales *s)
{
    const struct kernel_use usual = kernel_use_make(engine->kernels[0], use[0]->support, DIM);
    const double wave = largest(gradient_term, &usual, s->dx);
    const double laplace = largest(laplace_term, &usual, s->dx);

    s->wave = sqrt(largest(gradient_term, use[PART_DENSITY], s->dx) / wave
                   * (largest(gradient_term, use[PART_PRESSURE], s->dx) / wave));
    s->laplace_density = largest(laplace_term, use[PART_DENSITY], s->dx) / laplace;
    s->laplace_viscosity = largest(laplace_term, use[PART_VISCOSITY], s->dx) / laplace;
    s->laplacian = largest(laplacian_term, use[PART_VISCOSITY], s->dx);
    s->centre = kernel_w(use[PART_DENSITY], 0);
    s->nearby = kernel_w(use[PART_PRESSURE], s->dx);
}

const char *kernels_forbid(struct kernel_use *const use[PART_KERNELS], const struct part *part,
                           const char **kernel)
{
    const struct part_law *law = part->as.law;

    *kernel = use[PART_DENSITY]->kernel->name;
    if (part->as.summed && use[PART_DENSITY]->kernel->singular)
        return "needs a kernel that is finite at its centre: set kernel.density";
    if (!law)
        return NULL;
    *kernel = use[law->kernel]->kernel->name;
    if ((law->rows & NEED_LAPW) && !use[law->kernel]->kernel->spreads)
        return "needs a kernel whose Laplacian is positive everywhere, or it drives the fluid "
               "instead of braking it: set kernel.viscosity = \"viscosity-log\"";
    return NULL;
}
