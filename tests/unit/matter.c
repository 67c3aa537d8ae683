/* matter.c -- tests of src/matter: the equation of state and what follows from it. */
#include "matter/eos.h"

#include <gsl/gsl_integration.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

static const double gammas[] = { 1, 1.4, 7, 7.15 };
enum { GAMMAS = sizeof gammas / sizeof *gammas };

static struct eos water(double gamma)
{
    return (struct eos){ .rho0 = 1000, .c0 = 20, .gamma = gamma };
}

/* Fails unless a and b agree to a relative tolerance; sees NaN. */
static void assert_close(double a, double b, double tolerance)
{
    if (!(fabs(a - b) <= tolerance * fabs(b)))
        fail_msg("%.17g differs from %.17g by more than %g of it", a, b, tolerance);
}

static void pressure_is_tait(void **state)
{
    (void)state;
    for (int k = 0; k < GAMMAS; k++)
        for (double s = 0.5; s < 1.6; s += 0.0625) {
            const struct eos e = water(gammas[k]);
            const double b = 1000.0 * 20 * 20 / gammas[k];

            if (s != 1)
                assert_close(eos_pressure(&e, 1000 * s), b * (pow(s, gammas[k]) - 1), 1e-13);
        }
}

static void pressure_is_zero_at_rest(void **state)
{
    (void)state;
    for (int k = 0; k < GAMMAS; k++) {
        const struct eos e = water(gammas[k]);

        assert_true(eos_pressure(&e, e.rho0) == 0);
        assert_true(eos_energy(&e, e.rho0) == 0);
        assert_true(eos_density(&e, 0) == e.rho0);
        assert_close(eos_sound(&e, e.rho0), e.c0, 1e-15);
    }
}

/* p = c0^2 rho0 d (1 + (gamma-1)/2 d + (gamma-1)(gamma-2)/6 d^2 + ...) */
static void pressure_keeps_its_digits_near_rest(void **state)
{
    (void)state;
    for (int k = 0; k < GAMMAS; k++)
        for (double d = 1e-12; d < 1e-5; d *= 100) {
            const struct eos e = water(gammas[k]);
            const double g = gammas[k], rho = e.rho0 * (1 + d), x = (rho - e.rho0) / e.rho0;

            assert_close(eos_pressure(&e, rho),
                         4e5 * x * (1 + (g - 1) / 2 * x * (1 + (g - 2) / 3 * x)), 1e-13);
        }
}

static void density_inverts_pressure(void **state)
{
    (void)state;
    for (int k = 0; k < GAMMAS; k++)
        for (double s = 0.7; s < 1.5; s += 0.01) {
            const struct eos e = water(gammas[k]);

            assert_close(eos_density(&e, eos_pressure(&e, 1000 * s)), 1000 * s, 1e-14);
        }
}

static void density_below_the_least_pressure_is_nan(void **state)
{
    (void)state;
    const struct eos e = water(7);

    assert_true(isnan(eos_density(&e, -1.01 * 4e5 / 7)));
    assert_true(isnan(eos_pressure(&e, NAN)));
    assert_true(isnan(eos_energy(&e, NAN)));
}

static double modulus(const struct eos *e, double rho)
{
    const double p = eos_pressure(e, rho);
    double to;

    eos_moduli(e, 1, &p, &to);
    return to;
}

static void sound_is_the_slope_of_pressure(void **state)
{
    (void)state;
    for (int k = 0; k < GAMMAS; k++)
        for (double rho = 800; rho < 1300; rho += 90) {
            const struct eos e = water(gammas[k]);
            const double h = 1e-2, c = eos_sound(&e, rho);
            const double slope = (eos_pressure(&e, rho + h) - eos_pressure(&e, rho - h)) / (2 * h);

            assert_close(c * c, slope, 1e-8);
            assert_close(modulus(&e, rho), rho * slope, 1e-8);
        }
}

static double integrand(double rho, void *e)
{
    return eos_pressure(e, rho) / (rho * rho);
}

static double energy_by_quadrature(struct eos *e, double rho)
{
    gsl_integration_workspace *space = gsl_integration_workspace_alloc(100);
    gsl_function f = { .function = integrand, .params = e };
    double result, error;

    gsl_integration_qag(&f, e->rho0, rho, 0, 1e-13, 100, GSL_INTEG_GAUSS61, space, &result, &error);
    gsl_integration_workspace_free(space);
    return result;
}

static const double strains[] = { -0.6, -0.1, -1e-3, -1e-6, 1e-6, 1e-4, 0.02, 0.5, 2 };
enum { STRAINS = sizeof strains / sizeof *strains };

/* Near rho0 the quadrature itself is limited by the rounding of its abscissae. */
static void energy_is_the_integral_of_pressure(void **state)
{
    (void)state;
    for (int k = 0; k < GAMMAS; k++)
        for (int i = 0; i < STRAINS; i++) {
            struct eos e = water(gammas[k]);
            const double rho = e.rho0 * (1 + strains[i]);

            assert_close(eos_energy(&e, rho), energy_by_quadrature(&e, rho),
                         fabs(strains[i]) < 1e-3 ? 2e-9 : 1e-11);
        }
}

/* The closed form, its cancellation drowned in the longer numbers. */
static double energy_in_long_numbers(const struct eos *e, double rho)
{
    const long double d = (long double)(rho - e->rho0) / e->rho0, log_s = log1pl(d);
    const long double a = e->gamma - 1;
    const long double power = a > 0 ? expm1l(a * log_s) / a : log_s;

    return (double)(e->c0 * e->c0 / e->gamma * (power - d / (1 + d)));
}

static void energy_keeps_its_digits_near_rest(void **state)
{
    (void)state;
    for (int k = 0; k < GAMMAS; k++)
        for (int i = 0; i < STRAINS; i++) {
            const struct eos e = water(gammas[k]);
            const double rho = e.rho0 * (1 + strains[i]);

            assert_close(eos_energy(&e, rho), energy_in_long_numbers(&e, rho), 1e-12);
        }
}

static void energy_starts_as_half_c0_d_squared(void **state)
{
    (void)state;
    for (int k = 0; k < GAMMAS; k++) {
        const struct eos e = water(gammas[k]);
        const double rho = e.rho0 * (1 + 1e-8), d = (rho - e.rho0) / e.rho0;

        assert_close(eos_energy(&e, rho), 0.5 * 20 * 20 * d * d, 1e-7);
    }
}

/* (E1) p = k (rho - rho0), and what it stores: k (ln s + 1/s - 1), s = rho/rho0. */
static void exponent_one_is_the_linear_equation(void **state)
{
    const struct eos e = water(1);

    (void)state;
    for (double rho = 600; rho < 1700; rho += 37) {
        const double s = rho / 1000;

        assert_close(eos_pressure(&e, rho), 400 * (rho - 1000), 1e-14);
        assert_close(eos_density(&e, 400 * (rho - 1000)), rho, 1e-14);
        assert_close(eos_energy(&e, rho), 400 * (log(s) + 1 / s - 1), 2e-11);
        assert_close(eos_sound(&e, rho), 20, 1e-15);
    }
}

/* Without tension nothing below rho0 has a pressure or an energy; above nothing changes. */
static void clamped_knows_no_tension(void **state)
{
    (void)state;
    for (int k = 0; k < GAMMAS; k++) {
        const struct eos free = water(gammas[k]);
        struct eos e = water(gammas[k]);

        e.clamped = true;
        for (double rho = 300; rho < 1000; rho += 33) {
            assert_true(eos_pressure(&e, rho) == 0);
            assert_true(eos_energy(&e, rho) == 0);
            assert_true(modulus(&e, rho) == 0);
            assert_true(eos_density(&e, eos_pressure(&free, rho)) == 1000);
        }
        for (double rho = 1000; rho < 1500; rho += 33) {
            assert_true(eos_pressure(&e, rho) == eos_pressure(&free, rho));
            assert_true(eos_energy(&e, rho) == eos_energy(&free, rho));
            if (rho > 1000) /* at it, p bends */
                assert_true(modulus(&e, rho) == modulus(&free, rho));
            assert_close(eos_density(&e, eos_pressure(&e, rho)), rho, 1e-14);
        }
    }
    const struct eos e = { .rho0 = 1000, .c0 = 20, .gamma = 7, .clamped = true };
    assert_true(isnan(eos_pressure(&e, NAN)));
    assert_true(isnan(eos_energy(&e, NAN)));
    assert_true(isnan(eos_density(&e, NAN)));
}

/* de/drho = p/rho^2 on both sides of rho0 and at it, where p only bends. */
static void clamped_energy_has_no_corner(void **state)
{
    (void)state;
    for (int k = 0; k < GAMMAS; k++) {
        struct eos e = water(gammas[k]);

        e.clamped = true;
        for (double h = 1; h > 1e-4; h /= 10) {
            const double across = (eos_energy(&e, 1000 + h) - eos_energy(&e, 1000 - h)) / (2 * h);
            const double above = (eos_energy(&e, 1050 + h) - eos_energy(&e, 1050 - h)) / (2 * h);

            assert_true(across > 0 && across < 2e-4 * h); /* c0^2 h/(4 rho0^2) */
            assert_close(above, eos_pressure(&e, 1050) / (1050.0 * 1050.0), 1e-4 * h * h + 1e-8);
        }
    }
}

static void batches_have_the_bits_of_single_calls(void **state)
{
    double rho[67], p[67], moduli[67], sound[67];

    (void)state;
    for (int k = 0; k < 2 * GAMMAS; k++) {
        struct eos e = water(gammas[k / 2]);

        e.clamped = k % 2;
        for (int i = 0; i < 67; i++)
            rho[i] = 900 + 3.1 * i;
        eos_pressures(&e, 67, rho, p);
        for (int i = 0; i < 67; i++)
            assert_true(p[i] == eos_pressure(&e, rho[i]));
        eos_moduli(&e, 67, p, moduli);
        for (int i = 0; i < 67; i++)
            assert_true(moduli[i] == modulus(&e, rho[i]));
        eos_sounds(&e, 67, rho, sound);
        for (int i = 0; i < 67; i++)
            assert_true(sound[i] == eos_sound(&e, rho[i]));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pressure_is_tait),
        cmocka_unit_test(pressure_is_zero_at_rest),
        cmocka_unit_test(pressure_keeps_its_digits_near_rest),
        cmocka_unit_test(density_inverts_pressure),
        cmocka_unit_test(density_below_the_least_pressure_is_nan),
        cmocka_unit_test(sound_is_the_slope_of_pressure),
        cmocka_unit_test(energy_is_the_integral_of_pressure),
        cmocka_unit_test(energy_keeps_its_digits_near_rest),
        cmocka_unit_test(energy_starts_as_half_c0_d_squared),
        cmocka_unit_test(exponent_one_is_the_linear_equation),
        cmocka_unit_test(clamped_knows_no_tension),
        cmocka_unit_test(clamped_energy_has_no_corner),
        cmocka_unit_test(batches_have_the_bits_of_single_calls),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
