/* pairs.c -- how fast the pair engine is: sorting and building the list, the
 * check, and the sum over pairs, by number of particles, neighbours, skin, lane
 * width and effects.
 *
 * The fluid is a jittered lattice in a full box; the effects are the standard
 * ones (continuity, pressure, artificial viscosity, density diffusion) with
 * Wendland C2.  User CPU on one thread, median of 7, in ns per particle; "all"
 * adds the list at the share of right-hand sides that rebuild it, which was
 * measured in dam breaks: 28, 20, 11 % at skins of 0.05, 0.1, 0.2 H.  Packing
 * and unpacking y are not in it (about 7 ns).  The hash is that of all rates:
 * equal in every line of one case and skin, and on 1, 2 and 4 threads. */
#include "effects/effects.h"
#include "plan/engine.h"
#include "space/kernel.h"
#include "space/record.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#ifdef _OPENMP
#include <omp.h>
#endif

enum { REPEATS = 7, EFFECTS = 4, SPACE = 4096 };

static const double SKINS[] = { 0.05, 0.1, 0.2 }, SHARES[] = { 0.28, 0.20, 0.11 };
static const char *const NAMES[EFFECTS] = {
    "continuity", "pressure", "artificial-viscosity", "density-diffusion"
};

/* One fluid, and one engine at work on it. */
struct bench {
    const struct engine *engine;
    int n, effects;
    double dx, support, skin;          /* [m]                                 */
    double *x, *shifted;               /* [n][DIM]; the latter forces rebuilds */
    struct list *list;
    struct cloud cloud;
    double *record, *f, *drho, power[EFFECTS + 1];
    struct kernel_use kernel;
    struct pairs_table table[KINDS * KINDS];
    struct sum_scratch scratch;
    char self[EFFECTS][SPACE];
};

static void *room(size_t bytes)
{
    void *memory = aligned_alloc(64, (bytes + 127) / 64 * 64);

    if (!memory) {
        fprintf(stderr, "no memory for the benchmark\n");
        exit(1);
    }
    memset(memory, 0, bytes);
    return memory;
}

static uint64_t seed;

/* From -0.5 to 0.5: linear congruence with Knuth's constants. */
static double noise(void)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(seed >> 11) / (double)(UINT64_C(1) << 53) - 0.5;
}

/* A square (cube) of about n particles, each up to 0.15 dx off its place. */
static void fill(struct bench *b, int n)
{
    const int side = (int)lround(pow(n, 1.0 / DIM));

    seed = 1;
    b->dx = 1.0 / side;
    b->n = (int)lround(pow(side, DIM));
    b->x = room((size_t)b->n * DIM * sizeof(double));
    b->shifted = room((size_t)b->n * DIM * sizeof(double));
    for (int i = 0; i < b->n; i++)
        for (int d = 0, left = i; d < DIM; d++, left /= side)
            b->x[i * DIM + d] = b->dx * (left % side + 0.5 + 0.3 * noise());
}

static void make_list(struct bench *b)
{
    struct list_def def = { .acts = { KIND_BIT(KIND_FLUID) }, .support = b->support,
                            .skin = b->skin };

    for (int d = 0; d < DIM; d++) {
        def.low[d] = -1;
        def.high[d] = 2;
    }
    for (int k = 1; k <= KINDS; k++)
        def.from[k] = b->n;
    memcpy(b->cloud.from, def.from, sizeof def.from);
    b->cloud.x[KIND_FLUID] = b->x;
    for (int i = 0; i < b->n * DIM; i++)
        b->shifted[i] = b->x[i] + b->skin;
    if (b->engine->sum->list->create(&b->list, &def)
        || b->engine->sum->list->update(b->list, &b->cloud))
        exit(1);
}

static const struct part *effect(const struct engine *engine, const char *name)
{
    for (int i = 0; engine->effects[i]; i++)
        if (strcmp(engine->effects[i]->name, name) == 0)
            return engine->effects[i];
    fprintf(stderr, "there is no effect %s\n", name);
    exit(1);
}

/* A law of nothing: what the engine costs without effects. */
static void idle(const void *self, const struct side *a, const struct block *b, struct sum *to)
{
    (void)self;
    (void)a;
    (void)b;
    (void)to;
}

static void add_effect(struct bench *b, const char *name, const struct scales *scales)
{
    const struct part *part = effect(b->engine, name);
    struct pairs_table *t = &b->table[KIND_FLUID * KINDS + KIND_FLUID];
    char *self = b->self[t->n - 1];

    for (const struct param *p = part->params; p && p->key; p++)
        if (p->type == PARAM_NUMBER)
            memcpy(self + p->offset, &p->fallback, sizeof(double));
    if (part->prepare && part->prepare(self, scales))
        exit(1);
    t->needs |= part->rows;
    t->work[t->n] = (struct pairs_work){ part->pairs, self, &b->kernel, t->n };
    t->n++;
}

static void make_table(struct bench *b)
{
    const struct scales scales = {
        .dimension = DIM, .dx = b->dx, .support = b->support, .hs = b->support / 2,
        .mass = 1000 * pow(b->dx, DIM), .rho0 = 1000, .c0 = 40, .gamma = 7, .speed = 4,
        .g = { [DIM - 1] = -9.81 }, .high = { 1, 1, 1 }, .fluid = true,
    };
    const struct kernel *kernel = b->engine->kernels[0];
    struct pairs_table *t = &b->table[KIND_FLUID * KINDS + KIND_FLUID];

    b->kernel = (struct kernel_use){ kernel, b->support,
                                     kernel->sigma[DIM] / pow(b->support, DIM) };
    memset(t, 0, sizeof *t);
    t->needs = NEED_GRADW | NEED_XV | NEED_RHO;
    t->work[t->n++] = (struct pairs_work){ idle, NULL, &b->kernel, 0 };
    for (int i = 0; i < b->effects; i++)
        add_effect(b, NAMES[i], &scales);
}

/* Records in the list's order: a swirl of water. */
static void pack(struct bench *b)
{
    for (int s = 0; s <= b->n; s++) {
        double *r = b->record + (size_t)s * RECORD;
        const double *x = s < b->n ? b->x + (size_t)b->list->order[s] * DIM : NULL;
        const double rho = s < b->n ? 1000 + 5 * sin(9 * x[0]) + 10 * (1 - x[DIM - 1]) : 1;

        r[RECORD_X] = x ? x[0] : 1e30;
        r[RECORD_X + 1] = x ? x[1] : 0;
        r[RECORD_V] = x ? sin(3 * x[0]) : 0;
        r[RECORD_V + 1] = x ? cos(5 * x[1]) : 0;
#if DIM == 3
        r[RECORD_Z] = x ? x[2] : 0;
        r[RECORD_VZ] = x ? x[0] * x[1] : 0;
#endif
        r[RECORD_RHO] = rho;
        r[RECORD_IRHO] = 1 / rho;
        r[RECORD_P2] = 1600 * (rho - 1000) / (rho * rho);
        r[RECORD_M] = x ? 1000 * pow(b->dx, DIM) : 1;
    }
}

static void add_up(struct bench *b)
{
    const struct sum_job job = {
        .list = b->list, .record = b->record, .table = b->table, .slots = EFFECTS + 1,
        .f = b->f, .drho = b->drho, .power = b->power,
    };

    if (b->engine->sum->pairs(&job, &b->scratch))
        exit(1);
}

static void check_only(struct bench *b)
{
    if (b->engine->sum->list->stale(b->list, &b->cloud))
        exit(1);
}

static void rebuild(struct bench *b)
{
    const double *x = b->cloud.x[KIND_FLUID];

    b->cloud.x[KIND_FLUID] = x == b->x ? b->shifted : b->x;
    if (b->engine->sum->list->update(b->list, &b->cloud))
        exit(1);
}

static double cpu(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int ascending(const void *l, const void *r)
{
    const double *a = l, *b = r;

    return (*a > *b) - (*a < *b);
}

/* Median of 7 of ns per particle; a repeat is an even number of calls. */
static double time_of(struct bench *b, void (*call)(struct bench *b))
{
    const int calls = 2 * (int)ceil(2e5 / b->n);
    double ns[REPEATS];

    for (int r = 0; r < REPEATS; r++) {
        const double start = cpu();

        for (int i = 0; i < calls; i++)
            call(b);
        ns[r] = 1e9 * (cpu() - start) / calls / b->n;
    }
    qsort(ns, REPEATS, sizeof *ns, ascending);
    return ns[REPEATS / 2];
}

static uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t n)
{
    for (const unsigned char *p = bytes; n--; p++)
        hash = (hash ^ *p) * UINT64_C(1099511628211);
    return hash;
}

/* FNV-1a of all that the sum gave. */
static uint64_t hash_of(const struct bench *b)
{
    uint64_t hash = hash_bytes(UINT64_C(14695981039346656037), b->f,
                               (size_t)b->n * DIM * sizeof(double));

    hash = hash_bytes(hash, b->drho, (size_t)b->n * sizeof(double));
    return hash_bytes(hash, b->power, sizeof b->power);
}

static void use_threads(int n)
{
#ifdef _OPENMP
    omp_set_num_threads(n);
#else
    (void)n;
#endif
}

static const char *threads_agree(struct bench *b, uint64_t hash)
{
    for (int threads = 2; threads <= 4; threads *= 2) {
        use_threads(threads);
        add_up(b);
        if (hash_of(b) != hash)
            return "DIFFERS ON THREADS";
    }
    use_threads(1);
    return "";
}

/* Useful neighbours of a particle, and entries of its rows. */
static void count(const struct bench *b, double *useful, double *entries)
{
    const struct list *list = b->list;
    const double limit = b->support * b->support;
    long n = 0;

    for (int g = 0; g < list->groups; g++)
        for (int s = list->segment_from[g]; s < list->segment_from[g + 1]; s++)
            for (int k = 0; k < list->segment[s].rows * list->lanes; k++) {
                const double *a = b->record
                                + (size_t)(list->group_slot[g] + k % list->lanes) * RECORD;
                const double *o = b->record + (size_t)list->segment[s].j[k] * RECORD;
                double r2 = 0;

                for (int d = 0; d < DIM; d++)
                    r2 += (a[d] - o[d]) * (a[d] - o[d]);
                n += r2 < limit;
            }
    *useful = (double)n / b->n;
    *entries = (double)list->rows_before[list->groups] * list->lanes / b->n;
}

static void report(struct bench *b, double share)
{
    double useful, entries;

    pack(b);
    make_table(b);
    const double sum = time_of(b, add_up), check = time_of(b, check_only);
    const uint64_t hash = hash_of(b);
    const char *threads = threads_agree(b, hash);
    count(b, &useful, &entries);
    const double build = time_of(b, rebuild), all = sum + check + share * build;

    printf("%dD %8d %5d %5.2f %5d %7d %6.1f %7.2f %7.1f %6.2f %6.1f %6.1f %6.1f  %016" PRIx64
           " %s\n", DIM, b->n, b->engine->lanes, b->skin / b->support, b->effects,
           (int)lround(100 * b->support / b->dx), useful, entries / useful, build, check, sum, all,
           1e3 / all, hash, threads);
    fflush(stdout);
}

static void run(const struct engine *engine, int n, double ratio, int skin, int effects)
{
    struct bench *b = room(sizeof *b);

    b->engine = engine;
    b->effects = effects;
    fill(b, n);
    b->support = ratio * b->dx;
    b->skin = SKINS[skin] * b->support;
    make_list(b);
    b->record = room(((size_t)b->n + 1) * RECORD * sizeof(double));
    b->f = room((size_t)b->n * DIM * sizeof(double));
    b->drho = room((size_t)b->n * sizeof(double));
    report(b, SHARES[skin]);
    engine->sum->list->free(&b->list);
    free(b->scratch.power);
    free(b->record);
    free(b->f);
    free(b->drho);
    free(b->x);
    free(b->shifted);
    free(b);
}

static void run_all(const struct engine *engine)
{
#if DIM == 2
    for (int skin = 0; skin < 3; skin++)
        run(engine, 50000, 2.52, skin, EFFECTS);
    run(engine, 5000, 2.52, 1, EFFECTS);
    run(engine, 500000, 2.52, 1, EFFECTS);
    run(engine, 50000, 3, 0, EFFECTS);
    run(engine, 50000, 3, 1, EFFECTS);
    for (int effects = 0; effects < EFFECTS; effects++)
        run(engine, 50000, 2.52, 0, effects);
#else
    for (int skin = 0; skin < 3; skin++)
        run(engine, 50000, 2.5, skin, EFFECTS);
    run(engine, 50000, 2.5, 0, 0);
#endif
}

static void head(void)
{
    double load = 0;

    printf("pair engine, user CPU on one thread, median of %d, ns per particle\n", REPEATS);
    if (getloadavg(&load, 1) == 1 && load > 0.5)
        printf("WARNING: others are at work (load %.1f): numbers are too high\n", load);
    printf("%2s %8s %5s %5s %5s %7s %6s %7s %7s %6s %6s %6s %6s  %s\n", "", "n", "lanes", "skin",
           "laws", "H/dx %", "nb", "entries", "build", "check", "sum", "all", "M/s", "hash");
}

int main(void)
{
    const struct engine *best = engine_pick();

    use_threads(1);
    head();
    run_all(best);
    setenv("STIFFWATER_LANES", "2", 1);
    if (engine_pick() != best)
        run_all(engine_pick());
    return 0;
}
