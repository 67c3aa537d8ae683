/* face.c -- the fluid sticks at the faces of solids, and faces may slide: the forces are
 * those of (W2), never drive the fluid, keep the books, and a shear flow finds the wall
 * where its face is. */
#include "tank.h"

#include "base/status.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#if DIM == 2
#define SURFACE "[0.6, -0.2]"
#define VELOCITY "[0.3, 0.5]"
#else
#define SURFACE "[0.6, -0.2, 0.3]"
#define VELOCITY "[0.3, 0.5, -0.4]"
#endif
#define MU 0.7
#define LAMINAR(keys)                                                                    \
    "effects = { continuity = { }; laminar-viscosity = { mu = 0.7;" keys " }; };"
#define PARTICLES "stick = \"particles\";"

static const char *const walls[] = {
    "wall = { tank = { type = \"frame\"; }; };",
    "wall = { tank = { type = \"frame\"; velocity = " VELOCITY "; }; };",
    "wall = { tank = { type = \"frame\"; surface = " SURFACE "; }; };",
    "wall = { tank = { type = \"frame\"; surface = " SURFACE "; velocity = " VELOCITY "; }; };",
};
enum { WALLS = sizeof walls / sizeof walls[0], SLIDE = 2 };

static void make(struct tank *t, const char *wall, const char *keys, unsigned seed)
{
    tank_make(t, tank_bare_water, TANK_ONE_KERNEL, wall, keys, NULL);
    tank_shake(t, seed, 0.3, 1, 0.02);
}

/* --- the formula --------------------------------------------------------------- */

/* c_ab of (V1) with (K1), by pow(). */
static double coupling(const struct view *v, int wall, int fluid)
{
    const double H = v->p->scales->support, hs = H / 2;
    const double sigma = DIM == 2 ? 7 / M_PI : 21 / (2 * M_PI);
    const double *a = v->x[KIND_WALL] + (size_t)wall * DIM;
    const double *b = v->x[KIND_FLUID] + (size_t)fluid * DIM;
    double r2 = 0, q;

    for (int d = 0; d < DIM; d++)
        r2 += pow(a[d] - b[d], 2);
    q = sqrt(r2) / H;
    if (q >= 1)
        return 0;
    return 2 * MU * v->p->m[v->p->from[KIND_WALL] + wall] * v->p->m[fluid]
           / (v->rho[KIND_WALL][wall] * v->rho[KIND_FLUID][fluid])
           * sigma * pow(H, -DIM - 1) * 20 * q * pow(1 - q, 3) * sqrt(r2)
           / (r2 + 0.01 * hs * hs);
}

/* Adds the force of one wall particle with the velocity that (W2) gives it to those on
 * the fluid, less that with its own: f [fluid][DIM]. */
static void add_wall(const struct view *v, int wall, double *f)
{
    const int n = particles_count(v->p, KIND_FLUID), c = v->p->from[KIND_WALL] + wall;
    const double *u = v->p->u[c], *b = v->p->object[v->p->object_of[c]].slide;
    double sum[DIM] = { 0 }, all = 0, *c_wf = test_calloc((size_t)n, sizeof *c_wf);

    for (int i = 0; i < n; i++) {
        c_wf[i] = coupling(v, wall, i);
        all += c_wf[i];
        for (int d = 0; d < DIM; d++)
            sum[d] += c_wf[i] * v->u[KIND_FLUID][i * DIM + d];
    }
    for (int i = 0; i < n && all > 0; i++)
        for (int d = 0; d < DIM; d++)
            f[i * DIM + d] += c_wf[i] * (2 * (u[d] + b[d]) - sum[d] / all - u[d]);
    test_free(c_wf);
}

static void forces_follow_the_formula(void **state)
{
    (void)state;
    for (int w = 0; w < WALLS; w++) {
        struct tank face, bare;
        struct view v;
        double *f, most = 0;
        long u;
        make(&face, walls[w], LAMINAR(""), 3);
        make(&bare, walls[w % SLIDE], LAMINAR(PARTICLES), 3);
        tank_rates(&face, 0.01, face.y, face.ydot);
        tank_rates(&bare, 0.01, face.y, bare.ydot);
        u = tank_at(&face, "velocity of fluid", NULL);
        observe_view(face.moment, 0.01, face.y, &v);
        const int n = particles_count(v.p, KIND_FLUID);
        f = test_calloc((size_t)n * DIM, sizeof *f);
        for (int i = 0; i < particles_count(v.p, KIND_WALL); i++)
            add_wall(&v, i, f);
        for (int i = 0; i < n * DIM; i++)
            most = fmax(most, fabs(f[i] / v.p->m[i / DIM]));
        check(most > 1, "walls %d: nothing happens", w);
        for (int i = 0; i < n * DIM; i++) {
            const double got = face.ydot[u + i] - bare.ydot[u + i];
            check(fabs(got - f[i] / v.p->m[i / DIM]) < 1e-9 * most,
                  "walls %d, particle %d: %.12g m/s^2 more, not %.12g", w, i / DIM, got,
                  f[i] / v.p->m[i / DIM]);
        }
        test_free(f);
        tank_free(&face);
        tank_free(&bare);
    }
}

/* --- books --------------------------------------------------------------------- */

/* Works of the sheet so long after y: rates of the book times h. */
static void sheet_after(struct tank *t, double h, struct book_sheet *s, double *viscous)
{
    double *y = tank_copy(t, t->y);
    char name[BOOK_WORKS][80];

    for (long i = 0; i < t->n; i++)
        y[i] += h * t->ydot[i];
    observe_sheet(t->moment, 0.01 + h, y, s);
    test_free(y);
    book_work_names(t->plan, name);
    *viscous = NAN;
    for (int i = 0; i < s->works; i++)
        if (strcmp(name[i], "laminar-viscosity") == 0)
            *viscous = s->work[i] / h;
}

/* Weight, pressure and what density does are left out: only viscosity moves energy. */
static void check_books(struct tank *t, const char *what, bool brakes)
{
    const double h = 1e-3;
    const struct particles *p = plan_particles(t->plan);
    const double *u = t->y + tank_at(t, "velocity of fluid", NULL);
    const double *udot = t->ydot + tank_at(t, "velocity of fluid", NULL);
    double power = 0, works = 0, viscous, g[DIM];
    struct book_sheet s;

    tank_rates(t, 0.01, t->y, t->ydot);
    memcpy(g, plan_scales(t->plan)->g, sizeof g);
    sheet_after(t, h, &s, &viscous);
    for (int i = 0; i < s.works; i++)
        works += s.work[i] / h;
    for (int d = 0; d < DIM; d++) {
        double sum = 0, size = 0;
        for (int i = 0; i < particles_count(p, KIND_FLUID); i++) {
            const double f = p->m[i] * (udot[i * DIM + d] - g[d]);
            power += f * u[i * DIM + d];
            sum += f;
            size += fabs(f);
        }
        for (int o = 0; o < p->objects; o++)
            sum += p->object[o].kind == KIND_FLUID ? 0 : moment_force(t->moment, o)[d];
        check(fabs(sum) < 1e-12 * size, "%s: %g N of %g N come from nowhere", what, sum, size);
    }
    check(fabs(power - works) < 1e-10 * (fabs(power) + fabs(viscous)),
          "%s: kinetic energy changes by %.12g W, the book says %.12g W", what, power, works);
    check(!brakes || viscous < -1e-3, "%s: viscosity gives %g W", what, viscous);
}

static void books_close_and_viscosity_only_takes(void **state)
{
    static const char *const keys[] = { LAMINAR(""), LAMINAR(PARTICLES) };

    (void)state;
    for (int k = 0; k < 2; k++)
        for (int w = 0; w < WALLS; w++)
            for (unsigned seed = 1; seed <= (DIM == 2 ? 6 : 2); seed++) {
                struct tank t;
                char what[80];
                make(&t, walls[w], keys[k], seed);
                snprintf(what, sizeof what, "%s, walls %d, seed %u", k ? "particles" : "faces", w,
                         seed);
                check_books(&t, what, true);
                tank_free(&t);
            }
}

#if DIM == 2
static void books_close_beside_a_beam(void **state)
{
    (void)state;
    for (unsigned seed = 1; seed <= 4; seed++) {
        struct tank t;
        const double *g;
        double sum = 0, size = 0;
        tank_make(&t, tank_parted_water, TANK_ONE_KERNEL, tank_frame, tank_beam, LAMINAR(""), NULL);
        tank_shake(&t, seed, 0.3, 1, 0.02);
        tank_rates(&t, 0.01, t.y, t.ydot);
        const struct particles *p = plan_particles(t.plan);
        const double *udot = t.ydot + tank_at(&t, "velocity of fluid", NULL);
        g = plan_scales(t.plan)->g;
        for (int i = 0; i < particles_count(p, KIND_FLUID); i++) {
            sum += p->m[i] * (udot[i * DIM] - g[0]);
            size += p->m[i] * fabs(udot[i * DIM]);
        }
        for (int o = 0; o < p->objects; o++)
            sum += p->object[o].kind == KIND_FLUID ? 0 : moment_force(t.moment, o)[0];
        check(fabs(sum) < 1e-12 * size, "%g N of %g N come from nowhere", sum, size);
        tank_free(&t);
    }
}
#endif

/* --- flows ---------------------------------------------------------------------- */

#if DIM == 2
#define CHANNEL(keys, wall)                                                                    \
    "dimension = 2; until = 1.0; spacing = 0.01; eos = { c0 = 10.0; };"                  \
    "domain = { from = [0.0, 0.0]; to = [0.2, 0.1]; periodic = [\"x\"]; " keys "};"              \
    "fluid = { a = { from = [0.0, 0.0]; to = [0.2, 0.1]; }; };" wall
#define ACROSS 0.2
#else
#define CHANNEL(keys, wall)                                                                    \
    "dimension = 3; until = 1.0; spacing = 0.01; eos = { c0 = 10.0; };"                  \
    "domain = { from = [0.0, 0.0, 0.0]; to = [0.08, 0.08, 0.1]; periodic = [\"x\", \"y\"];" \
    keys "};"                                                                            \
    "fluid = { a = { from = [0.0, 0.0, 0.0]; to = [0.08, 0.08, 0.1]; }; };" wall
#define ACROSS (0.08 * 0.08)
#endif

/* u = G z above the floor: mu G on its face, (V1) itself 1 to 3 % below.  With the fluid
 * held where particles are it is half. */
static void shear_finds_the_face(void **state)
{
    const double slope = 3;

    (void)state;
    for (int k = 0; k < 2; k++) {
        struct tank t;
        double force = 0;
        tank_make(&t, CHANNEL("lid = false; ", "wall = { floor = { type = \"frame\"; }; };"),
                  k ? LAMINAR(PARTICLES) : LAMINAR(""), NULL);
        const struct particles *p = plan_particles(t.plan);
        const long u = tank_at(&t, "velocity of fluid", NULL);
        for (int i = 0; i < particles_count(p, KIND_FLUID); i++)
            t.y[u + i * DIM] = slope * p->x0[i][DIM - 1];
        tank_rates(&t, 0, t.y, t.ydot);
        for (int i = 0; i < particles_count(p, KIND_FLUID); i++)
            if (p->x0[i][DIM - 1] < 0.025) /* rows that meet the floor */
                force += p->m[i] * t.ydot[u + i * DIM];
        const double exact = MU * slope * ACROSS;
        const double drag = moment_force(t.moment, p->object_of[p->from[KIND_WALL]])[0];
        print_message("# stick = %s: drag %.4f of mu G\n", k ? "particles" : "face", drag / exact);
        check(k ? drag < 0.6 * exact : fabs(drag / exact - 1) < 0.05, "drag %g N, expected %g N",
              drag, exact);
        check(k || fabs(force) < 0.05 * exact, "rows at the floor are off balance by %g N", force);
        tank_free(&t);
    }
}

/* Water that goes with the surface of its walls feels nothing, and a surface that slides
 * drags as a wall that moves. */
static void surface_drags_like_a_moving_wall(void **state)
{
    static const char *const keys[] = { LAMINAR(""), LAMINAR(PARTICLES) };

    (void)state;
    for (int k = 0; k < 2; k++) {
        struct tank belt, moving;
        double most = 0, off = 0;
        tank_make(&belt, CHANNEL("", "wall = { plates = { type = \"frame\"; surface = " SURFACE
                                 "; }; };"), keys[k], NULL);
        tank_make(&moving, CHANNEL("", "wall = { plates = { type = \"frame\"; velocity = " SURFACE
                                   "; }; };"), keys[k], NULL);
        tank_rates(&belt, 0, belt.y, belt.ydot);
        tank_rates(&moving, 0, belt.y, moving.ydot);
        const struct particles *p = plan_particles(belt.plan);
        const double *b = p->object[p->object_of[p->from[KIND_WALL]]].slide;
        const long u = tank_at(&belt, "velocity of fluid", NULL);
        const int n = particles_count(p, KIND_FLUID) * DIM;
        for (int i = 0; i < n; i++) {
            most = fmax(most, fabs(belt.ydot[u + i]));
            off = fmax(off, fabs(belt.ydot[u + i] - moving.ydot[u + i]));
        }
        check(most > 1e-2 && off < 1e-11 * most, "off by %g of %g m/s^2", off, most);
        for (int i = 0; i < n; i++)
            belt.y[u + i] = b[i % DIM];
        tank_rates(&belt, 0, belt.y, belt.ydot);
        for (int i = 0; i < n; i++)
            check(fabs(belt.ydot[u + i]) < 1e-11 * most, "%g m/s^2 on water that goes along",
                  belt.ydot[u + i]);
        tank_free(&belt);
        tank_free(&moving);
    }
}

/* Water that turns with its walls as one slips nowhere: forces are those with the
 * velocities of particles, which know nothing of a face. */
static void what_turns_together_does_not_slip(void **state)
{
    const double spin = 40;
    const char *const turning =
        "wall = { tank = { type = \"frame\"; spin = 2291.831180523293; }; };";
    struct tank face, bare;
    double most = 0;

    (void)state;
    tank_make(&face, tank_bare_water, TANK_ONE_KERNEL, turning, LAMINAR(""), NULL);
    tank_make(&bare, tank_bare_water, TANK_ONE_KERNEL, turning, LAMINAR(PARTICLES), NULL);
    const struct particles *p = plan_particles(face.plan);
    const long u = tank_at(&face, "velocity of fluid", NULL);
    const int n = particles_count(p, KIND_FLUID);
    tank_shake(&face, 4, 0.2, 0, 0.02);
    for (int i = 0; i < n; i++) {
        const double *x = face.y + tank_at(&face, "position of fluid", NULL) + i * DIM;
        face.y[u + i * DIM] = -spin * x[DIM - 1];
        face.y[u + i * DIM + DIM - 1] = spin * x[0];
    }
    tank_rates(&face, 0, face.y, face.ydot);
    tank_rates(&bare, 0, face.y, bare.ydot);
    for (int i = 0; i < n * DIM; i++)
        most = fmax(most, fabs(bare.ydot[u + i]));
    check(most > 1, "nothing happens");
    for (int i = 0; i < n * DIM; i++)
        check(fabs(face.ydot[u + i] - bare.ydot[u + i]) < 1e-10 * most, "particle %d: %g, not %g",
              i / DIM, face.ydot[u + i], bare.ydot[u + i]);
    tank_free(&face);
    tank_free(&bare);
}

/* --- refusals ---------------------------------------------------------------------- */

static void what_cannot_drag_is_refused(void **state)
{
    static const struct {
        const char *wall, *effects, *says;
    } cases[] = {
        { "surface = " SURFACE "; slip = true;", LAMINAR(""), "slip = true" },
        { "surface = " SURFACE ";",
          "effects = { continuity = { }; artificial-viscosity = { alpha = 0.1; }; };", "has none" },
        { "", TANK_SEED_KERNELS "effects = { continuity = { }; laminar-viscosity = { };"
              " laplacian-viscosity = { stick = \"face\"; }; };", "both act at the faces" },
    };

    (void)state;
    for (int i = 0; i < 3; i++) {
        struct tank t;
        char text[2048];
        snprintf(text, sizeof text, "%s wall = { tank = { type = \"frame\"; %s }; }; %s",
                 tank_bare_water, cases[i].wall, cases[i].effects);
        check(tank_try(&t, text) == STATUS_BAD_SCENE, "case %d is taken", i);
        check(strstr(status_message(), cases[i].says) != NULL, "case %d says: %s", i,
              status_message());
        tank_free(&t);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(forces_follow_the_formula),
        cmocka_unit_test(books_close_and_viscosity_only_takes),
#if DIM == 2
        cmocka_unit_test(books_close_beside_a_beam),
#endif
        cmocka_unit_test(shear_finds_the_face),
        cmocka_unit_test(surface_drags_like_a_moving_wall),
        cmocka_unit_test(what_turns_together_does_not_slip),
        cmocka_unit_test(what_cannot_drag_is_refused),
    };

    return cmocka_run_group_tests_name(DIM == 2 ? "faces in 2D" : "faces in 3D", tests, NULL, NULL);
}
