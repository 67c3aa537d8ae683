/* shuffle.c -- rows of particles change places at random while a run goes on: no bit of what
 * follows depends on it, for ids, places and sums are what they were.
 *
 * One run stands still; others are shuffled after every 1, 7 and 23 steps.  All go side by
 * side, and after each step they agree about it, about the state and the state within the
 * step by ids, and every few steps about all that outputs show. */
#include "tank.h"

#include "base/status.h"
#include "eval/rearrange.h"
#include "measure/crowd.h"
#include "measure/front.h"
#include "measure/pairing.h"
#include "measure/probe.h"
#include "output/hash.h"
#include "time/method.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { RUNS = 4, STEPS = 28, CUT = 20, LOOK = 10, BRIEF = 10, SHOWN = 200 };
static const int every[RUNS] = { 0, 1, 7, 23 };

/* How many of these run: where steps are few, the last would not differ from the first. */
static int runs(void)
{
    return tank_brief() ? RUNS - 1 : RUNS;
}

/* Water that leaves on one side and comes in again on the other, over a floor. */
#if DIM == 2
#define CELL                                                                             \
    "dimension = 2; until = 1.0; spacing = 5e-3; gravity = [3.0, -9.81];"                \
    "domain = { from = [0.0, 0.0]; to = [0.1, 0.08]; periodic = [\"x\"]; };"             \
    "fluid = { water = { type = \"box\"; from = [0.0, 0.0]; to = [0.1, 0.06]; }; };"
#define FLOOR "wall = { tank = { type = \"box\"; from = [0.0, -0.02]; to = [0.1, 0.0]; }; };"
#else
#define CELL                                                                             \
    "dimension = 3; until = 1.0; spacing = 2e-2; gravity = [3.0, 0.0, -9.81];"           \
    "domain = { from = [0.0, 0.0, 0.0]; to = [0.14, 0.14, 0.16]; periodic = [\"x\", \"y\"]; };" \
    "fluid = { water = { type = \"box\"; from = [0.0, 0.0, 0.0]; to = [0.14, 0.14, 0.12]; }; };"
#define FLOOR "wall = { tank = { type = \"box\"; from = [0.0, 0.0, -0.06];"             \
    " to = [0.14, 0.14, 0.0]; }; };"
#endif

#define MOVED "wall = { tank = { type = \"frame\"; spin = 40.0; velocity = "

#define AHEAD "eos = { type = \"look-ahead\"; };"

/* What goes through each kind of sum, of weights and of blocks of y. */
static const char *const scenes[][4] = {
#if DIM == 2
    { "", MOVED "[0.1, 0.05]; }; };", TANK_EFFECTS TANK_ONE_KERNEL },
    { "beam", "", "walls = \"own-density\";" TANK_EFFECTS TANK_ONE_KERNEL },
    { "beam", MOVED "[0.1, 0.05]; }; };", "walls = \"contact\";" TANK_EFFECTS TANK_ONE_KERNEL },
    { "beam", MOVED "[0.1, 0.05]; }; };",
      "walls = \"adami\"; effects = { continuity = { }; pressure = { };"
      " laminar-viscosity = { mu = 3.0; side = \"implicit\"; }; };" TANK_ONE_KERNEL },
    { "", "", TANK_SUMMED "eos = { tension = false; };" TANK_ONE_KERNEL },
    { "", "", "walls = \"adami\"; effects = { continuity = { }; pressure = { };"
      " particle-shifting = { }; };" TANK_ONE_KERNEL },
    { "", "", "effects = { continuity = { }; pressure = { }; central-force = { omega = 3.0; }; };"
      TANK_ONE_KERNEL },
    { "cell", FLOOR, "walls = \"own-density\";" TANK_EFFECTS },
    { "", MOVED "[0.1, 0.05]; }; };", "walls = \"own-density\";" TANK_EFFECTS TANK_ONE_KERNEL
      "mps = { bundle = \"enhanced\"; nu = 1e-4; };" },
    { "", MOVED "[0.1, 0.05]; }; };", AHEAD "walls = \"contact\";" TANK_EFFECTS TANK_ONE_KERNEL },
    { "", "", AHEAD "walls = \"own-density\";" TANK_EFFECTS TANK_ONE_KERNEL },
#else
    { "", MOVED "[0.1, 0.05, 0.0]; }; };", AHEAD "walls = \"contact\";" TANK_EFFECTS },
    { "", MOVED "[0.1, 0.05, 0.0]; }; };", TANK_EFFECTS },
    { "", MOVED "[0.1, 0.05, 0.0]; }; };", "walls = \"contact\";" TANK_EFFECTS },
    { "", "", "walls = \"own-density\"; effects = { continuity = { }; pressure = { };"
      " laminar-viscosity = { mu = 3.0; side = \"implicit\"; }; };" },
    { "cell", FLOOR, TANK_EFFECTS },
    { "cell", FLOOR, "walls = \"own-density\";" TANK_EFFECTS TANK_ONE_KERNEL },
#endif
};
enum { SCENES = sizeof scenes / sizeof scenes[0] };

struct runner {
    struct tank tank;
    const struct method *method;
    void *self;
    struct method_step step;
    double *y, *between; /* [n] by id: now, and within the last step */
    struct crowd *crowd;
    struct pairing *pairing;
    unsigned seed;
    double shown[SHOWN];
    int many;
};

static void make(struct tank *t, int scene)
{
    const bool beam = strcmp(scenes[scene][0], "beam") == 0;
    const bool cell = strcmp(scenes[scene][0], "cell") == 0;

    tank_make(t, beam ? tank_parted_water : cell ? CELL : DIM == 2 ? tank_bare_water : tank_water,
              beam ? tank_beam : "", scenes[scene][1][0] ? scenes[scene][1] : tank_frame,
              scenes[scene][2], cell ? "panel = { p = { of = \"tank\"; }; };"
                                   : "panel = { p = { of = \"tank\"; side = \"left\"; }; };", NULL);
    tank_shake(t, 7, 0.1, 0.5, 0.005);
}

static void begin(struct runner *r, int scene, const char *name)
{
    struct method_def def = method_def_default();

    *r = (struct runner){ .seed = 99 };
    make(&r->tank, scene);
    def.norm = (enum vector_norm)(scene % 3);
    assert_int_equal(method_find(name, &def, &r->method), STATUS_DONE);
    if (r->method->create(r->method, &def, r->tank.moment, 0, r->tank.y, &r->self) != STATUS_DONE)
        fail_msg("%s: %s", name, status_message());
    r->y = tank_copy(&r->tank, r->tank.y);
    r->between = tank_copy(&r->tank, r->tank.y);
    assert_int_equal(crowd_create(plan_particles(r->tank.plan), &r->crowd), STATUS_DONE);
    assert_int_equal(pairing_create(plan_particles(r->tank.plan), &r->pairing), STATUS_DONE);
}

static void end(struct runner *r)
{
    r->method->free(&r->self);
    test_free(r->y);
    test_free(r->between);
    crowd_free(&r->crowd);
    pairing_free(&r->pairing);
    tank_free(&r->tank);
}

/* --- shuffling ------------------------------------------------------------------- */

static void draw(int *from, int n, unsigned *seed)
{
    for (int i = 0; i < n; i++)
        from[i] = i;
    for (int i = n - 1; i > 0; i--) {
        const int j = (int)((tank_random(seed) + 1) / 2 * (i + 1)), was = from[i];
        from[i] = from[j];
        from[j] = was;
    }
}

static int shuffle(struct runner *r)
{
    const struct particles *p = plan_particles(r->tank.plan);
    int *all = test_malloc(p->n * sizeof *all);
    struct vector_rows row[MOMENT_ROWS];
    const int *from[KINDS];
    int status;

    for (int k = 0; k < KINDS; k++) {
        draw(all + p->from[k], particles_count(p, k), &r->seed);
        from[k] = particles_count(p, k) > 0 ? all + p->from[k] : NULL;
    }
    status = r->method->rearrange(r->self, moment_rows(r->tank.moment, from, row), row);
    if (status == STATUS_DONE)
        status = moment_rearrange(r->tank.moment, from);
    test_free(all);
    return status;
}

/* --- what is seen ---------------------------------------------------------------- */

static void show(struct runner *r, double value)
{
    assert_true(r->many < SHOWN);
    r->shown[r->many++] = value;
}

static void show_sheet(struct runner *r, double t, const double *y)
{
    struct book_sheet s;

    observe_sheet(r->tank.moment, t, y, &s);
    show(r, s.energy.kinetic);
    show(r, s.energy.potential);
    show(r, s.energy.internal);
    show(r, s.energy.elastic);
    show(r, s.mass);
    show(r, s.pressure_defect);
    for (int i = 0; i < s.works; i++)
        show(r, s.work[i]);
    for (int d = 0; d < DIM; d++)
        show(r, s.momentum[d] + s.momentum_given[d]);
}

static void show_forces(struct runner *r, double t, const double *y)
{
    const struct particles *p = plan_particles(r->tank.plan);
    struct observe_panel panel;
    struct body_view body;

    if (observe_forces(r->tank.moment, t, y) != STATUS_DONE)
        fail_msg("%s", status_message());
    for (int i = 0; i < p->objects; i++)
        for (int d = 0; d < DIM; d++)
            show(r, observe_force(r->tank.moment, i)[d]);
    observe_panel(r->tank.moment, 0, &panel);
    show(r, panel.force[0]);
    show(r, panel.turn[2]);
    for (int i = 0; i < plan_bodies(r->tank.plan); i++) {
        observe_body(r->tank.moment, i, t, y, &body);
        show(r, body.tip[0]);
        show(r, body.root_force);
        show(r, body.root_moment);
    }
}

static void show_water(struct runner *r, double t, const double *y)
{
    const double at[DIM] = { 0.03, 0.03 };
    struct pairing_index found;
    struct front front;
    double u[DIM];
    struct view v;

    observe_view(r->tank.moment, t, y, &v);
    crowd_update(r->crowd, &v);
    front_find(r->crowd, &front);
    show(r, front.x);
    show(r, front.height);
    show(r, probe_pressure(r->crowd, v.rho[KIND_FLUID], at));
    probe_velocity(r->crowd, at, u);
    show(r, u[0]);
    show(r, probe_height(r->crowd, at, DIM - 1));
    pairing_find(r->pairing, &v, &found);
    show(r, found.share);
    show(r, found.mean);
    show(r, found.least);
}

static void show_rest(struct runner *r, double t, const double *y)
{
    struct observe_sunk sunk;
    struct limit limit[2];
    char text[1000];

    observe_sunk(r->tank.moment, t, y, &sunk);
    show(r, sunk.n);
    show(r, sunk.particle);
    moment_limit(r->tank.moment, t, y, true, limit);
    for (int i = 0; i < 2; i++) {
        show(r, limit[i].rate);
        show(r, limit[i].where);
    }
    observe_blame(r->tank.moment, t, y, text, sizeof text);
    show(r, (double)hash_bytes(HASH_START, text, strlen(text)));
}

static void look(struct runner *r)
{
    const double *y = r->method->state(r->self), t = r->step.t;

    r->many = 0;
    show_sheet(r, t, y);
    show_forces(r, t, y);
    show_water(r, t, y);
    show_rest(r, t, y);
}

/* --- side by side ------------------------------------------------------------------ */

static void step(struct runner *r, int k)
{
    const struct method_step last = r->step;
    const double t_stop = k == (tank_brief() ? BRIEF / 2 : CUT) ? last.t + last.h / 2 : last.t + 1;

    if (r->method->step(r->self, t_stop, &r->step) != STATUS_DONE)
        fail_msg("%s, step %d: %s", r->method->name, k, status_message());
    moment_by_id(r->tank.moment, r->method->state(r->self), r->y);
}

static void see_between(struct runner *r)
{
    const double t = r->step.t - 0.4 * r->step.h;

    if (r->method->at(r->self, t, r->tank.ydot) != STATUS_DONE)
        fail_msg("%s: %s", r->method->name, status_message());
    moment_by_id(r->tank.moment, r->tank.ydot, r->between);
}

static void check_same(const struct runner *a, const struct runner *b, int times, int k,
                       const double *one, const double *other, long n, const char *what)
{
    for (long i = 0; i < n; i++)
        check(memcmp(&one[i], &other[i], sizeof *one) == 0, "%s, shuffled every %d steps, step "
              "%d: %s %ld (%s) is %.17g, not %.17g", b->method->name, times, k, what, i,
              n == a->tank.n ? moment_entry(a->tank.moment, i) : "", other[i], one[i]);
}

static void check_counts(const struct runner *a, const struct runner *b, int times, int k)
{
    const struct moment_counts *one = moment_counts(a->tank.moment),
                               *other = moment_counts(b->tank.moment);

    check(a->step.t == b->step.t && a->step.h == b->step.h && a->step.rejected == b->step.rejected
          && a->step.limiter == b->step.limiter && strcmp(a->step.where, b->step.where) == 0,
          "%s, shuffled every %d steps: step %d ends at %.17g (%s), not %.17g (%s)",
          b->method->name, times, k, b->step.t, b->step.where, a->step.t, a->step.where);
    check(memcmp(one, other, sizeof *one) == 0, "%s, shuffled every %d steps, step %d: %ld right-"
          "hand sides, not %ld, %ld rebuilds, not %ld", b->method->name, times, k,
          other->rhs_explicit, one->rhs_explicit, other->rebuilds, one->rebuilds);
}

static void check_runs(const struct runner *run, int k)
{
    const struct runner *a = &run[0];

    for (int i = 1; i < runs(); i++) {
        const struct runner *b = &run[i];

        check_counts(a, b, every[i], k);
        check_same(a, b, every[i], k, a->y, b->y, a->tank.n, "entry");
        check_same(a, b, every[i], k, a->between, b->between, a->tank.n, "dense output");
        if (k % LOOK == 0)
            check_same(a, b, every[i], k, a->shown, b->shown, a->many, "output");
    }
}

/* A look within the step, before or after the shuffle, shows the same. */
static void go(struct runner *r, int k, int times)
{
    step(r, k);
    if (k % 2)
        see_between(r);
    if (times > 0 && k % times == 0 && shuffle(r) != STATUS_DONE)
        fail_msg("%s: %s", r->method->name, status_message());
    if (k % 2 == 0)
        see_between(r);
    if (k % LOOK == 0)
        look(r);
}

/* How often the list was made. */
static long check_method(int scene, const char *name)
{
    struct runner run[RUNS];
    const int steps = getenv("STIFFWATER_LONG") ? 2 * STEPS : tank_brief() ? BRIEF : STEPS;
    long rebuilds;

    for (int i = 0; i < runs(); i++)
        begin(&run[i], scene, name);
    for (int k = 1; k <= steps; k++) {
        for (int i = 0; i < runs(); i++)
            go(&run[i], k, every[i]);
        check_runs(run, k);
    }
    rebuilds = moment_counts(run[0].tank.moment)->rebuilds;
    for (int i = 0; i < runs(); i++)
        end(&run[i]);
    return rebuilds;
}

/* Those of GSL say beforehand that they keep the past where it cannot be reached. */
static long check_refusal(int scene, const char *name)
{
    struct runner r;

    begin(&r, scene, name);
    assert_null(r.method->rearrange);
    end(&r);
    return 0;
}

/* In space, where space repeats, and for keys of mps, one of each kind. */
static bool chosen(int scene, const char *name)
{
    static const char *const all[] = { "imex3", "adams", "ab3", "dv", "leapfrog", "pcisph",
                                      "mps" };

    if (DIM == 2 && strcmp(scenes[scene][0], "cell") != 0 && !strstr(scenes[scene][2], "mps"))
        return true;
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++)
        if (strcmp(all[i], name) == 0)
            return true;
    return false;
}

static bool serves(int scene, const struct method *m)
{
    struct tank t;
    bool does;

    make(&t, scene);
    does = m->serves(t.plan) == NULL;
    tank_free(&t);
    return does;
}

/* Made once and anew. */
static void check_scene(int scene)
{
    const char *only = getenv("SHUFFLE"); /* NULL, or a part of names of methods; "": all */
    long rebuilds = 0;

    for (int i = 0; method_table[i]; i++) {
        const char *name = method_table[i]->name;
        if ((only ? !strstr(name, only) : !chosen(scene, name))
            || !serves(scene, method_table[i]))
            continue;
        if (only)
            print_message("scene %d, %s\n", scene, name);
        rebuilds += (strncmp(name, "gsl-", 4) == 0 ? check_refusal : check_method)(scene, name);
    }
    check(only || rebuilds > (tank_brief() ? 2 : 20), "scene %d: lists were made %ld times in all", scene, rebuilds);
}

static void rows_do_not_matter(void **state)
{
    (void)state;
    for (int scene = 0; scene < SCENES; scene++)
        check_scene(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_do_not_matter),
    };

    return cmocka_run_group_tests_name("shuffle", tests, NULL, NULL);
}
