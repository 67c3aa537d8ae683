/* restart.c -- a checkpoint: what a run does after one is what a new run does that starts
 * from the same y, to the bit, for every method; and looks in between change nothing.
 *
 * The first run stops after some steps, is restarted where it stands (moment_restart() and
 * the method's restart()) and goes on.  The second gets a new moment and a new method at that
 * t and y.  Both are watched: steps, states, dense output, what looks and counters say.  Then
 * the same again, with both going on at the pace of the steps before. */
#include "tank.h"

#include "base/status.h"
#include "output/hash.h"
#include "time/method.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef _OPENMP
#include <omp.h>
#endif

enum { BEFORE = 20, AFTER = 7, CUT = 3, INSIDE = 3, PLACES = 60 };

/* Steps before a restart and after it; with STIFFWATER_LONG as many as there is room for. */
static int before_it = 12, after_it = 5;

#define VISCOUS                                                                          \
    "effects = { continuity = { }; pressure = { }; density-diffusion = { };"             \
    " laminar-viscosity = { mu = 5.0; side = \"implicit\"; }; };"
#define ELASTICA                                                                         \
    "beam = { plate = { at = [0.0675, 0.0]; length = 0.05; thickness = 4e-3; E = 1e7;"   \
    "  density = 1200.0; elements = 4; layers = 3; alpha = 3.0;"                          \
    "  theory = \"elastica\"; }; };"

/* Water over a floor that repeats to the sides. */
#if DIM == 2
#define CELL                                                                             \
    "dimension = 2; until = 1.0; spacing = 5e-3; gravity = [3.0, -9.81];"                \
    "domain = { from = [0.0, 0.0]; to = [0.1, 0.08]; periodic = [\"x\"]; };"             \
    "fluid = { water = { type = \"box\"; from = [0.0, 0.0]; to = [0.1, 0.06]; }; };"     \
    "wall = { tank = { type = \"box\"; from = [0.0, -0.02]; to = [0.1, 0.0]; }; };"
#else
#define CELL                                                                             \
    "dimension = 3; until = 1.0; spacing = 2e-2; gravity = [3.0, 0.0, -9.81];"           \
    "domain = { from = [0.0, 0.0, 0.0]; to = [0.14, 0.14, 0.16]; periodic = [\"x\", \"y\"]; };" \
    "fluid = { water = { type = \"box\"; from = [0.0, 0.0, 0.0]; to = [0.14, 0.14, 0.12]; }; };" \
    "wall = { tank = { type = \"box\"; from = [0.0, 0.0, -0.06]; to = [0.14, 0.14, 0.0]; }; };"
#endif

/* Scenes; all have walls. */
static const struct scene_of {
    const char *name, *water, *text, *beam;
} scenes[] = {
    { "water", NULL, TANK_EFFECTS, "" },
    { "summed densities", NULL, TANK_SUMMED " eos = { tension = false; };", "" },
    { "contact walls", NULL, "walls = \"contact\";" TANK_EFFECTS, "" },
    { "walls with densities of their own", NULL, "walls = \"own-density\";" TANK_EFFECTS, "" },
    { "water that repeats", "cell", "walls = \"own-density\";" TANK_EFFECTS
      "mps = { bundle = \"enhanced\"; nu = 1e-4; };", "" },
    { "adami walls", NULL, "walls = \"adami\";" TANK_EFFECTS, "" },
    { "implicit viscosity", NULL, VISCOUS, "" },
#if DIM == 2
    { "beam", "parted", TANK_EFFECTS, "linear" },
    { "beam and contact walls", "parted", "walls = \"contact\";" TANK_EFFECTS, "linear" },
    { "elastica", "parted", TANK_EFFECTS, ELASTICA },
    { "implicit viscosity with a beam", "parted", VISCOUS, "linear" },
#endif
};
enum { SCENES = sizeof scenes / sizeof scenes[0] };

/* Besides those of the table: steps of one length, the last of them too long for beams that
 * are explicit, and so small a tol that beams in "mri" are limited by it. */
static const struct variant {
    const char *name;
    double tol;
} variants[] = { { "mri", 1e-6 }, { "imex3@1e-4s", 0 }, { "dv@1e-4s", 0 }, { "mri@1e-4s", 0 },
                 { "staggered@1e-4s", 0 }, { "cks43@1e-4s", 0 }, { "ab3@1e-4s", 0 },
                 { "gsl-rkf45@1e-4s", 0 }, { "leapfrog@1e-4s", 0 } };
enum { FOR_BEAMS = 5, VARIANTS = sizeof variants / sizeof variants[0] };

static void make(struct tank *t, const struct scene_of *of)
{
    const char *beam = strcmp(of->beam, "linear") == 0 ? tank_beam : of->beam;

    if (of->water && strcmp(of->water, "cell") == 0)
        tank_make(t, CELL, of->text, NULL);
    else
        tank_make(t, of->water ? tank_parted_water : tank_water, tank_frame, of->text, beam,
                  NULL);
    tank_shake(t, 11, 0.05, 0.5, 1e-3);
}

/* --- a run that is watched --------------------------------------------------------- */

/* All that is seen of a step. */
struct mark {
    struct method_step step;
    struct moment_counts counts;
    uint64_t state, inside, sheet, forces;
};

struct runner {
    const struct method *method;
    struct method_def def;
    const struct plan *plan;
    struct moment *moment;
    void *self;
    struct moment_counts counted; /* when the watch began                     */
    long rejected, all_rejected;  /* likewise; after the last step              */
    struct method_pace pace;      /* after the last step                        */
    double t;                     /* likewise                                   */
    bool looks;
    double *y;
};

static uint64_t hash_of(const struct runner *r, const double *y)
{
    return hash_bytes(HASH_START, y, (size_t)plan_size(r->plan) * sizeof *y);
}

static void start(struct runner *r, double t, const double *y)
{
    assert_int_equal(moment_create(r->plan, &r->moment), STATUS_DONE);
    if (r->method->create(r->method, &r->def, r->moment, t, y, &r->self) != STATUS_DONE)
        fail_msg("%s: %s", r->method->name, status_message());
    r->y = test_calloc((size_t)plan_size(r->plan) + 1, sizeof *r->y);
}

static void stop(struct runner *r)
{
    r->method->free(&r->self);
    moment_free(&r->moment);
    test_free(r->y);
}

static uint64_t sheet_at(const struct runner *r, double t, const double *y)
{
    struct book_sheet s;
    uint64_t hash;

    observe_sheet(r->moment, t, y, &s);
    hash = hash_bytes(HASH_START, &s.energy, sizeof s.energy);
    hash = hash_bytes(hash, s.work, (size_t)s.works * sizeof *s.work);
    return hash_bytes(hash, s.momentum, sizeof s.momentum);
}

static uint64_t forces_at(const struct runner *r, double t, const double *y)
{
    uint64_t hash = HASH_START;

    if (observe_forces(r->moment, t, y) != STATUS_DONE)
        fail_msg("no look at forces: %s", status_message());
    for (int i = 0; i < plan_particles(r->plan)->objects; i++)
        hash = hash_bytes(hash, observe_force(r->moment, i), DIM * sizeof(double));
    return hash;
}

/* Dense output, sheet and forces at times within the step, and at its end. */
static void look(struct runner *r, struct mark *m)
{
    m->inside = m->sheet = m->forces = HASH_START;
    for (int i = 1; i <= INSIDE; i++) {
        const double t = i == INSIDE ? m->step.t : m->step.t - m->step.h * (INSIDE - i) / INSIDE;
        if (r->method->at(r->self, t, r->y) != STATUS_DONE)
            fail_msg("%s: %s", r->method->name, status_message());
        m->inside = 3 * m->inside + hash_of(r, r->y);
        m->sheet = 3 * m->sheet + sheet_at(r, t, r->y);
        m->forces = 3 * m->forces + forces_at(r, t, r->y);
    }
}

static void step(struct runner *r, double t_stop, struct mark *m)
{
    memset(m, 0, sizeof *m);
    if (r->method->step(r->self, t_stop, &m->step) != STATUS_DONE)
        fail_msg("%s: %s", r->method->name, status_message());
    r->all_rejected = m->step.rejected;
    m->step.rejected -= r->rejected;
    r->pace = m->step.pace;
    r->t = m->step.t;
    m->state = hash_of(r, r->method->state(r->self));
    if (r->looks)
        look(r, m);
    m->counts = *moment_counts(r->moment);
}

/* Some steps; after CUT of them a segment ends within the next. */
static void go(struct runner *r, int steps, struct mark *mark)
{
    r->counted = *moment_counts(r->moment);
    for (int i = 0; i < steps; i++) {
        const bool cut = i == CUT;
        step(r, cut ? mark[i - 1].step.t + 0.4 * mark[i - 1].step.h : 1, &mark[i]);
    }
}

static void restart(struct runner *r, const struct method_pace *pace)
{
    struct mark last = { .step = { .t = r->t } };

    if (r->looks)
        look(r, &last);
    moment_restart(r->moment);
    assert_int_equal(r->method->restart(r->self, r->t, r->method->state(r->self), pace),
                     STATUS_DONE);
}

/* --- what is to be the same --------------------------------------------------------- */

static void place_of(char text[PLACES + 160], const struct scene_of *of, const struct runner *r,
                     int i)
{
    snprintf(text, PLACES + 160, "%s, %s, step %d", of->name, r->method->name, i + 1);
}

static void same_steps(const char *where, const struct mark *a, const struct mark *b)
{
    check(a->step.t == b->step.t && a->step.h == b->step.h, "%s: to %.17g s by %.17g s, and to "
          "%.17g s by %.17g s", where, a->step.t, a->step.h, b->step.t, b->step.h);
    check(a->step.limiter == b->step.limiter && strcmp(a->step.where, b->step.where) == 0,
          "%s: limited by %s, and by %s", where, a->step.where, b->step.where);
    check(a->step.rejected == b->step.rejected, "%s: %ld and %ld rejected", where,
          a->step.rejected, b->step.rejected);
    check(a->state == b->state, "%s: another state", where);
}

static void same_looks(const char *where, const struct mark *a, const struct mark *b)
{
    check(a->inside == b->inside, "%s: another dense output", where);
    check(a->sheet == b->sheet, "%s: another sheet", where);
    check(a->forces == b->forces, "%s: other forces", where);
}

static void same_count(const char *where, const char *what, long a, long a0, long b, long b0)
{
    check(a - a0 == b - b0, "%s: %ld and %ld %s", where, a - a0, b - b0, what);
}

static void same_counts(const char *where, const struct moment_counts *a,
                        const struct moment_counts *a0, const struct moment_counts *b,
                        const struct moment_counts *b0)
{
#define SAME(MEMBER) same_count(where, #MEMBER, a->MEMBER, a0->MEMBER, b->MEMBER, b0->MEMBER)
    SAME(rhs_explicit);
    SAME(rhs_implicit);
    SAME(passes);
    SAME(solves);
    SAME(products);
    SAME(rebuilds);
    SAME(refused);
#undef SAME
}

/* --- the test ------------------------------------------------------------------------- */

/* A new moment and a new method, from the y of a run that is then restarted. */
static void anew(const struct scene_of *of, struct runner *a, bool carry)
{
    const struct method_pace pace = a->pace;
    const double t = a->t;
    struct runner b = { .method = a->method, .def = a->def, .plan = a->plan, .looks = true };
    struct mark one[AFTER], other[AFTER];
    char where[PLACES + 160];

    start(&b, t, a->method->state(a->self));
    if (carry)
        assert_int_equal(b.method->restart(b.self, t, a->method->state(a->self), &pace),
                         STATUS_DONE);
    restart(a, carry ? &pace : NULL);
    a->rejected = a->all_rejected;
    go(a, after_it, one);
    go(&b, after_it, other);
    for (int i = 0; i < after_it; i++) {
        place_of(where, of, a, i);
        same_steps(where, &one[i], &other[i]);
        same_looks(where, &one[i], &other[i]);
        same_counts(where, &one[i].counts, &a->counted, &other[i].counts, &b.counted);
    }
    stop(&b);
}

/* The same run again, with nothing that looks. */
static void unseen(const struct scene_of *of, const struct tank *t, const struct runner *seen,
                   const struct mark *before)
{
    struct runner c = { .method = seen->method, .def = seen->def, .plan = t->plan };
    struct mark mark[BEFORE], after[AFTER];
    char where[PLACES + 160];

    start(&c, 0, t->y);
    go(&c, before_it, mark);
    for (int i = 0; i < before_it; i++) {
        place_of(where, of, seen, i - before_it);
        same_steps(where, &mark[i], &before[i]);
    }
    restart(&c, NULL);
    go(&c, after_it, after);
    restart(&c, &after[after_it - 1].step.pace);
    go(&c, after_it, after);
    check(after[after_it - 1].state == hash_of(seen, seen->method->state(seen->self)),
          "%s, %s: another state after looks", of->name, seen->method->name);
    stop(&c);
}

static void one_method(const struct scene_of *of, const struct tank *t, const char *name,
                       double tol)
{
    struct runner a = { .def = method_def_default(), .plan = t->plan, .looks = true };
    struct mark before[BEFORE];

    assert_int_equal(method_find(name, &a.def, &a.method), STATUS_DONE);
    if (tol > 0)
        a.def.tol = tol;
    if (a.method->serves(t->plan))
        return;
    start(&a, 0, t->y);
    go(&a, before_it, before);
    anew(of, &a, false);
    anew(of, &a, true);
    unseen(of, t, &a, before);
    stop(&a);
}

/* In 3D each method has every second scene, as in 2D it has all: the kinds of state are the same. */
static bool chosen(const struct scene_of *of, int method)
{
    return DIM == 2 || before_it == BEFORE || (of - scenes + method) % 2 == 0;
}

static void every_method(const struct scene_of *of)
{
    struct tank t;

    make(&t, of);
    for (int i = 0; method_table[i]; i++)
        if (chosen(of, i))
            one_method(of, &t, method_table[i]->name, 0);
    for (int i = 0; i < (of->water ? FOR_BEAMS : VARIANTS); i++)
        one_method(of, &t, variants[i].name, variants[i].tol);
    tank_free(&t);
}

static void a_restart_is_a_start(void **state)
{
    (void)state;
    if (getenv("STIFFWATER_LONG")) {
        before_it = BEFORE;
        after_it = AFTER;
    }
    for (int i = 0; i < SCENES; i++)
        every_method(&scenes[i]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_restart_is_a_start),
    };

#ifdef _OPENMP
    omp_set_num_threads(1); /* bits do not depend on it: small tanks do not repay more */
#endif
    return cmocka_run_group_tests(tests, NULL, NULL);
}
