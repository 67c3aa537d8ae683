/* time-tables.c -- tables keep their order conditions; stability factors are those
 * that were published. */
#include "time-tests.h"

#include "time/mri.h"
#include "time/stability.h"

#include <complex.h>

/* The largest violation of sum_i w_i phi_i = 1/gamma over all rooted trees with
 * up to `order` nodes: Butcher, Numerical Methods for ODEs, table 301(II). */
static double violation(const struct tableau *t, const double *w, int order)
{
    const int s = t->stages;
    double c[TABLEAU_STAGES], ac[TABLEAU_STAGES], ac2[TABLEAU_STAGES], aac[TABLEAU_STAGES];
    double sum[8] = { 0 }, most = 0;
    static const double want[8] = { 1, 1. / 2, 1. / 3, 1. / 6, 1. / 4, 1. / 8, 1. / 12, 1. / 24 };
    static const int up_to[5] = { 0, 1, 2, 4, 8 };

    for (int i = 0; i < s; i++)
        c[i] = tableau_node(t, i);
    for (int i = 0; i < s; i++) {
        ac[i] = ac2[i] = 0;
        for (int j = 0; j <= i; j++) {
            ac[i] += t->a[i][j] * c[j];
            ac2[i] += t->a[i][j] * c[j] * c[j];
        }
    }
    for (int i = 0; i < s; i++) {
        aac[i] = 0;
        for (int j = 0; j <= i; j++)
            aac[i] += t->a[i][j] * ac[j];
    }
    for (int i = 0; i < s; i++) {
        const double phi[8] = { 1, c[i], c[i] * c[i], ac[i], c[i] * c[i] * c[i], c[i] * ac[i],
                                ac2[i], aac[i] };
        for (int k = 0; k < 8; k++)
            sum[k] += w[i] * phi[k];
    }
    for (int k = 0; k < up_to[order < 4 ? order : 4]; k++)
        most = fmax(most, fabs(sum[k] - want[k]));
    return most;
}

void tables_keep_their_order_conditions(void **state)
{
    (void)state;
    for (int i = 0; tableau_own[i]; i++) {
        const struct tableau *t = tableau_own[i];
        if (violation(t, t->b, t->order) > 2e-14 || violation(t, t->d, t->embedded) > 2e-14)
            fail_msg("%s: %g %g", t->name, violation(t, t->b, t->order),
                     violation(t, t->d, t->embedded));
        /* and no order that is not claimed: else the estimate would be 0 */
        if (t->order < 5 && violation(t, t->d, t->embedded + 1) < 1e-6)
            fail_msg("%s: the embedded method is better than claimed", t->name);
    }
    assert_true(tableau_first_same_as_last(&tableau_bs54));
    assert_false(tableau_first_same_as_last(&tableau_opt53));
}

/* INTEGRATORS measured these from the same tables with other code. */
void stability_factors_are_those_published(void **state)
{
    static const struct {
        const struct tableau *t;
        double imaginary, decay, damped;
    } row[] = { { &tableau_cks43, 2.83, 2.79, 2.48 * 1.18 },
                { &tableau_opt53, 2.19, 3.07, 3.47 * 1.18 },
                { &tableau_opt64, 3.70, 3.25, 4.27 * 1.18 },
                { &tableau_bs54, 1.92, 3.99, 2.75 * 1.18 } };

    (void)state;
    for (int i = 0; i < 4; i++) {
        near(stability_wave(row[i].t, 0), row[i].imaginary, 0.006);
        near(stability_decay(row[i].t), row[i].decay, 0.006);
        near(stability_wave(row[i].t, STABILITY_DAMPING), row[i].damped, 0.05);
    }
    near(stability_growth(&tableau_cks43, 0, 1), hypot(1 - 0.5 + 1. / 24, 1 - 1. / 6), 1e-12);
}

/* The same from SUNDIALS' own tables, through the methods that use them. */
void stability_factors_of_sundials_tables(void **state)
{
    static const struct {
        const char *name;
        double imaginary, decay;
    } row[] = { { "ark436", 4.00, 4.23 },
                { "imex3", 2.49, 3.66 },
                { "ARKODE_BOGACKI_SHAMPINE_4_2_3", 1.73, 2.51 },
                { "ARKODE_ARK437L2SA_ERK_7_3_4", 4.70, 6.76 },
                { "ARKODE_FEHLBERG_13_7_8", 2.65, 5.0 } };

    (void)state;
    for (int i = 0; i < 5; i++) {
        struct moment p;
        void *self;
        toy_make(&p, 0, 0);
        self = toy_method(&p, row[i].name, 1e-3, 0);
        const struct tableau *t = &((struct arkode *)self)->table;
        near(stability_wave(t, 0), row[i].imaginary, 0.006);
        near(stability_decay(t), row[i].decay, 0.05);
        toy_method_free(&self);
    }
}

/* Between the halves of a pair order 2 asks for nothing but equal nodes and weights. */
void halves_of_a_pair_go_together(void **state)
{
    const struct tableau *e = &tableau_ark2_erk, *i = &tableau_ark2_dirk;

    (void)state;
    assert_true(e->stages == i->stages && e->order == i->order && e->embedded == i->embedded);
    for (int k = 0; k < e->stages; k++) {
        near(tableau_node(e, k), tableau_node(i, k), 1e-15);
        assert_true(e->b[k] == i->b[k] && e->d[k] == i->d[k]);
    }
    assert_true(tableau_first_same_as_last(i)); /* stiffly accurate */
}

/* |R(z)| of the weights w; stages solve for themselves only. */
static double growth(const struct tableau *t, const double *w, double complex z)
{
    double complex s[TABLEAU_STAGES], sum = 1;

    for (int i = 0; i < t->stages; i++) {
        s[i] = 1;
        for (int j = 0; j < i; j++)
            s[i] += z * t->a[i][j] * s[j];
        s[i] /= 1 - z * t->a[i][i];
        sum += z * w[i] * s[i];
    }
    return cabs(sum);
}

/* On the imaginary axis nothing grows (nor anywhere left of it, as poles lie to the
 * right), and what is infinitely stiff is gone after a step.  Its error estimate stays
 * within a few times its size. */
static void check_stiff(const char *name, const struct tableau *t)
{
    for (int i = 0; i < t->stages; i++)
        assert_true(t->a[i][i] > 0 || i == 0);
    for (double y = 1e-3; y < 1e8; y *= 1.05)
        if (!(growth(t, t->b, I * y) <= 1 + 1e-9))
            fail_msg("%s: |R(%g i)| = %.12g", name, y, growth(t, t->b, I * y));
    if (!(growth(t, t->b, -1e7) < 1e-5 && growth(t, t->b, 1e7 * I) < 1e-5))
        fail_msg("%s: |R| = %g far out", name, growth(t, t->b, -1e7));
    if (!(growth(t, t->d, -1e7) < 4))
        fail_msg("%s: estimate %g", name, growth(t, t->d, -1e7));
}

/* What a table says by swinging: y' = i y, an amplitude after ten periods.  imex3 takes 0.1 %
 * in 74 steps a period; imex4 would in 6.5, and takes twelve. */
static void check_swing(const char *method, double steps, double most)
{
    struct method_def def = method_def_default();
    const struct method *m;
    struct tableau t;

    assert_int_equal(method_find(method, &def, &m), STATUS_DONE);
    ARKodeButcherTable table =
        ARKodeButcherTable_LoadDIRKByName(((const struct arkode_row *)m)->dirk);
    assert_non_null(table);
    arkode_tables_read(table, &t);
    ARKodeButcherTable_Free(table);
    const double c = stability_swing(&t, 1e-3), left = pow(growth(&t, t.b, I * c), 20 * M_PI / c);
    near(2 * M_PI / c, steps, 0.01 * steps);
    if (!(left <= 1 && 1 - left <= most && 1 - left >= most / 2))
        fail_msg("%s: ten periods leave %.6g", method, left);
}

void steps_that_follow_a_vibration(void **state)
{
    (void)state;
    check_swing("imex3", 74, 1e-3);
    check_swing("imex4", 12, 8e-5);
    check_swing("imex5", 12, 3e-4);
}

void implicit_tables_are_l_stable(void **state)
{
    static const char *const methods[] = { "imex3", "imex4", "imex5", "dirk3", "dirk4", "dirk5" };
    struct tableau t;

    (void)state;
    check_stiff("imex2, dirk2", &tableau_ark2_dirk);
    for (int i = 0; i <= 6; i++) {
        struct method_def def = method_def_default();
        const struct method *m;
        const char *name = mri_beams_side.table;
        if (i < 6) {
            assert_int_equal(method_find(methods[i], &def, &m), STATUS_DONE);
            name = ((const struct arkode_row *)m)->dirk;
        }
        ARKodeButcherTable table = ARKodeButcherTable_LoadDIRKByName(name);
        assert_non_null(table);
        arkode_tables_read(table, &t);
        ARKodeButcherTable_Free(table);
        check_stiff(name, &t);
    }
}
