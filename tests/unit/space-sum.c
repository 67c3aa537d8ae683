/* space-sum.c -- sums over pairs against brute force, and their bits. */
#include "space.h"

#include "kernels/kernel.h"
#include "space/laws.h"
#include "space/record.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#ifdef _OPENMP
#include <omp.h>
#endif

enum { COLUMNS = 3 };

static const int mixed[KINDS] = { 400, 161, 30, 53, 10 };
static const int uniform[KINDS] = { 700 };
static const double strength = 0.7;
extern pairs_law *const space_laws_lanes2[], *const space_laws_lanes4[],
    *const space_laws_lanes8[];
extern const struct kernel kernel_wendland_c2_lanes2, kernel_cubic_spline_lanes2;
extern const struct kernel kernel_wendland_c2_lanes4, kernel_cubic_spline_lanes4;
extern const struct kernel kernel_wendland_c2_lanes8, kernel_cubic_spline_lanes8;

/* What a particle has, creation order. */
struct fields {
    double v[DIM], rho, p2, m;
};

/* One sum: its list, tables, records and answers. */
struct work {
    const struct sum_engine *engine;
    struct list *list;
    struct kernel_use kernel[2];
    struct pairs_table table[KINDS * KINDS];
    double *record, *f, *drho, power[COLUMNS];
    struct sum_rates rates;
};

static struct fields *make_fields(const struct space_cloud *c)
{
    struct fields *of = test_malloc(((size_t)c->n + 1) * sizeof *of);

    for (int i = 0; i < c->n; i++) {
        for (int d = 0; d < DIM; d++)
            of[i].v[d] = space_random() - 0.5;
        of[i].rho = 1 + space_random();
        of[i].p2 = space_random() - 0.3;
        of[i].m = 0.5 + space_random();
    }
    return of;
}

/* What stands with 2 lanes, with as many as the engine has. */
struct wide {
    pairs_law *const *laws;
    const struct kernel *wendland, *spline;
};

static struct wide wide_of(const struct sum_engine *engine)
{
#ifdef STIFFWATER_V4
    if (engine->lanes == 8)
        return (struct wide){ space_laws_lanes8, &kernel_wendland_c2_lanes8,
                              &kernel_cubic_spline_lanes8 };
#endif
#ifdef STIFFWATER_V3
    if (engine->lanes == 4)
        return (struct wide){ space_laws_lanes4, &kernel_wendland_c2_lanes4,
                              &kernel_cubic_spline_lanes4 };
#endif
    (void)engine;
    return (struct wide){ space_laws_lanes2, &kernel_wendland_c2_lanes2,
                          &kernel_cubic_spline_lanes2 };
}

/* Column 0: nothing; column 1: first law, all; column 2: second law, shorter
 * kernel, for fluid and walls only. */
static void make_tables(struct work *w, double support)
{
    const struct wide wide = wide_of(w->engine);

    w->kernel[0] = kernel_use_make(wide.wendland, support, DIM);
    w->kernel[1] = kernel_use_make(wide.spline, 0.8 * support, DIM);
    for (int a = 0; a < KINDS; a++)
        for (int b = 0; b < KINDS; b++) {
            struct pairs_table *t = &w->table[a * KINDS + b];

            t->work[t->n++] = (struct pairs_work){ wide.laws[0], NULL, &w->kernel[0], 1,
                                                  NEED_GRADW };
            t->needs = NEED_X | NEED_P2 | NEED_GRADW | NEED_XV;
            w->engine->arrange(t, false);
            if (a > KIND_WALL || b > KIND_WALL)
                continue;
            t->work[t->n++] = (struct pairs_work){ wide.laws[1], &strength, &w->kernel[1], 2,
                                                  NEED_GRADW | NEED_W };
            t->needs |= NEED_V | NEED_W | NEED_IRHO | NEED_RHO | NEED_R2;
        }
}

static void set_record(double *r, const double *x, const struct fields *of)
{
    for (int d = 0; d < 2; d++) {
        r[RECORD_X + d] = x[d];
        r[RECORD_V + d] = of->v[d];
    }
#if DIM == 3
    r[RECORD_Z] = x[2];
    r[RECORD_VZ] = of->v[2];
#endif
    r[RECORD_RHO] = of->rho;
    r[RECORD_IRHO] = 1 / of->rho;
    r[RECORD_P2] = of->p2;
    r[RECORD_M] = of->m;
}

static void pack(struct work *w, const struct space_cloud *c, const struct fields *of)
{
    const double far[DIM] = { 1e30 };
    const struct fields dummy = { .rho = 1, .m = 1, .p2 = 1, .v = { 1 } };

    for (int s = 0; s < w->list->listed; s++)
        set_record(w->record + (size_t)s * RECORD, c->x + w->list->order[s] * DIM,
                   &of[w->list->order[s]]);
    set_record(w->record + (size_t)w->list->listed * RECORD, far, &dummy);
}

static void add_up(struct work *w, const struct list *list)
{
    struct sum_scratch scratch = { 0 };
    const struct sum_job job = {
        .list = list, .record = w->record, .table = w->table, .slots = COLUMNS,
        .f = w->f, .drho = w->drho, .power = w->power, .rates = w->rates,
    };

    for (int i = 0; i < list->listed * DIM; i++)
        w->f[i] = NAN;
    for (int i = 0; i < list->listed; i++)
        w->drho[i] = NAN;
    assert_int_equal(w->engine->pairs(&job, &scratch), 0);
    free(scratch.power);
    free(scratch.cut);
}

static struct work *work(int engine, struct space_cloud *c, const struct fields *of)
{
    struct work *w = test_calloc(1, sizeof *w);

    w->engine = space_engine(engine);
    assert_int_equal(w->engine->list->create(&w->list, &c->def), 0);
    assert_int_equal(w->engine->list->update(w->list, &c->cloud), 0);
    make_tables(w, c->def.support);
    w->record = aligned_alloc(64, ((size_t)c->n + 8) * 128);
    w->f = test_malloc(((size_t)c->n + 1) * sizeof(double) * DIM);
    w->drho = test_malloc(((size_t)c->n + 1) * sizeof(double));
    pack(w, c, of);
    add_up(w, w->list);
    return w;
}

static void work_free(struct work *w)
{
    w->engine->list->free(&w->list);
    free(w->record);
    test_free(w->f);
    test_free(w->drho);
    test_free(w);
}

/* What both laws give particle i, straight from their definitions: force and
 * mass times rate of density by column of the book. */
static void brute_force(const struct space_cloud *c, const struct fields *of,
                        const struct work *w, int i, double f[COLUMNS][DIM], double rate[COLUMNS])
{
    memset(f, 0, COLUMNS * sizeof *f);
    memset(rate, 0, COLUMNS * sizeof *rate);
    for (int j = 0; j < c->n; j++) {
        const double r2 = space_distance2(c, i, j), r = sqrt(r2), mm = of[i].m * of[j].m;
        const double w2 = mm * kernel_w(&w->kernel[1], r);
        const double g = r > 0 ? mm * kernel_gradient(&w->kernel[0], r) / r : 0;
        const int a = space_kind(c, i), b = space_kind(c, j);

        if (i == j || !(c->def.acts[a] & KIND_BIT(b)))
            continue;
        for (int d = 0; d < DIM; d++) {
            const double x = c->x[i * DIM + d] - c->x[j * DIM + d], v = of[i].v[d] - of[j].v[d];

            f[1][d] -= (of[i].p2 + of[j].p2) * g * x;
            rate[1] += g * x * v;
            if (a <= KIND_WALL && b <= KIND_WALL)
                f[2][d] += strength * w2 * r2 * (1 / of[i].rho + 1 / of[j].rho) * v;
        }
        if (a <= KIND_WALL && b <= KIND_WALL)
            rate[2] += strength * w2 * (of[i].rho + of[j].rho);
    }
}

static void compare(const struct space_cloud *c, const struct fields *of, const struct work *w)
{
    double power[COLUMNS] = { 0 }, most[2] = { 0 }, worst[2] = { 0 }, size = 0;

    for (int i = 0; i < c->n; i++) {
        double f[COLUMNS][DIM], rate[COLUMNS];
        const int s = w->list->slot[i];

        brute_force(c, of, w, i, f, rate);
        for (int k = 0; k < COLUMNS; k++) {
            double p = of[i].p2 * rate[k];

            for (int d = 0; d < DIM; d++)
                p += of[i].v[d] * f[k][d];
            power[k] += p;
            size += fabs(p);
        }
        for (int d = 0; d < DIM; d++) {
            const double all = f[1][d] + f[2][d];

            most[0] = fmax(most[0], fabs(all));
            worst[0] = fmax(worst[0], fabs(all - w->f[s * DIM + d]));
        }
        const double drho = (rate[1] + rate[2]) / of[i].m;
        most[1] = fmax(most[1], fabs(drho));
        worst[1] = fmax(worst[1], fabs(drho - w->drho[s]));
    }
    for (int k = 0; k < 2; k++)
        check(most[k] > 0 && worst[k] <= 1e-13 * most[k], "%s: off by %g of %g",
              k ? "rate" : "force", worst[k], most[k]);
    for (int k = 0; k < COLUMNS; k++)
        check(fabs(power[k] - w->power[k]) <= 1e-13 * size, "power %d: %g, not %g", k, w->power[k],
              power[k]);
    check(w->power[0] == 0 && w->power[1] != 0 && w->power[2] != 0, "powers by column");
}

void sum_agrees_with_brute_force(void **state)
{
    (void)state;
    for (int e = 0; e < space_engines(); e++)
        for (unsigned seed = 1; seed < 4; seed++) {
            space_seed(seed);
            /* the last has more than one slice of rows */
            struct space_cloud *c = space_cloud(mixed, seed == 3 ? 0.6 : 0.2, 0.02);
            struct fields *of = make_fields(c);
            struct work *w = work(e, c, of);

            compare(c, of, w);
            work_free(w);
            test_free(of);
            space_cloud_free(c);
        }
}

static void check_same(const struct work *a, const struct work *b, const char *what)
{
    const size_t n = (size_t)a->list->listed;

    check(n == (size_t)b->list->listed, "%s: as many places", what);
    check(memcmp(a->f, b->f, n * DIM * sizeof(double)) == 0, "%s: the same bits of force", what);
    check(memcmp(a->drho, b->drho, n * sizeof(double)) == 0, "%s: the same bits of rate", what);
    check(memcmp(a->power, b->power, sizeof a->power) == 0, "%s: the same bits of power", what);
}

static void use_threads(int n)
{
#ifdef _OPENMP
    omp_set_num_threads(n);
#else
    (void)n;
#endif
}

void sum_same_bits_lanes_and_threads(void **state)
{
    const char *const name[] = { "2 lanes", "4 lanes", "8 lanes" };
    struct space_cloud *c = space_cloud(mixed, 0.2, 0.02);
    struct fields *of = make_fields(c);

    (void)state;
    use_threads(1);
    struct work *one = work(0, c, of);
    for (int e = 0; e < space_engines(); e++)
        for (int threads = 1; threads <= 4; threads *= 2) {
            use_threads(threads);
            struct work *w = work(e, c, of);

            check_same(one, w, name[e]);
            work_free(w);
        }
    use_threads(2);
    work_free(one);
    test_free(of);
    space_cloud_free(c);
}

/* The same list without what lies beyond the support, rows as short as can be. */
static struct list prune(const struct list *list, const struct space_cloud *c, int *j,
                         struct list_segment *segment)
{
    struct list thin = *list;
    const int width = list->lanes;

    for (int s = 0; s < list->segment_from[list->groups]; s++)
        segment[s] = list->segment[s];
    for (int g = 0; g < list->groups; g++)
        for (int s = list->segment_from[g]; s < list->segment_from[g + 1]; s++) {
            int rows = 0;

            segment[s].j = j;
            for (int k = 0; k < segment[s].rows * width; k++)
                j[k] = list_entry(list->listed);
            for (int l = 0; l < width; l++) {
                int n = 0;

                for (int k = 0; k < segment[s].rows; k++) {
                    const int b = list_place(list->segment[s].j[k * width + l]);

                    if (b == list->listed
                        || space_distance2(c, list->order[list->group_slot[g] + l], list->order[b])
                               > c->def.support * c->def.support)
                        continue;
                    j[n++ * width + l] = list_entry(b);
                }
                rows = n > rows ? n : rows;
            }
            j += segment[s].rows * width;
            segment[s].rows = rows;
        }
    thin.segment = segment;
    return thin;
}

/* Padding and pairs in the margin add exact zeros: a pruned list has equal bits. */
void sum_padding_adds_nothing(void **state)
{
    struct space_cloud *c = space_cloud(mixed, 0.2, 0.1);
    struct fields *of = make_fields(c);

    (void)state;
    for (int e = 0; e < space_engines(); e++) {
        struct work *w = work(e, c, of), bare = *w;
        const struct list *list = w->list;
        int *j = test_malloc((size_t)(list->rows_before[list->groups] + 1)
                             * (size_t)list->lanes * sizeof *j);
        struct list_segment *segment =
            test_malloc((size_t)(list->segment_from[list->groups] + 1) * sizeof *segment);
        const struct list thin = prune(list, c, j, segment);

        bare.f = test_malloc((size_t)c->n * DIM * sizeof(double));
        bare.drho = test_malloc((size_t)c->n * sizeof(double));
        add_up(&bare, &thin);
        check_same(w, &bare, "pruned");
        test_free(bare.f);
        test_free(bare.drho);
        test_free(j);
        test_free(segment);
        work_free(w);
    }
    test_free(of);
    space_cloud_free(c);
}

/* Owners without neighbours and kinds that own nothing get exact zeros. */
void sum_writes_every_place(void **state)
{
    static const int few[KINDS] = { 7, 3, 0, 0, 5 };

    (void)state;
    for (int e = 0; e < space_engines(); e++) {
        struct space_cloud *c = space_cloud(few, 1e-6, 0);
        struct fields *of = make_fields(c);
        struct work *w = work(e, c, of);

        for (int s = 0; s < w->list->listed; s++) {
            check(w->drho[s] == 0, "rate of place %d", s);
            for (int d = 0; d < DIM; d++)
                check(w->f[s * DIM + d] == 0, "force on place %d", s);
        }
        work_free(w);
        test_free(of);
        space_cloud_free(c);
    }
}

/* Rates of the fluid go where they are wanted, those of others to their places. */
void sum_writes_rates_in_place(void **state)
{
    struct space_cloud *c = space_cloud(mixed, 0.2, 0.1);
    struct fields *of = make_fields(c);
    const int n = mixed[KIND_FLUID];

    (void)state;
    for (int e = 0; e < space_engines(); e++) {
        struct work *w = work(e, c, of), placed = *w;
        const struct list *l = w->list;

        placed.f = test_malloc((size_t)c->n * DIM * sizeof(double));
        placed.drho = test_malloc((size_t)c->n * sizeof(double));
        placed.rates.u = test_malloc((size_t)n * sizeof *placed.rates.u);
        placed.rates.rho = test_malloc((size_t)n * sizeof *placed.rates.rho);
        placed.rates.rows = n;
        add_up(&placed, l);
        for (int s = 0; s < l->listed; s++) {
            const int i = l->order[s];
            const double *u = i < n ? placed.rates.u[i] : placed.f + s * DIM;
            const double rho = i < n ? placed.rates.rho[i] : placed.drho[s];
            const double per = i < n ? 1 / of[i].m : 1;

            check(rho == w->drho[s], "rate of %d: %g, %g in its place", i, rho, w->drho[s]);
            for (int d = 0; d < DIM; d++)
                check(u[d] == w->f[s * DIM + d] * per, "%d is accelerated by %g, in its place %g",
                      i, u[d], w->f[s * DIM + d] * per);
        }
        check(memcmp(w->power, placed.power, sizeof w->power) == 0, "the same book");
        test_free(placed.f);
        test_free(placed.drho);
        test_free(placed.rates.u);
        test_free(placed.rates.rho);
        work_free(w);
    }
    test_free(of);
    space_cloud_free(c);
}

/* Both sides of a pair get opposite forces: they add up to rounding. */
void sum_keeps_momentum(void **state)
{
    (void)state;
    for (int e = 0; e < space_engines(); e++) {
        struct space_cloud *c = space_cloud(uniform, 0.2, 0.02);
        struct fields *of = make_fields(c);
        struct work *w = work(e, c, of);

        for (int d = 0; d < DIM; d++) {
            double sum = 0, size = 0;

            for (int s = 0; s < c->n; s++) {
                sum += w->f[s * DIM + d];
                size += fabs(w->f[s * DIM + d]);
            }
            check(size > 0 && fabs(sum) < 1e-14 * size, "momentum changes by %g of %g", sum, size);
        }
        work_free(w);
        test_free(of);
        space_cloud_free(c);
    }
}
