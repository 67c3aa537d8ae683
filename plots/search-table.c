/* search-table.c -- what a search for neighbours costs, against the number of particles: that of
 * Toth (2012), section 3.7, which compares the coordinates of a particle with those of all
 * others, and the list of this program; beside them one sum over the pairs found.
 *
 * `search-table [KERNEL]` writes CSV to stdout: particles, mean neighbours, mean candidates of the
 * comparison, CPU seconds of all comparisons, of making the list anew, of one sum of W over its
 * pairs.  Particles lie on a shaken square lattice, the support is 2.52 spacings: his 20
 * neighbours.  The least of nine times, on one thread (OMP_NUM_THREADS=1). */
#include "plan/engine.h"

#include "base/status.h"
#include "kernels/kernel.h"
#include "space/record.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { ROUNDS = 9, LARGEST = 283 };
static const double support = 2.52;

struct water {
    int n, side;
    double (*x)[DIM];
    double *record, *ones, *sum;
};

static double cpu(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void *room(size_t bytes)
{
    void *memory = aligned_alloc(64, (bytes + 63) / 64 * 64);

    if (!memory)
        exit(1);
    memset(memory, 0, bytes);
    return memory;
}

static struct water make(int side)
{
    struct water w = { .n = side * side, .side = side };

    w.x = room((size_t)w.n * sizeof *w.x);
    w.record = room((size_t)(w.n + 1) * RECORD * sizeof *w.record);
    w.ones = room((size_t)(w.n + 1) * sizeof *w.ones);
    w.sum = room((size_t)w.n * sizeof *w.sum);
    srand(1);
    for (int i = 0; i < w.n; i++) {
        w.x[i][0] = i % side + 0.2 * rand() / RAND_MAX;
        w.x[i][1] = i / side + 0.2 * rand() / RAND_MAX;
    }
    return w;
}

/* Both coordinates nearer than the support: candidates of all particles, as in figure 9. */
static long compare(const struct water *w, int *candidate)
{
    long found = 0;

    for (int i = 0; i < w->n; i++) {
        int n = 0;
        for (int j = 0; j < w->n; j++) {
            candidate[n] = j;
            n += (fabs(w->x[j][0] - w->x[i][0]) < support)
               & (fabs(w->x[j][1] - w->x[i][1]) < support);
        }
        found += n;
    }
    return found;
}

static void fill_records(const struct water *w, const struct list *l)
{
    for (int s = 0; s <= l->listed; s++) {
        double *r = w->record + (size_t)s * RECORD;
        const double *x = s < l->listed ? w->x[l->order[s]] : (double[DIM]){ 1e6, 1e6 };
        r[RECORD_X] = x[0];
        r[RECORD_X + 1] = x[1];
        r[RECORD_M] = 1;
        w->ones[s] = s < l->listed;
    }
}

static double least(double a, double b)
{
    return a < b ? a : b;
}

static void row(int side, const struct kernel *kernel)
{
    const struct engine *e = engine_pick();
    const struct list_engine *lists = e->sum->list;
    struct water w = make(side);
    struct list_def def = { .support = support, .skin = 0, .low = { -1, -1 },
                            .high = { side + 1, side + 1 } };
    struct cloud cloud = { .x = { [KIND_FLUID] = w.x[0] } };
    const struct kernel_use use = kernel_use_make(kernel, support, DIM);
    const unsigned meets[KINDS] = { [KIND_FLUID] = KIND_BIT(KIND_FLUID) };
    double time[3] = { HUGE_VAL, HUGE_VAL, HUGE_VAL };
    int *candidate = room((size_t)(w.n + 1) * sizeof *candidate);
    struct list *l;
    long near = 0, found = 0;

    for (int k = KIND_FLUID + 1; k <= KINDS; k++)
        def.from[k] = cloud.from[k] = w.n;
    def.acts[KIND_FLUID] = meets[KIND_FLUID];
    if (lists->create(&l, &def) != STATUS_DONE)
        exit(1);
    for (int k = 0; k < ROUNDS; k++) {
        const struct nabla_job job = { l, w.record, meets, &use };
        double t = cpu();
        list_forget(l);
        lists->update(l, &cloud);
        time[1] = least(time[1], cpu() - t);
        fill_records(&w, l);
        t = cpu();
        e->nabla->weights(&job, KIND_BIT(KIND_FLUID), w.ones, w.sum);
        time[2] = least(time[2], cpu() - t);
        if (k > 0 && w.n > 20000)
            continue;
        t = cpu();
        found = compare(&w, candidate);
        time[0] = least(time[0], cpu() - t);
    }
    for (int i = 0; i < w.n; i++)
        for (int j = i + 1; j < w.n && j / side - w.x[i][1] < support; j++)
            near += 2 * (hypot(w.x[j][0] - w.x[i][0], w.x[j][1] - w.x[i][1]) < support);
    printf("%d,%.4g,%.4g,%.4g,%.4g,%.4g\n", w.n, (double)near / w.n, (double)found / w.n - 1,
           time[0], time[1], time[2]);
    fflush(stdout);
    lists->free(&l);
    free(w.x), free(w.record), free(w.ones), free(w.sum), free(candidate);
}

static const struct kernel *find(const char *name)
{
    const struct kernel *const *all = engine_pick()->kernels;

    for (int i = 0; all[i]; i++)
        if (strcmp(all[i]->name, name) == 0)
            return all[i];
    fprintf(stderr, "search-table: there is no kernel %s\n", name);
    exit(2);
}

int main(int argc, char **argv)
{
    const struct kernel *kernel = find(argc > 1 ? argv[1] : "wendland-c2");

    puts("particles,neighbours,candidates,comparing,list,sum");
    for (double side = 25; side <= LARGEST; side *= sqrt(2))
        row((int)round(side), kernel);
    return 0;
}
