/* summation.c -- a density that is a sum over all particles around, and its rate: against
 * double loops over all pairs with the kernels typed anew. */
#include "tank.h"

#include "eval/inside.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#if DIM == 2
#define VECTOR "[0.011, -0.007]"
#else
#define VECTOR "[0.011, -0.007, 0.004]"
#endif
#define MOVING "wall = { tank = { type = \"frame\"; velocity = " VECTOR "; frequency = 3.0;" \
               " amplitude = " VECTOR "; }; };"
#define CLAMPED "eos = { tension = false; };"

static const double when = 0.013; /* [s] */

/* (K4) and (K7), W(r) at H. */
static double wendland_c2(double r, double H)
{
    const double q = r / H, sigma = DIM == 2 ? 7 / M_PI : 21 / (2 * M_PI);

    return q < 1 ? sigma * pow(H, -DIM) * pow(1 - q, 4) * (1 + 4 * q) : 0;
}

static double poly6(double r, double H)
{
    const double s = DIM == 2 ? 4 * H : 315.0 / 64;

    return r < H ? s / (M_PI * pow(H, 9)) * pow(H * H - r * r, 3) : 0;
}

/* W'(r)/r of (K4), (K7) and (K8), differentiated by hand. */
static double wendland_c2_slope(double r, double H)
{
    const double q = r / H, sigma = DIM == 2 ? 7 / M_PI : 21 / (2 * M_PI);

    return q < 1 ? -20 * sigma * pow(H, -DIM - 2) * pow(1 - q, 3) : 0;
}

static double poly6_slope(double r, double H)
{
    const double s = DIM == 2 ? 4 * H : 315.0 / 64;

    return r < H ? -6 * s / (M_PI * pow(H, 9)) * pow(H * H - r * r, 2) : 0;
}

static double spiky_slope(double r, double H)
{
    const double s = DIM == 2 ? 10 * H : 15;

    return r < H ? -3 * s / (M_PI * pow(H, 6)) * pow(H - r, 2) / r : 0;
}

typedef double shape(double r, double H);

static const double *place(const struct view *v, int c, int *kind)
{
    for (*kind = 0; c >= v->p->from[*kind + 1];)
        ++*kind;
    return v->x[*kind] + (long)(c - v->p->from[*kind]) * DIM;
}

/* Of all particles, by creation number. */
struct all {
    int n, *kind;
    double (*x)[DIM], (*u)[DIM], *p2; /* p/rho^2 */
};

static struct all look(struct tank *t, const struct view *v)
{
    const int n = v->p->n;
    struct all e = { n, test_malloc(n * sizeof *e.kind), test_malloc(n * sizeof *e.x),
                           test_malloc(n * sizeof *e.u), test_malloc(n * sizeof *e.p2) };

    for (int k = 0; k < KINDS; k++)
        for (int i = 0; i < particles_count(v->p, k); i++) {
            const int c = v->p->from[k] + i;
            e.kind[c] = k;
            memcpy(e.x[c], v->x[k] + (long)i * DIM, sizeof *e.x);
            memcpy(e.u[c], v->u[k] + (long)i * DIM, sizeof *e.u);
            plan_pressures(t->plan, 1, &v->rho[k][i], &e.p2[c]);
            e.p2[c] /= v->rho[k][i] * v->rho[k][i];
        }
    return e;
}

static void forget(struct all *e)
{
    test_free(e->kind);
    test_free(e->x);
    test_free(e->u);
    test_free(e->p2);
}

/* (D3) sum_b m_b W_ab over all, a itself included. */
static double sum_over_all(const struct view *v, int a, shape *w)
{
    const double H = v->p->scales->support;
    double sum = 0;
    int kind;

    for (int b = 0; b < v->p->n; b++) {
        const double *xa = place(v, a, &kind), *xb = place(v, b, &kind);
        double r2 = 0;
        for (int d = 0; d < DIM; d++)
            r2 += (xa[d] - xb[d]) * (xa[d] - xb[d]);
        sum += v->p->m[b] * w(sqrt(r2), H);
    }
    return sum;
}

static void check_sums(struct tank *t, bool solids, shape *w)
{
    struct view v;
    int kind;

    observe_view(t->moment, when, t->y, &v);
    for (int c = 0; c < (solids ? v.p->n : v.p->from[KIND_WALL]); c++) {
        const double expected = sum_over_all(&v, c, w);
        place(&v, c, &kind);
        const double found = v.rho[kind][c - v.p->from[kind]];
        check(fabs(found - expected) <= 1e-13 * expected,
              "particle %d of kind %d: %.17g kg/m^3 instead of %.17g", c, kind, found, expected);
    }
}

/* Also after rebuilds of the list, and when nothing was rebuilt. */
static void density_is_the_sum_over_all(void **state)
{
    static const struct {
        const char *kernels, *effects;
        bool solids;
        shape *w;
    } cases[] = {
        { TANK_ONE_KERNEL, TANK_SUMMED, true, wendland_c2 },
        { TANK_SEED_KERNELS, TANK_SUMMED CLAMPED, true, poly6 },
        { TANK_ONE_KERNEL, "walls = \"ghost\"; effects = { summation = { }; };", true,
          wendland_c2 },
        { TANK_ONE_KERNEL, "walls = \"adami\"; effects = { summation = { }; pressure = { }; };",
          false, wendland_c2 },
    };

    (void)state;
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++)
        for (int beam = 0; beam < (DIM == 2 ? 2 : 1); beam++) {
            struct tank t;
            tank_make(&t, beam ? tank_parted_water : tank_bare_water, MOVING,
                      beam ? tank_beam : "", cases[i].kernels, cases[i].effects, NULL);
            for (unsigned seed = 1; seed <= 3; seed++) {
                tank_shake(&t, seed, seed == 2 ? 0.003 : 0.2, 1, 0);
                tank_rates(&t, when, t.y, t.ydot);
                check_sums(&t, cases[i].solids, cases[i].w);
            }
            tank_free(&t);
        }
}

/* A summed density needs no row of the state: only water's x and u and the book. */
static void state_has_no_density(void **state)
{
    const struct layout_row *r;
    struct tank t;

    (void)state;
    tank_make(&t, tank_bare_water, tank_frame, TANK_ONE_KERNEL, TANK_SUMMED, NULL);
    tank_at(&t, "book", &r);
    assert_int_equal(t.n, 2 * DIM * particles_count(plan_particles(t.plan), KIND_FLUID) + r->n);
    assert_int_equal(r->n, 2 + 1 + 2 * DIM); /* two laws, walls, impulses of water and tank */
    tank_free(&t);
}

/* Density of all particles a little later (earlier), all moving on as they move now. */
static double *densities(struct tank *t, double h)
{
    const struct particles *p = plan_particles(t->plan);
    double *y = tank_copy(t, t->y), *rho = test_malloc(p->n * sizeof *rho);
    struct view v;

    for (long i = 0; i < t->n; i++)
        y[i] += h * t->ydot[i];
    observe_view(t->moment, when + h, y, &v);
    for (int k = 0; k < KINDS; k++)
        for (int i = 0; i < particles_count(p, k); i++)
            rho[p->from[k] + i] = v.rho[k][i];
    test_free(y);
    return rho;
}

/* What the law adds up for the book is d/dt of the sum, for water, walls and skins. */
static void rate_is_that_of_the_sum(void **state)
{
    static const char *const kernels[] = { TANK_ONE_KERNEL, TANK_SEED_KERNELS };
    const double h = 1e-6;

    (void)state;
    for (int i = 0; i < 2; i++)
        for (int beam = 0; beam < (DIM == 2 ? 2 : 1); beam++) {
            double *at[4], most = 0;
            struct tank t;
            tank_make(&t, beam ? tank_parted_water : tank_bare_water, MOVING,
                      beam ? tank_beam : "", kernels[i], TANK_SUMMED, NULL);
            tank_shake(&t, 4, 0.2, 1, 0);
            tank_rates(&t, when, t.y, t.ydot);
            const struct workspace *w = t.moment->work;
            const int n = plan_particles(t.plan)->n;
            double *rate = test_malloc(n * sizeof *rate);
            for (int c = 0; c < n; c++) {
                rate[c] = w->drho[t.moment->list->slot[c]];
                most = fmax(most, fabs(rate[c]));
            }
            for (int k = 0; k < 4; k++)
                at[k] = densities(&t, h * (k < 2 ? k - 2 : k - 1));
            for (int c = 0; c < n; c++) {
                const double slope = (8 * (at[2][c] - at[1][c]) - (at[3][c] - at[0][c])) / (12 * h);
                check(fabs(slope - rate[c]) <= 1e-7 * most,
                      "particle %d: the sum grows by %g kg/m^3/s, the law says %g", c, slope,
                      rate[c]);
            }
            check(most > 1e4, "nothing happens: %g kg/m^3/s", most);
            for (int k = 0; k < 4; k++)
                test_free(at[k]);
            test_free(rate);
            tank_free(&t);
        }
}

struct powers {
    double force;   /* v . F of (P1)                                [W, 2D: W/m] */
    double density; /* m p/rho^2 rho' of (D1)                                    */
    double solids;  /* of that, of solids that meet solids                       */
    double size;    /* of all of them without their signs                        */
};

/* Sums over all pairs: pressure acts where there is water, density is summed over all. */
static struct powers powers_of(const struct all *e, const struct particles *p,
                               shape *pressure, shape *density)
{
    struct powers s = { 0 };

    for (int a = 0; a < e->n; a++)
        for (int b = 0; b < e->n; b++) {
            const double mm = p->m[a] * p->m[b];
            double r2 = 0, xu = 0, xv = 0;
            for (int d = 0; d < DIM; d++) {
                const double x = e->x[a][d] - e->x[b][d];
                r2 += x * x;
                xu += x * e->u[a][d];
                xv += x * (e->u[a][d] - e->u[b][d]);
            }
            if (a == b || r2 >= pow(p->scales->support, 2))
                continue;
            const bool water = e->kind[a] == KIND_FLUID || e->kind[b] == KIND_FLUID;
            const double r = sqrt(r2), H = p->scales->support;
            const double force = water ? -mm * (e->p2[a] + e->p2[b]) * pressure(r, H) * xu : 0;
            const double rate = mm * e->p2[a] * density(r, H) * xv;
            s.force += force;
            s.density += rate;
            s.solids += water ? 0 : rate;
            s.size += fabs(force) + fabs(rate);
        }
    return s;
}

/* Rate of the pressure_defect in the book [W]. */
static double booked_defect(struct tank *t)
{
    double *y = tank_copy(t, t->y);
    struct book_sheet s;
    const double h = 1e-6;

    for (long i = 0; i < t->n; i++)
        y[i] += h * t->ydot[i];
    observe_sheet(t->moment, when + h, y, &s);
    test_free(y);
    return s.pressure_defect / h;
}

/* With one kernel for all the force takes what the density gives, but for solids that
 * move against each other, as a beam does: no pressure acts between them.  With two
 * kernels the defect is the difference of both sums, and all of it is booked. */
static void defect_is_the_difference_of_both_sums(void **state)
{
    static const struct {
        const char *keys;
        bool same;
        shape *pressure, *density;
    } cases[] = {
        { TANK_ONE_KERNEL, true, wendland_c2_slope, wendland_c2_slope },
        { TANK_ONE_KERNEL CLAMPED, true, wendland_c2_slope, wendland_c2_slope },
        { TANK_SEED_KERNELS, false, spiky_slope, poly6_slope },
        { TANK_SEED_KERNELS CLAMPED, false, spiky_slope, poly6_slope },
    };

    (void)state;
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++)
        for (int beam = 0; beam < (DIM == 2 ? 2 : 1); beam++) {
            struct all e;
            struct powers s;
            struct tank t;
            struct view v;
            tank_make(&t, beam ? tank_parted_water : tank_bare_water, MOVING,
                      beam ? tank_beam : "", cases[i].keys, TANK_SUMMED, NULL);
            tank_shake(&t, 6, 0.2, 1, 0);
            tank_rates(&t, when, t.y, t.ydot);
            observe_view(t.moment, when, t.y, &v);
            e = look(&t, &v);
            s = powers_of(&e, v.p, cases[i].pressure, cases[i].density);
            check(fabs(booked_defect(&t) - s.force - s.density) <= 1e-12 * s.size,
                  "%s: the book has %g W, not %g - %g of %g W", cases[i].keys, booked_defect(&t),
                  s.force, -s.density, s.size);
            check(!cases[i].same == (fabs(s.force + s.density - s.solids) > 1e-12 * s.size),
                  "%s: force %g W, density %g W, solids %g W", cases[i].keys, s.force, s.density,
                  s.solids);
            check(!beam == (fabs(s.solids) <= 1e-12 * s.size), "%g W between solids of %g W",
                  s.solids, s.size);
            forget(&e);
            tank_free(&t);
        }
}

/* A particle outside the domain has no neighbours and the density at rest. */
static void outside_is_the_density_at_rest(void **state)
{
    struct tank t;
    struct view v;

    (void)state;
    tank_make(&t, tank_bare_water, tank_frame, TANK_ONE_KERNEL, TANK_SUMMED, NULL);
    tank_rates(&t, 0, t.y, t.ydot);
    t.y[7 * DIM] = 10;
    for (int again = 0; again < 2; again++) {
        tank_rates(&t, 0, t.y, t.ydot);
        observe_view(t.moment, 0, t.y, &v);
        check(v.rho[KIND_FLUID][7] == 1000, "%.17g kg/m^3", v.rho[KIND_FLUID][7]);
        check(v.rho[KIND_FLUID][8] != 1000, "a particle inside has the density at rest");
    }
    tank_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(density_is_the_sum_over_all),
        cmocka_unit_test(state_has_no_density),
        cmocka_unit_test(rate_is_that_of_the_sum),
        cmocka_unit_test(defect_is_the_difference_of_both_sums),
        cmocka_unit_test(outside_is_the_density_at_rest),
    };

    return cmocka_run_group_tests_name("summation", tests, NULL, NULL);
}
