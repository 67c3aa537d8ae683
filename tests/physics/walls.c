/* walls.c -- walls that carry the pressure of the water over, (W1), against a double
 * loop with kernel and equation of state typed anew. */
#include "tank.h"

#include <math.h>
#include <string.h>

#if DIM == 2
#define VELOCITY "[0.3, -0.2]"
#define AMPLITUDE "[0.004, 0.01]"
#else
#define VELOCITY "[0.3, -0.2, 0.1]"
#define AMPLITUDE "[0.004, 0.01, -0.006]"
#endif
#define FRAME(keys) "wall = { tank = { type = \"frame\"; " keys " }; };"
#define MOVING FRAME("velocity = " VELOCITY "; amplitude = " AMPLITUDE "; frequency = 7.0;")
#define MOVING_SLIP FRAME("slip = true; amplitude = " AMPLITUDE "; frequency = 7.0;")
#define ADAMI "walls = \"adami\";"
#define EVOLVED ADAMI "effects = { continuity = { }; pressure = { }; };"
#define SUMMED ADAMI "effects = { summation = { }; pressure = { }; };"

static const double amplitude[3] = { 0.004, 0.01, -0.006 }, frequency = 7;
static const double when = 0.0371; /* [s] */

/* (K4) */
static double wendland_c2(double r, double H)
{
    const double q = r / H, sigma = DIM == 2 ? 7 / M_PI : 21 / (2 * M_PI);

    return q < 1 ? sigma * pow(H, -DIM) * pow(1 - q, 4) * (1 + 4 * q) : 0;
}

/* (E2) turned around. */
static double density_of(const struct scales *s, double p)
{
    return s->rho0 * pow(1 + s->gamma * p / (s->rho0 * s->c0 * s->c0), 1 / s->gamma);
}

/* Acceleration along d of x = x0 + v t + A sin(2 pi f t) [m/s^2]. */
static double acceleration(int d, double t)
{
    return -amplitude[d] * pow(2 * M_PI * frequency, 2) * sin(2 * M_PI * frequency * t);
}

/* (W1) at point i of kind k; false when no water is near. */
static bool extrapolated(struct tank *t, const struct view *v, int k, int i, bool shakes, double *p)
{
    const struct scales *s = v->p->scales;
    const double *xw = v->x[k] + (long)i * DIM;
    double sum = 0, weight = 0;

    for (int f = 0; f < particles_count(v->p, KIND_FLUID); f++) {
        const double *xf = v->x[KIND_FLUID] + (long)f * DIM, rho = v->rho[KIND_FLUID][f];
        double r2 = 0, across = 0, pf;
        for (int d = 0; d < DIM; d++) {
            r2 += pow(xw[d] - xf[d], 2);
            across += (s->g[d] - (shakes ? acceleration(d, when) : 0)) * (xw[d] - xf[d]);
        }
        plan_pressures(t->plan, 1, &rho, &pf);
        sum += (pf + rho * across) * wendland_c2(sqrt(r2), s->support);
        weight += wendland_c2(sqrt(r2), s->support);
    }
    *p = sum / weight;
    return weight > 0;
}

static void check_solids(struct tank *t, bool shakes)
{
    int near = 0, dry = 0;
    struct view v;

    observe_view(t->moment, when, t->y, &v);
    for (int k = KIND_WALL; k < KINDS; k++)
        for (int i = 0; i < particles_count(v.p, k); i++) {
            const bool skin = k == KIND_SKIN || k == KIND_SKIN_SLIP;
            double p, expected = v.p->scales->rho0;
            if (extrapolated(t, &v, k, i, shakes && !skin, &p)) {
                expected = density_of(v.p->scales, p);
                near++;
            } else {
                check(v.rho[k][i] == expected, "dry point %d of kind %d: %.17g", i, k, v.rho[k][i]);
                dry++;
            }
            check(fabs(v.rho[k][i] - expected) <= 1e-13 * expected,
                  "point %d of kind %d: %.17g kg/m^3 instead of %.17g", i, k, v.rho[k][i],
                  expected);
        }
    check(near > 50 && dry > 20, "%d points near the water, %d not", near, dry);
}

static void solids_have_the_pressure_of_the_water(void **state)
{
    const char *const walls[] = { tank_frame, MOVING, MOVING_SLIP };
    static const char *const effects[] = { EVOLVED, SUMMED };

    (void)state;
    for (int w = 0; w < 3; w++)
        for (int e = 0; e < 2; e++)
            for (int beam = 0; beam < (DIM == 2 ? 2 : 1); beam++) {
                struct tank t;
                tank_make(&t, beam ? tank_parted_water : tank_bare_water, walls[w],
                          beam ? tank_beam : "", TANK_ONE_KERNEL, effects[e], NULL);
                tank_shake(&t, 3, 0.2, 0.5, 0.01);
                tank_rates(&t, when, t.y, t.ydot);
                check_solids(&t, w > 0);
                tank_free(&t);
            }
}

/* Water so stiff that it has one density, its pressure linear: so has the wall, also
 * one that is accelerated together with the water. */
static void linear_pressure_goes_on_in_the_wall(void **state)
{
    const char *const walls[] = { tank_frame, MOVING };

    (void)state;
    for (int w = 0; w < 2; w++) {
        const struct scales *s;
        double slope[DIM], most = 0, off = 0;
        struct tank t;
        struct view v;
        tank_make(&t, tank_bare_water, walls[w], TANK_ONE_KERNEL, EVOLVED,
                  "eos = { c0 = 1000.0; };", NULL);
        s = plan_scales(t.plan);
        for (int d = 0; d < DIM; d++)
            slope[d] = s->rho0 * (s->g[d] - (w ? acceleration(d, when) : 0));
        observe_view(t.moment, when, t.y, &v);
        for (int i = 0; i < particles_count(v.p, KIND_FLUID); i++) {
            double p = 2000;
            for (int d = 0; d < DIM; d++)
                p += slope[d] * v.x[KIND_FLUID][i * DIM + d];
            t.y[tank_at(&t, "density of fluid", NULL) + i] = density_of(s, p);
        }
        observe_view(t.moment, when, t.y, &v);
        for (int i = 0; i < particles_count(v.p, KIND_WALL); i++) {
            double expected = 2000, found, p;
            for (int d = 0; d < DIM; d++)
                expected += slope[d] * v.x[KIND_WALL][i * DIM + d];
            plan_pressures(t.plan, 1, &v.rho[KIND_WALL][i], &found);
            if (!extrapolated(&t, &v, KIND_WALL, i, w, &p))
                continue;
            most = fmax(most, fabs(expected));
            off = fmax(off, fabs(found - expected));
        }
        check(off <= 2e-6 * most && most > 2000, "pressure of the wall is off by %g of %g Pa", off,
              most);
        tank_free(&t);
    }
}

/* Water that is torn pulls walls only where there is tension. */
static void clamped_walls_do_not_pull(void **state)
{
    static const char *const eos[] = { "", "eos = { tension = false; };" };

    (void)state;
    for (int i = 0; i < 2; i++) {
        double least = HUGE_VAL;
        struct tank t;
        struct view v;
        long rho;
        tank_make(&t, tank_bare_water, tank_frame, TANK_ONE_KERNEL, EVOLVED, eos[i], NULL);
        rho = tank_at(&t, "density of fluid", NULL);
        for (int k = 0; k < particles_count(plan_particles(t.plan), KIND_FLUID); k++)
            t.y[rho + k] = 900;
        observe_view(t.moment, 0, t.y, &v);
        for (int k = 0; k < particles_count(v.p, KIND_WALL); k++)
            least = fmin(least, v.rho[KIND_WALL][k]);
        check(i ? least == 1000 : least < 950, "tension %s: least density of a wall %g",
              i ? "off" : "on", least);
        tank_free(&t);
    }
}

/* Neither in the state nor in the book is there anything of such a wall's density. */
static void solids_have_no_rows(void **state)
{
    const struct layout *l;
    struct tank t;

    (void)state;
    tank_make(&t, DIM == 2 ? tank_parted_water : tank_bare_water, tank_frame, TANK_ONE_KERNEL,
              DIM == 2 ? tank_beam : "", EVOLVED, NULL);
    l = plan_layout(t.plan);
    for (int i = 0; i < l->rows; i++)
        check(strncmp(l->row[i].name, "density of", 10) != 0
              || strcmp(l->row[i].name, "density of fluid") == 0, "there is a row \"%s\"",
              l->row[i].name);
    tank_free(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(solids_have_the_pressure_of_the_water),
        cmocka_unit_test(linear_pressure_goes_on_in_the_wall),
        cmocka_unit_test(clamped_walls_do_not_pull),
        cmocka_unit_test(solids_have_no_rows),
    };

    return cmocka_run_group_tests_name(DIM == 2 ? "walls in 2D" : "walls in 3D", tests, NULL, NULL);
}
