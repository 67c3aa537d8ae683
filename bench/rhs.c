/* rhs.c -- how fast the whole right-hand side is, and where its time goes, by
 * number of particles, neighbours, Verlet margin, lane width and effects.
 *
 * A plan made from a scene (see water.h) answers moment_eval().  All times are CPU
 * time on one thread in ns per particle: those of water and of walls, as both have
 * rates or forces to be asked for.  A plus marks a cube of water and nothing else; at
 * 2.5 dx it has 66 neighbours in the mean.  A star marks water in a domain that repeats
 * in all directions; at 2.45 dx each particle has 66 neighbours there.  Its images cost time
 * but are not counted as particles.  RHS is the median of 15, its parts are the least of
 * 15, as differences of medians say little on a machine with other work:
 *
 *     gather   neighbours fetched, separations and roots formed
 *     laws     kernel gradient, its division by r^2 + 0.01 hs^2, and the laws
 *     pack     records of all particles with the equation of state
 *     rest     check of displacements, rates written to their places
 *     list     sorting and finding, times the share of rebuilds
 *     fresh    one moment_eval() that rebuilds nothing
 *     RHS      one moment_eval() after the other with that share of rebuilds
 *     M/s      million particles' right-hand sides a second: by the median of RHS, and
 *              by the least
 *
 * L is the number of lanes of the list; with an s behind, pairs are summed in single
 * precision, with twice as many.
 *
 * The last lines have two threads in turn with one; how many loops for several threads a
 * right-hand side has, and what part of its time one thread spends outside of them.  With the
 * argument `threads` there are no other lines.
 *
 * The share is that of the default method in data/scenes/dam-break.scene from 0
 * to 0.3 s: 21, 12, 7 % of right-hand sides at margins of 0.05, 0.1, 0.2 (here 20, 10, 5);
 * dam-break-3d.scene with spacing=0.037 has 24, 17, 12 % at 0.03, 0.05, 0.1. */
#include "eval/inside.h"

#include "base/status.h"
#include "space/cells.h"
#include "space/laws.h"
#include "space/record.h"
#include "tools.h"
#include "water.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    KERNEL_BITS = NEED_GRADW | NEED_GRADW_R2 | NEED_W
};

static FILE *csv;

/* What one case took [ns per particle]. */
struct parts {
    double gather, laws, pack, rest, fresh, sort, rebuild;
    struct bench_times rhs;
};

static struct moment *moment_of(void *water)
{
    return ((struct water *)water)->moment;
}

static void add_up(void *water)
{
    struct moment *m = moment_of(water);
    const struct plan *p = m->plan;
    struct workspace *w = m->work;
    const struct sum_job job = {
        .list = m->list, .record = w->record, .mass = p->table.mass, .table = p->table.all,
        .slots = p->slots,
        .f = w->f, .drho = w->drho, .power = w->power,
    };

    bench_must(p->engine->sum->pairs(&job, &w->scratch));
}

static void pack_only(void *water)
{
    struct water *w = water;
    struct view v;

    moment_view(w->moment, 0, w->y[w->now], &v);
    bench_must(moment_pack(w->moment, &v, KIND_BIT(KINDS) - 1));
}

static struct cloud cloud_of(struct water *w)
{
    struct cloud cloud = { 0 };
    struct view v;

    moment_view(w->moment, 0, w->y[w->now], &v);
    memcpy(cloud.from, v.p->from, sizeof cloud.from);
    memcpy(cloud.x, v.x, sizeof cloud.x);
    return cloud;
}

static void sort_only(void *water)
{
    const struct cloud cloud = cloud_of(water);

    bench_must(cells_sort(moment_of(water)->list, &cloud));
}

static void rebuild(void *water)
{
    struct water *w = water;

    w->now = !w->now;
    const struct cloud cloud = cloud_of(w);
    bench_must(w->plan->engine->sum->list->update(w->moment->list, &cloud));
}

/* A law of nothing: what the engine costs without effects. */
static void idle(const void *self, const struct side *a, const struct block *b, struct sum *to)
{
    (void)self;
    (void)a;
    (void)b;
    (void)to;
}

/* The time of the sum with at most `laws` laws, of all needs but `without`. */
static double sum_of(struct water *w, int laws, unsigned without)
{
    struct pairs_table *table = w->plan->table.all, old[KINDS * KINDS];
    double time;

    memcpy(old, table, sizeof old);
    for (int i = 0; i < KINDS * KINDS; i++) {
        if (table[i].n > laws)
            table[i].n = laws > 0 ? laws : 1;
        if (laws == 0)
            table[i].work[0].law = idle;
        table[i].needs &= ~without;
        for (int k = 0; k < table[i].n; k++)
            table[i].work[k].needs &= ~without;
        w->plan->engine->sum->arrange(&table[i], true);
    }
    time = bench_time(add_up, w, w->all, 2).least;
    memcpy(table, old, sizeof old);
    return time;
}

static struct parts measure(struct water *w, double share)
{
    struct parts t;

    w->share = share;
    t.rhs = bench_time(water_rates, w, w->all, (int)lround(1 / share)); /* a rebuild each */
    w->share = 0;
    t.fresh = bench_time(water_rates, w, w->all, 2).least;
    t.gather = sum_of(w, 0, KERNEL_BITS);
    t.laws = sum_of(w, PAIRS_LAWS, 0) - t.gather;
    t.pack = bench_time(pack_only, w, w->all, 2).least;
    t.rest = t.fresh - t.pack - t.laws - t.gather;
    t.rebuild = bench_time(rebuild, w, w->all, 2).least;
    t.sort = bench_time(sort_only, w, w->all, 2).least;
    rebuild(w);
    rebuild(w);
    return t;
}

/* Useful neighbours of all particles, and entries of the rows, per particle. */
static void count(const struct water *w, double *useful, double *entries)
{
    const struct list *list = w->moment->list;
    const double *record = w->moment->work->record, H = w->plan->scales.support;
    long n = 0;

    for (int g = 0; g < list->groups; g++)
        for (int s = list->segment_from[g]; s < list->segment_from[g + 1]; s++)
            for (int k = 0; k < list->segment[s].rows * list->lanes; k++) {
                const int a = list->group_slot[g] + k % list->lanes, b = list_place(list->segment[s].j[k]);
                const double *ra = record + (size_t)a * RECORD, *rb = record + (size_t)b * RECORD;
                double r2 = 0;

                for (int d = RECORD_X; d < RECORD_X + DIM; d++) /* z follows y */
                    r2 += (ra[d] - rb[d]) * (ra[d] - rb[d]);
                n += r2 < H * H;
            }
    *useful = (double)n / w->all;
    *entries = (double)list->rows_before[list->groups] * list->lanes / w->all;
}

/* The same bits on 1, 2 and 4 threads, list rebuilt by each? */
static const char *threads_agree(struct water *w, uint64_t *hash)
{
    const char *answer = "same";

    for (int threads = 1; threads <= 4; threads *= 2) {
        bench_threads(threads);
        w->now = 0;
        w->share = 1;
        water_rates(w); /* goes to y[1] and back: two rebuilds */
        water_rates(w);
        const uint64_t h = bench_hash(BENCH_HASH, w->ydot, (size_t)w->size * sizeof(double));
        if (threads == 1)
            *hash = h;
        else if (h != *hash)
            answer = "DIFFERS";
    }
    bench_threads(1);
    return answer;
}

static void report(struct water *w, const struct water_def *def, double share)
{
    const double support = def->support, margin = def->margin;

    const struct parts t = measure(w, share);
    const int width = w->plan->engine->lanes;
    double useful, entries;
    uint64_t hash = 0;

    water_rates(w);
    count(w, &useful, &entries);
    const char *same = threads_agree(w, &hash);
    printf("%dD%c%7d %7d %d%c %.2f %.2f %3.0f%% %5.1f %5.2f |%6.1f %6.1f %5.1f %5.1f %5.1f"
           " |%6.1f %6.1f (%.1f-%.1f) %6.2f (%.2f) %6.1f  %016" PRIx64 " %s\n",
           DIM, def->endless ? '*' : def->alone ? '+' : ' ', w->fluid, w->all, width,
           def->single ? 's' : ' ', support, margin, 100 * share, useful, entries / useful, t.gather, t.laws, t.pack, t.rest,
           share * t.rebuild, t.fresh, t.rhs.median, t.rhs.least, t.rhs.most, 1e3 / t.rhs.median,
           1e3 / t.rhs.least, 1e3 * useful / t.rhs.median, hash, same);
    fprintf(csv, "%d,%d,%d,%d,%s,%g,%g,%g,%g,%g,%g,%g,%g,%g,%g,%g,%g,%g,%g,%g,%g,%g,%g,%016"
            PRIx64 ",%s\n", DIM, w->fluid, w->all, width,
            def->single ? "single" : "double", support, margin, share, useful,
            entries / useful, t.gather, t.laws, t.pack, t.rest, t.sort, t.rebuild,
            t.fresh, t.rhs.median, t.rhs.least, t.rhs.most, 1e3 / t.rhs.median,
            1e3 * useful / t.rhs.median, share * t.rebuild / t.rhs.median, hash, same);
    fflush(stdout);
}

/* In both precisions. */
static void run(const struct water_def *of, double share)
{
    for (int single = 0; single < 2; single++) {
        struct water_def def = *of;
        struct water w;

        def.single = single;
        water_make(&w, &def);
        report(&w, &def, share);
        water_free(&w);
    }
}

static void head(void)
{
    printf("%2s %7s %7s %s  %4s %4s %4s %5s %5s |%6s %6s %5s %5s %5s |%6s %6s %13s %13s %6s\n",
           "", "fluid", "all", "L", "H/dx", "marg", "reb.", "nb", "rows", "gather", "laws",
           "pack", "rest", "list", "fresh", "RHS", "(least-most)", "M/s (best)", "Mpr/s");
}

static void per_effect(const struct water_def *def)
{
    struct water w;
    double before = 0;

    water_make(&w, def);
    printf("one effect after the other (%dD, %d particles, H = %.2f dx), ns per particle:\n",
           DIM, w.all, def->support);
    const struct pairs_table *t = &w.plan->table.all[KIND_FLUID * KINDS + KIND_FLUID];
    for (int laws = 0; laws <= t->n; laws++) {
        const double time = sum_of(&w, laws, 0);
        const char *name = "none";

        for (int i = 0; i < w.plan->parts && laws > 0; i++)
            if (w.plan->part[i].slot == t->work[laws - 1].slot)
                name = w.plan->part[i].part->name;
        printf("    %-22s %6.1f  (%+.1f)\n", name, time, laws > 0 ? time - before : 0.0);
        before = time;
    }
    water_free(&w);
}

/* Laws in one loop, and one after the other on the same rows, in turn. */
static void one_loop(const struct water_def *def)
{
    enum { TURNS = 41 };
    double ns[2][TURNS], ratio[TURNS];
    struct water w;

    water_make(&w, def);
    for (int r = 0; r < TURNS; r++) {
        for (int fuse = 0; fuse < 2; fuse++) {
            for (int i = 0; i < KINDS * KINDS; i++)
                w.plan->engine->sum->arrange(&w.plan->table.all[i], fuse);
            const double start = bench_cpu();
            add_up(&w);
            ns[fuse][r] = 1e9 * (bench_cpu() - start) / w.all;
        }
        ratio[r] = ns[1][r] / ns[0][r];
    }
    const struct bench_times q = bench_sort(ratio, TURNS);
    printf("laws in one loop: %.1f ns, one after the other %.1f (least), ratio %.2f (median)\n",
           bench_sort(ns[1], TURNS).least, bench_sort(ns[0], TURNS).least, q.median);
    water_free(&w);
}

static void rebuild_parts(struct water_def def)
{
    static const double margins[] = { 0.05, 0.1, 0.2 }, shares[] = { 0.2, 0.1, 0.05 };

    printf("rebuilding the list, ns per particle:\n");
    for (int i = 0; i < 3; i++) {
        struct water w;
        def.margin = margins[i];
        water_make(&w, &def);
        const struct parts t = measure(&w, shares[i]);
        const double list = shares[i] * t.rebuild;
        printf("    margin %.2f: sort %5.1f, find %5.1f, share of RHS %4.1f %%, RHS %6.1f\n",
               margins[i], t.sort, t.rebuild - t.sort, 100 * list / (t.fresh + list),
               t.rhs.median);
        water_free(&w);
    }
}

enum { CALLS = 20 }; /* right-hand sides, timed together */

static void call(struct water *w)
{
    for (int i = 0; i < CALLS; i++)
        water_rates(w);
}

/* With one thread at work: the part of its time outside of all loops for several (the median),
 * and how many of these a right-hand side has. */
static double serial_share(struct water *w, double *regions)
{
    double share[BENCH_REPEATS];
    const long before = bench_regions().n;

    bench_threads(2);
    bench_regions_alone(true);
    for (int r = 0; r < BENCH_REPEATS; r++) {
        const struct bench_regions was = bench_regions();
        const double start = bench_wall();

        call(w);
        const double all = bench_wall() - start;
        const struct bench_regions now = bench_regions();
        const double clocks = (double)(now.n - was.n) * now.clock; /* inside; and as much outside */
        share[r] = 1 - (now.inside - was.inside - clocks) / (all - 2 * clocks);
    }
    bench_regions_alone(false);
    bench_threads(1);
    *regions = (double)(bench_regions().n - before) / (CALLS * BENCH_REPEATS);
    return bench_sort(share, BENCH_REPEATS).median;
}

/* Wall time of one thread over that of two, in turn, and CPU time likewise; and the least time of
 * one over the least of two, which other guests of a machine disturb less.  And how far apart the
 * cores are: a host that moves them changes what threads are worth. */
static void two_threads(const struct water_def *def)
{
    double wall[BENCH_REPEATS], cpu[BENCH_REPEATS], least[2] = { HUGE_VAL, HUGE_VAL }, regions;
    double apart[BENCH_REPEATS];
    struct water w;

    water_make(&w, def);
    w.share = 0.2;
    for (int r = 0; r < BENCH_REPEATS; r++) {
        double took[2], used[2];

        for (int threads = 1; threads <= 2; threads++) {
            bench_threads(threads);
            water_rates(&w);
            const double start = bench_wall(), start_cpu = bench_cpu();
            call(&w);
            took[threads - 1] = bench_wall() - start;
            used[threads - 1] = bench_cpu() - start_cpu;
            least[threads - 1] = fmin(least[threads - 1], took[threads - 1]);
        }
        wall[r] = took[0] / took[1];
        cpu[r] = used[1] / used[0];
        apart[r] = bench_apart();
    }
    bench_threads(1);
    const struct bench_times a = bench_sort(wall, BENCH_REPEATS);
    const struct bench_times c = bench_sort(cpu, BENCH_REPEATS), d = bench_sort(apart, BENCH_REPEATS);
    const double serial = serial_share(&w, &regions);
    printf("two threads, %6d particles, %s: %.2f times as fast (%.2f-%.2f), by least times %.1f/%.1f ns "
           "= %.2f, CPU time %.2f-fold (%.2f-%.2f), %.1f loops, serial %.1f %%, ", w.all,
           def->single ? "single" : "double", a.median, a.least, a.most,
           1e9 * least[0] / CALLS / w.all, 1e9 * least[1] / CALLS / w.all, least[0] / least[1],
           c.median, c.least, c.most, regions, 100 * serial);
    printf("cores %.0f ns apart (%.0f-%.0f)\n", 1e9 * d.median, 1e9 * d.least, 1e9 * d.most);
    water_free(&w);
}

#if DIM == 2
static const struct water_def usual = { .n = 50000, .support = 2.52, .margin = 0.05 };

static void cases(void)
{
    static const int n[] = { 5000, 50000, 500000 };

    for (int i = 0; i < 3; i++)
        for (int wide = 0; wide < 2; wide++)
            run(&(struct water_def){ .n = n[i], .support = wide ? 3.0 : 2.52, .margin = 0.05 },
                0.2);
}
#else
static const struct water_def usual = { .n = 50000, .support = 2.5, .margin = 0.05 };

static void cases(void)
{
    run(&usual, 0.2);
    run(&(struct water_def){ .n = 50000, .support = 2.5, .margin = 0.05, .alone = true }, 0.2);
    run(&(struct water_def){ .n = 50000, .support = 2.45, .margin = 0.05, .endless = true }, 0.2);
}
#endif

static void threads_help(void)
{
    for (int single = 0; single < 2; single++) {
        struct water_def of = usual;

        of.single = single;
        two_threads(&of);
        of.n = 6000; /* 6,889 particles with walls */
        two_threads(&of);
    }
}

int main(int argc, char **argv)
{
    bench_start(argv);
    bench_head(DIM == 2 ? "whole right-hand side in 2D" : "whole right-hand side in 3D",
               engine_pick()->lanes);
    if (argc > 1 && strcmp(argv[1], "threads") == 0) {
        threads_help();
        return 0;
    }
    csv = bench_csv(argv[0], "dimension,fluid,all,lanes,precision,support,margin,share,neighbours,rows,"
                    "gather,laws,pack,rest,sort,rebuild,fresh,rhs,rhs_least,rhs_most,"
                    "million_rhs_per_s,million_pairs_per_s,list_share,hash,threads_1_2_4");
    head();
    cases();
    setenv("STIFFWATER_LANES", "2", 1);
    run(&usual, 0.2);
    unsetenv("STIFFWATER_LANES");
    per_effect(&usual);
    one_loop(&usual);
    rebuild_parts(usual);
    threads_help();
    fclose(csv);
    return 0;
}
