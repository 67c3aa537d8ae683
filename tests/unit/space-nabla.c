/* space-nabla.c -- divergence and gradient over pairs, with weights worked out anew and with
 * kept ones: against brute force and linear fields, each the transpose of the other, and
 * their bits. */
#include "space.h"

#include "kernels/kernel.h"
#include "space/nabla-kept.h"
#include "space/record.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#ifdef _OPENMP
#include <omp.h>
#endif

static const int mixed[KINDS] = { 400, 161, 30, 53, 10 };
extern const struct kernel kernel_wendland_c2_lanes2, kernel_wendland_c2_lanes4,
    kernel_wendland_c2_lanes8;

/* As effects act: walls and skins meet the fluid, not each other. */
static const unsigned meets[KINDS] = {
    [KIND_FLUID] = KIND_BIT(KIND_FLUID) | KIND_BIT(KIND_WALL) | KIND_BIT(KIND_SKIN),
    [KIND_WALL] = KIND_BIT(KIND_FLUID),
    [KIND_SKIN] = KIND_BIT(KIND_FLUID),
};
enum { OWNERS = KIND_BIT(KIND_FLUID) | KIND_BIT(KIND_WALL) | KIND_BIT(KIND_SKIN) };

/* A cloud with masses and values of its particles, and what the engine makes of them. */
struct over {
    const struct nabla_engine *engine;
    const struct nabla_kept_engine *keeper;
    const struct list_engine *lists;
    struct list *list;
    struct kernel_use kernel;
    struct nabla_job job;
    bool keeps;
    struct nabla_kept kept;
    double *record;
    double *a, *p; /* [slots + 1][NABLA_STRIDE], [slots + 1] */
    double *d, *g, *t; /* D a, G p, T p by slot */
};

/* Each lane width, with weights anew; then each once more, with kept ones. */
static int ways(void)
{
    return 2 * space_engines();
}

static double *room(int n)
{
    double *at = aligned_alloc(64, ((size_t)n * sizeof *at + 127) / 64 * 64);

    assert_non_null(at);
    for (int i = 0; i < n; i++)
        at[i] = NAN;
    return at;
}

static void choose(struct over *c, int way, double support)
{
    const struct kernel *kernel = &kernel_wendland_c2_lanes2;

    c->engine = &nabla_engine_lanes2;
    c->keeper = &nabla_kept_engine_lanes2;
    c->keeps = way >= space_engines();
    c->lists = space_engine(way % space_engines())->list;
#ifdef STIFFWATER_V3
    if (c->lists->lanes == 4) {
        c->engine = &nabla_engine_lanes4;
        c->keeper = &nabla_kept_engine_lanes4;
        kernel = &kernel_wendland_c2_lanes4;
    }
#endif
#ifdef STIFFWATER_V4
    if (c->lists->lanes == 8) {
        c->engine = &nabla_engine_lanes8;
        c->keeper = &nabla_kept_engine_lanes8;
        kernel = &kernel_wendland_c2_lanes8;
    }
#endif
    c->kernel = kernel_use_make(kernel, support, DIM);
}

static void write_record(double *r, const double *x, double m)
{
    for (int i = 0; i < RECORD; i++)
        r[i] = NAN; /* only places and m are looked at */
    for (int d = 0; d < 2; d++)
        r[RECORD_X + d] = x[d];
#if DIM == 3
    r[RECORD_Z] = x[2];
#endif
    r[RECORD_M] = m;
}

/* List and records of a cloud; m NULL: all masses are `each`. */
static struct over *over_make(int way, const struct space_cloud *cloud, const double *m,
                               double each)
{
    const double far[DIM] = { 1e3 };
    struct over *c = test_calloc(1, sizeof *c);

    choose(c, way, cloud->def.support);
    assert_int_equal(c->lists->create(&c->list, &cloud->def), 0);
    assert_int_equal(c->lists->update(c->list, &cloud->cloud), 0);
    const int n = c->list->listed, pairs = (int)nabla_kept_pairs(c->list);
    c->kept = (struct nabla_kept){ .list = c->list, .slope = room(pairs * DIM),
                                   .rows = test_malloc((size_t)c->list->groups * sizeof(int)),
                                   .j = test_malloc((size_t)pairs * sizeof(int)) };
    c->record = room((n + 1) * RECORD);
    c->a = room((n + 1) * NABLA_STRIDE);
    c->p = room(n + 1);
    c->d = room(n);
    c->g = room(n * DIM);
    c->t = room(n);
    for (int s = 0; s < n; s++) {
        const int i = c->list->order[s];

        write_record(c->record + (size_t)s * RECORD, cloud->x + (size_t)i * DIM, m ? m[i] : each);
    }
    write_record(c->record + (size_t)n * RECORD, far, 1);
    memset(c->a + (size_t)n * NABLA_STRIDE, 0, NABLA_STRIDE * sizeof *c->a);
    c->p[n] = 0;
    c->job = (struct nabla_job){ c->list, c->record, meets, &c->kernel };
    return c;
}

static void over_free(struct over *c)
{
    double *const all[] = { c->record, c->a, c->p, c->d, c->g, c->t, c->kept.slope };

    test_free(c->kept.rows);
    test_free(c->kept.j);
    c->lists->free(&c->list);
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        free(all[i]);
    test_free(c);
}

static void run(struct over *c)
{
    if (c->keeps) {
        c->keeper->keep(&c->job, &c->kept);
        c->keeper->divergence(&c->kept, OWNERS, c->a, c->d);
        c->keeper->gradient(&c->kept, OWNERS, c->p, c->g);
        c->keeper->squares(&c->kept, OWNERS, c->p, c->t);
        return;
    }
    c->engine->divergence(&c->job, OWNERS, c->a, c->d);
    c->engine->gradient(&c->job, OWNERS, c->p, c->g);
    c->engine->squares(&c->job, OWNERS, c->p, c->t);
}

/* Values at random, the same for the same order of slots. */
static void fill(struct over *c)
{
    space_seed(7);
    for (int s = 0; s < c->list->listed; s++) {
        c->p[s] = space_random() - 0.3;
        for (int d = 0; d < DIM; d++)
            c->a[s * NABLA_STRIDE + d] = space_random() - 0.5;
    }
    run(c);
}

static struct over *over_random(int way, const int count[KINDS], double support)
{
    space_seed(3);
    struct space_cloud *cloud = space_cloud(count, support, 0.02);
    double *m = test_malloc((size_t)cloud->n * sizeof *m);

    for (int i = 0; i < cloud->n; i++)
        m[i] = 0.5 + space_random();
    struct over *c = over_make(way, cloud, m, 0);
    fill(c);
    test_free(m);
    space_cloud_free(cloud);
    return c;
}

static int kind_of(const struct list *list, int s)
{
    int kind = 0;

    while (s >= list->start[kind + 1])
        kind++;
    return kind;
}

static double place(const struct over *c, int s, int d)
{
#if DIM == 3
    if (d == 2)
        return c->record[s * RECORD + RECORD_Z];
#endif
    return c->record[s * RECORD + RECORD_X + d];
}

/* m_i m_j gradW_ij; false: these kinds do not meet. */
static bool weight(const struct over *c, int i, int j, double w[DIM])
{
    double x[DIM], r2 = 0;

    if (i == j || !(meets[kind_of(c->list, i)] & KIND_BIT(kind_of(c->list, j))))
        return false;
    for (int d = 0; d < DIM; d++) {
        x[d] = place(c, i, d) - place(c, j, d);
        r2 += x[d] * x[d];
    }
    const double r = sqrt(r2);
    const double mm = c->record[i * RECORD + RECORD_M] * c->record[j * RECORD + RECORD_M];

    for (int d = 0; d < DIM; d++)
        w[d] = mm * kernel_gradient(&c->kernel, r) / r * x[d];
    return true;
}

static void compare(const struct over *c, int i)
{
    double all[2 + DIM] = { 0 }, size[2 + DIM] = { 0 }, w[DIM];

    for (int j = 0; j < c->list->listed; j++) {
        if (!weight(c, i, j, w))
            continue;
        for (int d = 0; d < DIM; d++) {
            const double term[] = {
                (c->a[i * NABLA_STRIDE + d] - c->a[j * NABLA_STRIDE + d]) * w[d],
                c->p[j] * w[d] * w[d], (c->p[i] + c->p[j]) * w[d],
            };
            for (int k = 0; k < 3; k++) {
                all[k == 2 ? 2 + d : k] += term[k];
                size[k == 2 ? 2 + d : k] += fabs(term[k]);
            }
        }
    }
    for (int k = 0; k < 2 + DIM; k++) {
        const double got = k == 0 ? c->d[i] : k == 1 ? c->t[i] : c->g[i * DIM + k - 2];

        check(fabs(got - all[k]) <= 1e-12 * size[k], "number %d of slot %d: %g, not %g", k, i, got,
              all[k]);
    }
}

void nabla_agrees_with_brute_force(void **state)
{
    (void)state;
    for (int e = 0; e < ways(); e++)
        for (int wide = 0; wide < 2; wide++) {
            struct over *c = over_random(e, mixed, wide ? 0.6 : 0.25);

            for (int s = 0; s < c->list->listed; s++)
                if (OWNERS & KIND_BIT(kind_of(c->list, s)))
                    compare(c, s);
                else
                    check(isnan(c->d[s]) && isnan(c->g[s * DIM]), "slot %d is not touched", s);
            over_free(c);
        }
}

/* Sum of p D a = sum of a . G p over all owners, to rounding. */
void nabla_is_its_transpose(void **state)
{
    (void)state;
    for (int e = 0; e < ways(); e++) {
        struct over *c = over_random(e, mixed, 0.25);
        double one = 0, other = 0, size = 0;

        for (int s = 0; s < c->list->listed; s++) {
            if (!(OWNERS & KIND_BIT(kind_of(c->list, s))))
                continue;
            one += c->p[s] * c->d[s];
            size += fabs(c->p[s] * c->d[s]);
            for (int d = 0; d < DIM; d++)
                other += c->a[s * NABLA_STRIDE + d] * c->g[s * DIM + d];
        }
        check(fabs(one) > 1e-3 * size && fabs(one - other) < 1e-14 * size,
              "p . D a = %.17g, a . G p = %.17g", one, other);
        over_free(c);
    }
}

/* What the header says of the diagonal of D Q G, for one fluid particle after the other. */
void nabla_gives_a_diagonal(void **state)
{
    static const int few[KINDS] = { 40, 12 };

    (void)state;
    struct over *c = over_random(space_engines() - 1, few, 0.5);
    const int n = c->list->listed, fluid = c->list->start[KIND_FLUID + 1];
    double *half = room(n * DIM), *t = room(n);

    for (int s = 0; s < n; s++)
        c->p[s] = 1;
    c->engine->gradient(&c->job, OWNERS, c->p, half);
    for (int s = 0; s < n; s++)
        c->p[s] = s < fluid ? 1 / c->record[s * RECORD + RECORD_M] : 0;
    c->engine->squares(&c->job, OWNERS, c->p, t);
    for (int i = 0; i < n; i++) {
        double want = t[i];

        for (int d = 0; d < DIM; d++)
            want += c->p[i] * half[i * DIM + d] * half[i * DIM + d] / 4;
        memset(c->t, 0, (size_t)n * sizeof *c->t);
        c->t[i] = 1;
        memcpy(c->p, c->t, (size_t)n * sizeof *c->p);
        c->engine->gradient(&c->job, OWNERS, c->p, c->g);
        for (int s = 0; s < n; s++) {
            const double q = s < fluid ? 1 / c->record[s * RECORD + RECORD_M] : 0;

            c->p[s] = q;
            for (int d = 0; d < DIM; d++)
                c->a[s * NABLA_STRIDE + d] = q * c->g[s * DIM + d];
        }
        c->engine->divergence(&c->job, OWNERS, c->a, c->d);
        check(want > 0 && fabs(c->d[i] - want) < 1e-13 * want, "diagonal %d: %g, not %g", i, want,
              c->d[i]);
    }
    free(half);
    free(t);
    over_free(c);
}

/* A lattice of `side` particles along each edge of the unit box, H three spacings. */
static struct space_cloud *lattice(int side)
{
    const int count[KINDS] = { DIM == 2 ? side * side : side * side * side };
    struct space_cloud *c = space_cloud(count, 3.0 / side, 0.1 / side);

    for (int i = 0; i < c->n; i++)
        for (int d = 0, rest = i; d < DIM; d++, rest /= side)
            c->x[i * DIM + d] = (rest % side + 0.5) / side;
    return c;
}

static bool inner(const struct over *c, int s, double margin)
{
    for (int d = 0; d < DIM; d++)
        if (!(place(c, s, d) > margin && place(c, s, d) < 1 - margin))
            return false;
    return true;
}

/* p = 2 + 3 x - y, a = (2 x + y, 5 x + 4 y) [and z]: -div a of D a, grad p of G p, and a
 * field without divergence has none, to rounding. */
static void linear_fields(struct over *c, int side, double trace)
{
    const double volume = pow(side, -DIM), grad[3] = { 3, -1, 0 };
    int seen = 0;

    for (int s = 0; s < c->list->listed; s++) {
        const double x = place(c, s, 0), y = place(c, s, 1);

        c->p[s] = 2 + 3 * x - y;
        c->a[s * NABLA_STRIDE] = 2 * x + y;
        c->a[s * NABLA_STRIDE + 1] = 5 * x + (trace - 2) * y;
        if (DIM == 3)
            c->a[s * NABLA_STRIDE + 2] = x - y;
    }
    run(c);
    for (int s = 0; s < c->list->listed; s++) {
        if (!inner(c, s, c->kernel.support))
            continue;
        const double div = c->d[s] / volume;

        seen++;
        check(fabs(div + trace) <= (trace == 0 ? 1e-11 : 0.005 * trace), "-div a = %g, not %g", div,
              -trace);
        for (int d = 0; d < DIM; d++) {
            const double of = c->g[s * DIM + d] / volume;
            check(fabs(of - grad[d]) < (grad[d] == 0 ? 1e-11 : 0.005 * fabs(grad[d])),
                  "gradient along %d: %g, not %g", d, of, grad[d]);
        }
    }
    check(seen > 0, "no particle has all its neighbours");
}

void nabla_of_linear_fields(void **state)
{
    const int side = DIM == 2 ? 20 : 10;

    (void)state;
    for (int e = 0; e < ways(); e++) {
        struct space_cloud *cloud = lattice(side);
        struct over *c = over_make(e, cloud, NULL, pow(side, -DIM));

        linear_fields(c, side, 6);
        linear_fields(c, side, 0);
        over_free(c);
        space_cloud_free(cloud);
    }
}

static void use_threads(int n)
{
#ifdef _OPENMP
    omp_set_num_threads(n);
#else
    (void)n;
#endif
}

void nabla_same_bits_lanes_and_threads(void **state)
{
    (void)state;
    for (int e = 0; e < ways(); e++)
        for (int threads = 1; threads <= 2; threads++) {
            use_threads(1);
            struct over *one = over_random(e < space_engines() ? 0 : space_engines(), mixed, 0.25);
            use_threads(threads);
            struct over *c = over_random(e, mixed, 0.25);
            const size_t n = (size_t)c->list->listed * sizeof(double);

            check(memcmp(one->d, c->d, n) == 0 && memcmp(one->g, c->g, n * DIM) == 0
                      && memcmp(one->t, c->t, n) == 0,
                  "%d lanes, %d threads: other bits", c->lists->lanes, threads);
            over_free(c);
            over_free(one);
        }
    use_threads(2);
}
