/* vector-rearrange.c -- rows change places under an integrator, which does not notice:
 * the same steps, right-hand sides and values by id, bit for bit. */
#include "algebra/vector.h"
#include "base/status.h"

#include <cvode/cvode.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#if !SUNDIALS_AT_LEAST(7, 1)
#define ARKodeGetDky ARKStepGetDky
#endif

/* y: positions, velocities and one more number of each particle; then what has no rows:
 * a body's, and a book. */
enum {
    P = 700, PLACE = 0, SPEED = 2 * P, MORE = 4 * P, BODY = 5 * P, BOOK = BODY + 2,
    N = BOOK + 3,
    BLOCKS = 3
};

/* Particles on springs, each pulled by those whose ids are near. */
struct water {
    int row[P];            /* of an id                                       */
    int from[P];           /* the row before                                 */
    bool split;            /* friction is on the implicit side               */
    uint64_t seen;         /* of all right-hand sides                        */
    long calls, steps;
    unsigned seed;
};

static SUNContext context;

static unsigned chance(unsigned *seed)
{
    return (*seed = *seed * 1664525u + 1013904223u) >> 8;
}

/* Where the number stands that stands at i when rows are ids. */
static long at(const struct water *w, long i)
{
    if (i < SPEED)
        return 2 * w->row[i / 2] + i % 2;
    if (i < MORE)
        return SPEED + 2 * w->row[(i - SPEED) / 2] + i % 2;
    return i < BODY ? MORE + w->row[i - MORE] : i;
}

static void see(struct water *w, const double *x)
{
    for (long i = 0; i < N; i++) {
        uint64_t bits;

        memcpy(&bits, x + at(w, i), sizeof bits);
        w->seen = (w->seen ^ bits) * UINT64_C(0x100000001b3);
        w->seen ^= w->seen >> 29;
    }
}

static void start(struct water *w, bool split, double *y)
{
    *w = (struct water){ .split = split, .seed = 7 };
    for (int id = 0; id < P; id++)
        w->row[id] = id;
    for (long i = 0; i < N; i++)
        y[i] = sin(1.7 * (double)i) * (i < MORE ? 0.3 : 1);
    y[BODY] = 0.2;
}

/* A spring to its place, others around, a body that pulls all. */
static void pull(const struct water *w, const double *y, int id, double *f)
{
    const double *x = y + 2 * w->row[id], *v = y + SPEED + 2 * w->row[id];
    const double more = y[MORE + w->row[id]], stiff = 1 + 4.0 * (id % 7);

    f[0] = -stiff * x[0] - 0.1 * more * v[1] + 0.3 * y[BODY];
    f[1] = -stiff * x[1] + 0.1 * more * v[0];
    for (int k = -2; k <= 2; k++) {
        const int other = (id + k + P) % P;
        const double *o = y + 2 * w->row[other];

        f[0] += 0.4 * (o[0] - x[0]) * cos(o[1]);
        f[1] += 0.4 * (o[1] - x[1]) * cos(o[0]);
    }
}

static void friction(const struct water *w, const double *y, double *f)
{
    for (int id = 0; id < P; id++)
        for (int d = 0; d < 2; d++) {
            const long i = SPEED + 2 * w->row[id] + d;
            f[i] -= (1 + id % 5) * y[i];
        }
    f[BODY + 1] -= 3 * y[BODY + 1];
}

static void rates(struct water *w, const double *y, double *f)
{
    double power = 0, load = 0;

    for (int id = 0; id < P; id++) {
        const int r = w->row[id];

        memcpy(f + 2 * r, y + SPEED + 2 * r, 2 * sizeof *f);
        pull(w, y, id, f + SPEED + 2 * r);
        f[MORE + r] = sin(y[2 * r]) - 0.5 * y[MORE + r];
        power += f[SPEED + 2 * r] * y[SPEED + 2 * r];
        load += y[2 * r];
    }
    f[BODY] = y[BODY + 1];
    f[BODY + 1] = -9 * y[BODY] + load / P;
    f[BOOK] = power;
    f[BOOK + 1] = load;
    f[BOOK + 2] = y[BOOK];
    if (!w->split)
        friction(w, y, f);
}

static int explicit_rates(double t, N_Vector y, N_Vector f, void *of)
{
    struct water *w = of;
    const double *x = vector_read(y);

    (void)t;
    rates(w, x, vector_overwrite(f));
    see(w, vector_read(f));
    w->calls++;
    return 0;
}

static int implicit_rates(double t, N_Vector y, N_Vector f, void *of)
{
    struct water *w = of;
    const double *x = vector_read(y);
    double *to = vector_overwrite(f);

    (void)t;
    memset(to, 0, N * sizeof *to);
    friction(w, x, to);
    see(w, to);
    vector_only_inside(f);
    w->calls++;
    return 0;
}

static int weigh(N_Vector y, N_Vector weight, void *of)
{
    const double *x = vector_read(y);
    double *to = vector_overwrite(weight);

    (void)of;
    for (long i = 0; i < N; i++)
        to[i] = 1 / (1e-5 * fabs(x[i]) + 1e-6);
    return 0;
}

static void shuffle(struct water *w, N_Vector y)
{
    struct vector_rows block[BLOCKS] = { { PLACE, P, 2, w->from, NULL }, { SPEED, P, 2, w->from, NULL },
                                         { MORE, P, 1, w->from, NULL } };
    int old[P];

    memcpy(old, w->row, sizeof old);
    for (int i = P - 1; i > 0; i--) {
        const int k = (int)(chance(&w->seed) % (unsigned)(i + 1)), swap = w->row[i];
        w->row[i] = w->row[k];
        w->row[k] = swap;
    }
    for (int id = 0; id < P; id++)
        w->from[w->row[id]] = old[id];
    assert_int_equal(vector_rearrange(y, BLOCKS, block), STATUS_DONE);
}

/* --- integrators --------------------------------------------------------- */

enum method { EXPLICIT, IMEX, ADAMS, BDF, METHODS };

struct solver {
    void *memory;
    SUNNonlinearSolver fixed_point;
    enum method method;
};

static void open_arkode(struct solver *s, struct water *w, N_Vector y)
{
    static const long stiff[2][2] = { { SPEED, MORE }, { BODY, BOOK } };

    if (w->split)
        assert_int_equal(vector_ranges(y, 2, stiff), STATUS_DONE);
    s->memory = ARKStepCreate(explicit_rates, w->split ? implicit_rates : NULL, 0, y, context);
    assert_non_null(s->memory);
    assert_int_equal(ARKodeSetUserData(s->memory, w), 0);
    assert_int_equal(ARKodeWFtolerances(s->memory, weigh), 0);
    if (!w->split)
        return;
    s->fixed_point = SUNNonlinSol_FixedPoint(y, 3, context);
    assert_int_equal(ARKodeSetNonlinearSolver(s->memory, s->fixed_point), 0);
}

static void open_cvode(struct solver *s, struct water *w, N_Vector y)
{
    s->memory = CVodeCreate(s->method == BDF ? CV_BDF : CV_ADAMS, context);
    assert_non_null(s->memory);
    assert_int_equal(CVodeInit(s->memory, explicit_rates, 0, y), 0);
    assert_int_equal(CVodeSetUserData(s->memory, w), 0);
    assert_int_equal(CVodeWFtolerances(s->memory, weigh), 0);
    s->fixed_point = SUNNonlinSol_FixedPoint(y, 3, context);
    assert_int_equal(CVodeSetNonlinearSolver(s->memory, s->fixed_point), 0);
}

static void close_solver(struct solver *s)
{
    if (s->method == ADAMS || s->method == BDF)
        CVodeFree(&s->memory);
    else
        ARKodeFree(&s->memory);
    if (s->fixed_point)
        SUNNonlinSolFree(s->fixed_point);
}

/* One accepted step; t is where it ended, h how long it was. */
static void step(const struct solver *s, N_Vector y, double *t, double *h)
{
    if (s->method == ADAMS || s->method == BDF) {
        assert_int_equal(CVode(s->memory, 1e9, y, t, CV_ONE_STEP), 0);
        assert_int_equal(CVodeGetLastStep(s->memory, h), 0);
    } else {
        assert_int_equal(ARKodeEvolve(s->memory, 1e9, y, t, ARK_ONE_STEP), 0);
        assert_int_equal(ARKodeGetLastStep(s->memory, h), 0);
    }
}

/* Dense output. */
static void look(const struct solver *s, struct water *w, double t, N_Vector to)
{
    if (s->method == ADAMS || s->method == BDF)
        assert_int_equal(CVodeGetDky(s->memory, t, 0, to), 0);
    else
        assert_int_equal(ARKodeGetDky(s->memory, t, 0, to), 0);
    see(w, vector_read(to));
}

/* To t = 1; rows change every `every` steps, never for 0. */
static void run(enum method method, enum vector_norm norm, int every, struct water *w)
{
    N_Vector y = vector_create(N, norm, context), seen;
    struct solver s = { .method = method };
    double t = 0, h;

    start(w, method == IMEX, vector_data(y));
    (method < ADAMS ? open_arkode : open_cvode)(&s, w, y);
    seen = N_VClone(y);
    while (t < 1) {
        step(&s, y, &t, &h);
        w->steps++;
        see(w, vector_read(y));
        look(&s, w, t - 0.3 * h, seen);
        if (every > 0 && w->steps % every == 0)
            shuffle(w, y);
        see(w, vector_read(y));
        see(w, vector_read(seen));
        look(&s, w, t - 0.7 * h, seen);
    }
    close_solver(&s);
    N_VDestroy(seen);
    N_VDestroy(y);
}

static void same_runs(enum method method, enum vector_norm norm)
{
    static const char *const names[METHODS] = { "explicit", "imex", "Adams", "BDF" };
    static const int every[] = { 1, 3, 7 };
    struct water still, moved;

    run(method, norm, 0, &still);
    assert_in_range(still.steps, 10, 2000);
    print_message("%s: %ld steps, %ld right-hand sides\n", names[method], still.steps,
                  still.calls);
    for (int k = 0; k < 3; k++) {
        run(method, norm, every[k], &moved);
        if (moved.steps != still.steps || moved.calls != still.calls || moved.seen != still.seen)
            fail_msg("%s, rows changed every %d steps: %ld steps, %ld right-hand sides, %s bits",
                     names[method], every[k], moved.steps, moved.calls,
                     moved.seen == still.seen ? "the same" : "other");
    }
}

static void integrators_do_not_notice(void **state)
{
    static const enum vector_norm norms[] = { VECTOR_NORM_MAX, VECTOR_NORM_P8, VECTOR_NORM_WRMS };

    (void)state;
    for (int method = 0; method < METHODS; method++)
        for (int k = 0; k < 3; k++)
            same_runs(method, norms[k]);
}

/* --- vectors in all states ----------------------------------------------- */

enum { VECTORS = 9 };

/* Own numbers, a copy that shares them, sums put off (one with a unit term, one that
 * reads what is overwritten later), zeros outside of ranges, nothing, norms. */
static void make(N_Vector y, N_Vector *v, double norm[4])
{
    static const long stiff[1][2] = { { SPEED, MORE } };
    double c[3] = { 1, 0.5, -0.25 };

    assert_int_equal(vector_ranges(y, 1, stiff), STATUS_DONE);
    v[0] = y;
    for (int k = 1; k < VECTORS; k++)
        v[k] = N_VClone(y);
    for (long i = 0; i < N; i++) {
        vector_data(v[0])[i] = sin(3.0 * (double)i);
        vector_data(v[1])[i] = 2 + cos(5.0 * (double)i);
        vector_data(v[2])[i] = i >= SPEED && i < MORE ? 0.1 * (double)i : 0;
    }
    vector_only_inside(v[2]);
    N_VScale(1, v[0], v[3]);
    N_VLinearSum(0.3, v[2], -0.7, v[1], v[4]);
    N_VLinearCombination(3, c, (N_Vector[]){ v[0], v[1], v[2] }, v[5]);
    N_VConst(0, v[6]);
    N_VScale(2, v[2], v[7]);
    N_VLinearSum(1, v[4], 1, v[0], v[8]);
    norm[0] = N_VWrmsNorm(v[8], v[1]);
}

/* What is asked about afterwards, by id. */
static void ask(const struct water *w, N_Vector *v, double norm[4], double got[VECTORS][N])
{
    norm[1] = N_VWrmsNorm(v[8], v[1]);
    norm[2] = N_VWrmsNorm(v[5], v[1]);
    norm[3] = N_VDotProd(v[7], v[4]);
    N_VConst(3, v[0]);
    for (int k = 0; k < VECTORS; k++)
        for (long i = 0; i < N; i++)
            got[k][i] = vector_read(v[k])[at(w, i)];
}

static void all_states_come_out_right(void **state)
{
    static double want[VECTORS][N], got[VECTORS][N];
    double norm[4], other[4];
    long largest = 0;

    (void)state;
    for (int times = 0; times < 3; times++) {
        N_Vector v[VECTORS];
        struct water w;

        v[0] = vector_create(N, VECTOR_NORM_P8, context);
        start(&w, false, vector_data(v[0]));
        make(v[0], v, times ? other : norm);
        for (int k = 0; k < times; k++)
            shuffle(&w, v[8 - k]);
        ask(&w, v, times ? other : norm, times ? got : want);
        if (times == 0)
            largest = vector_largest(v[5]);
        assert_int_equal(vector_largest(v[5]), at(&w, largest));
        for (int k = 0; k < VECTORS; k++)
            N_VDestroy(v[(k + 3) % VECTORS]);
        if (times == 0)
            continue;
        assert_memory_equal(want, got, sizeof want);
        assert_memory_equal(norm, other, sizeof norm);
    }
}

static void equals_are_told_by_the_first_id(void **state)
{
    N_Vector v = vector_create(N, VECTOR_NORM_MAX, context), one = N_VClone(v);
    struct water w;

    (void)state;
    start(&w, false, vector_data(v));
    N_VConst(0, v);
    N_VConst(1, one);
    for (int times = 0; times < 5; times++) {
        shuffle(&w, v);
        N_VConst(0, v);
        vector_data(v)[at(&w, 1001)] = vector_data(v)[at(&w, 901)] = -4;
        assert_true(N_VWrmsNorm(v, one) == 4);
        assert_int_equal(vector_largest(v), at(&w, 901));
        vector_data(v)[at(&w, 2900)] = vector_data(v)[at(&w, 2950)] = NAN;
        assert_int_equal(vector_bad(v), at(&w, 2900));
    }
    N_VDestroy(v);
    N_VDestroy(one);
}

static void what_makes_no_sense_is_refused(void **state)
{
    static const long stiff[1][2] = { { 2, 5 } };
    static const int twice[3] = { 0, 2, 2 }, beyond[3] = { 0, 1, 3 }, good[3] = { 2, 0, 1 };
    struct vector_rows block[2] = { { 6, 3, 1, good, NULL }, { 2, 3, 1, twice, NULL } };
    N_Vector v = vector_create(10, VECTOR_NORM_MAX, context);

    (void)state;
    assert_int_equal(vector_ranges(v, 1, stiff), STATUS_DONE);
    for (int i = 0; i < 10; i++)
        vector_data(v)[i] = i;
    assert_int_equal(vector_rearrange(v, 2, block), STATUS_FAILED);
    block[1].from = beyond;
    assert_int_equal(vector_rearrange(v, 2, block), STATUS_FAILED);
    block[1] = (struct vector_rows){ 3, 3, 1, good, NULL };
    assert_int_equal(vector_rearrange(v, 2, block), STATUS_FAILED);
    for (int i = 0; i < 10; i++)
        assert_true(vector_read(v)[i] == i);
    block[1].offset = 2;
    assert_int_equal(vector_rearrange(v, 2, block), STATUS_DONE);
    assert_true(vector_read(v)[2] == 4 && vector_read(v)[6] == 8 && vector_read(v)[5] == 5);
    N_VDestroy(v);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(integrators_do_not_notice),
        cmocka_unit_test(all_states_come_out_right),
        cmocka_unit_test(equals_are_told_by_the_first_id),
        cmocka_unit_test(what_makes_no_sense_is_refused),
    };
    int bad;

    if (sundials_open(&context) != STATUS_DONE)
        return 1;
    bad = cmocka_run_group_tests_name("rows that change places", tests, NULL, NULL);
    sundials_close(&context);
    return bad;
}
