/* space-kernel-rows.c -- kernels by rows: the same as at single distances, 0 from the
 * support on, the same bits at every lane width. */
#include "space.h"

#define LANES 2
#include "kernels/rows.h"

#include <math.h>
#include <string.h>

#ifdef STIFFWATER_V3
extern const struct kernel *const kernel_table_lanes4[];
#endif
#ifdef STIFFWATER_V4
extern const struct kernel *const kernel_table_lanes8[];
#endif

enum { ROWS = 52, NUMBERS = ROWS * LANES };

static const double H = 0.3;

/* What rows are made of, and what comes of them; aligned for any width. */
struct rows {
    _Alignas(64) double r[NUMBERS];
    _Alignas(64) double m[NUMBERS], g[NUMBERS], w[NUMBERS], l[NUMBERS];
    _Alignas(64) double r2[NUMBERS], same[NUMBERS], soft[NUMBERS]; /* of both() */
};

/* From 0 to a little more than H. */
static void distances(struct rows *a)
{
    for (int i = 0; i < NUMBERS; i++) {
        a->r[i] = H * i / (NUMBERS - 9.5);
        a->m[i] = 2 + i;
        a->r2[i] = a->r[i] * a->r[i];
    }
}

static void compute(struct rows *a, const struct kernel *k, double support, int width)
{
    const double scale = k->sigma[DIM] / pow(support, DIM);
    const lanes *r = (const lanes *)a->r, *m = (const lanes *)a->m;

    k->rows->gradient(support, scale, NUMBERS / width, r, m, (lanes *)a->g);
    k->rows->value(support, scale, NUMBERS / width, r, m, (lanes *)a->w);
    k->rows->laplacian(support, scale, NUMBERS / width, r, m, (lanes *)a->l);
    if (k->rows->both)
        k->rows->both(support, scale, NUMBERS / width, r, (const lanes *)a->r2, m,
                      (lanes *)a->same, (lanes *)a->soft);
}

/* One loop gives the bits of two. */
static void compare_both(const struct kernel *k, const struct rows *a, int i)
{
    check(a->same[i] == a->g[i], "%s: both() has W'(r)/r = %g, not %g", k->name, a->same[i],
          a->g[i]);
    check(a->soft[i] == a->g[i] / (a->r2[i] + 0.01 * (H / 2) * (H / 2)),
          "%s: softened %g", k->name, a->soft[i]);
}

static void compare(const struct kernel *k, const struct rows *a, int i)
{
    const struct kernel_use use = kernel_use_make(k, H, DIM);
    const double r = a->r[i], m = a->m[i];
    const double w = m * kernel_w(&use, r), g = m * kernel_gradient(&use, r) / r;
    const double l = m * kernel_laplacian(&use, r), size = m * use.scale * k->w(0.1);

    check(fabs(a->w[i] - w) <= 1e-13 * (size + fabs(w)), "%s: W(%g) = %g, not %g", k->name, r,
          a->w[i], w);
    check(fabs(a->g[i] - g) <= 1e-12 * (size / (H * H) + fabs(g)),
          "%s: W'(r)/r at %g = %g, not %g", k->name, r, a->g[i], g);
    check(fabs(a->l[i] - l) <= 1e-12 * (size / (H * H) + fabs(l)),
          "%s: Laplacian at %g = %g, not %g", k->name, r, a->l[i], l);
}

/* At r = 0: W'/r = W''(0) of a smooth kernel; where W'/r or W have no end, that of a
 * distance of KERNEL_CLOSE H. */
static void compare_centre(const struct kernel *k, const struct rows *a)
{
    const struct kernel_use use = kernel_use_make(k, H, DIM);
    const double r = KERNEL_CLOSE * H;
    const double g = k->dw(0) == 0 ? use.scale / (H * H) * k->ddw(0) : kernel_gradient(&use, r) / r;
    const double w = k->singular ? kernel_w(&use, r) : kernel_w(&use, 0);

    check(isfinite(a->g[0]) && isfinite(a->w[0]) && isfinite(a->l[0]), "%s at 0", k->name);
    check(fabs(a->g[0] / (a->m[0] * g) - 1) < 1e-12, "%s: W'(r)/r = %g at 0", k->name, a->g[0]);
    check(fabs(a->w[0] / (a->m[0] * w) - 1) < 1e-12, "%s: W = %g at 0", k->name, a->w[0]);
    check(fabs(a->l[0] / (a->m[0] * kernel_laplacian(&use, 0)) - 1) < 1e-12,
          "%s: Laplacian %g at 0", k->name, a->l[0]);
}

/* Rows give W, W'/r and the Laplacian of single distances; r = 0 is finite. */
void kernel_rows_agree(void **state)
{
    struct rows a;

    (void)state;
    distances(&a);
    for (int i = 0; kernel_table[i]; i++) {
        compute(&a, kernel_table[i], H, LANES);
        compare_centre(kernel_table[i], &a);
        for (int n = 1; n < NUMBERS; n++)
            compare(kernel_table[i], &a, n);
        for (int n = 0; n < NUMBERS && kernel_table[i]->rows->both; n++)
            compare_both(kernel_table[i], &a, n);
    }
}

/* Exactly 0 from the support on, also at the dummy's distance, and small before it. */
void kernel_ends_at_support(void **state)
{
    const double far[] = { 1, 1 + 1e-15, 1.5, 1e3, 1e30 };
    struct rows a;

    (void)state;
    distances(&a);
    for (int n = 0; n < NUMBERS; n++)
        a.r[n] = far[n % 5];
    for (int i = 0; kernel_table[i]; i++) {
        const struct kernel_use use = kernel_use_make(kernel_table[i], 1, DIM);
        const char *name = use.kernel->name;

        compute(&a, use.kernel, 1, LANES);
        for (int n = 0; n < 5; n++) {
            check(a.g[n] == 0 && a.w[n] == 0 && a.l[n] == 0, "%s is not 0 at %g H", name, far[n]);
            check(kernel_w(&use, far[n]) == 0 && kernel_gradient(&use, far[n]) == 0
                  && kernel_laplacian(&use, far[n]) == 0, "%s at %g", name, far[n]);
        }
        check(fabs(kernel_w(&use, 1 - 1e-9)) < 1e-8, "%s jumps at H by %g", name,
              kernel_w(&use, 1 - 1e-9));
    }
}

static void compare_widths(const struct kernel *const *table, int width)
{
    struct rows two, more;

    distances(&two);
    distances(&more);
    for (int i = 0; kernel_table[i]; i++) {
        compute(&two, kernel_table[i], H, 2);
        compute(&more, table[i], H, width);
        check(memcmp(&two, &more, sizeof two) == 0, "%s differs with %d lanes",
              kernel_table[i]->name, width);
    }
}

/* Two lanes or more: the same bits. */
void kernel_same_bits_lanes(void **state)
{
    (void)state;
    (void)compare_widths;
#ifdef STIFFWATER_V3
    if (space_engines() > 1)
        compare_widths(kernel_table_lanes4, 4);
#endif
#ifdef STIFFWATER_V4
    if (space_engines() > 2)
        compare_widths(kernel_table_lanes8, 8);
#endif
}
