/* vector-sum.c -- linear combinations, put off until they are read. */
#include "algebra/vector-private.h"

#include "base/threads.h"

#include <string.h>

/* to = sum of c[k] x[k] inside of the ranges, at once. */
static void sum_inside(const struct vector_family *f, int terms, const double *c,
                       const double *const *x, double *to)
{
    for (int r = 0; r < f->ranges; r++) {
        const long from = f->range[r][0];
        const double *part[VECTOR_TERMS];
        for (int k = 0; k < terms; k++)
            part[k] = x[k] + from;
        vector_combine(terms, c, part, f->range[r][1] - from, to + from);
    }
}

static void nothing(struct vector_content *z)
{
    const struct vector_family *f = z->family;
    double *to = vector_renew(z);

    for (int r = 0; r < f->ranges; r++)
        memset(to + f->range[r][0], 0, (size_t)(f->range[r][1] - f->range[r][0]) * sizeof *to);
    z->outside = VECTOR_ZERO;
    z->nothing = true;
}

/* What a sum of terms that are in their stores is outside of the ranges. */
static void outside_of(int terms, const double *c, struct vector_content *const *x,
                       struct vector_sum *sum)
{
    sum->unit = NULL;
    sum->terms = 0;
    for (int k = 0; k < terms; k++) {
        if (x[k]->outside == VECTOR_ZERO)
            continue;
        if (k == 0 && terms > 1 && c[0] == 1) { /* is added last */
            sum->unit = x[0]->store;
        } else {
            sum->c[sum->terms] = c[k];
            sum->x[sum->terms++] = x[k]->store;
        }
    }
}

/* z = sum, where `inside` holds its terms for the ranges. */
static void finish(struct vector_content *z, const struct vector_sum *sum, int terms,
                   const double *c, const double *const *inside)
{
    double *to = vector_renew(z);
    bool in_place = sum->unit == z->store;

    for (int k = 0; k < sum->terms; k++)
        in_place |= sum->x[k] == z->store;
    sum_inside(z->family, terms, c, inside, to);
    if (sum->terms == 0 && !sum->unit) {
        z->outside = VECTOR_ZERO;
        return;
    }
    vector_put_off(z, sum);
    if (in_place)
        vector_settle(z);
}

/* z = c[0] x[0] + ..., none of them nothing, no c zero. */
static void add(int terms, const double *c, struct vector_content *const *x,
                struct vector_content *z)
{
    const double *inside[VECTOR_TERMS];
    struct vector_sum sum;

    if (terms == 0) {
        nothing(z);
        return;
    }
    for (int k = 0; k < terms; k++) {
        if (x[k]->outside == VECTOR_LATER)
            vector_settle(x[k]);
        inside[k] = x[k]->store->data;
    }
    if (terms == 1 && c[0] == 1 && x[0]->outside == VECTOR_HERE) {
        vector_share(x[0], z);
        return;
    }
    outside_of(terms, c, x, &sum);
    finish(z, &sum, terms, c, inside);
}

/* Of vectors that are no clones of each other: at once. */
static void add_foreign(int terms, const double *c, N_Vector *v, N_Vector z)
{
    const double *x[VECTOR_TERMS];

    for (int k = 0; k < terms; k++)
        x[k] = vector_read(v[k]);
    vector_combine(terms, c, x, vector_content(z)->family->n, vector_renew(vector_content(z)));
}

static bool related(int terms, N_Vector *v, N_Vector z)
{
    for (int k = 0; k < terms; k++)
        if (vector_content(v[k])->family != vector_content(z)->family)
            return false;
    return true;
}

int vector_sum_combination(int terms, sunrealtype *c, N_Vector *v, N_Vector z)
{
    struct vector_content *x[VECTOR_TERMS];
    double cx[VECTOR_TERMS];
    int m = 0;

    if (terms < 1 || terms > VECTOR_TERMS)
        return -1;
    if (!related(terms, v, z)) {
        add_foreign(terms, c, v, z);
        return 0;
    }
    for (int k = 0; k < terms; k++)
        if (c[k] != 0 && !vector_content(v[k])->nothing) {
            cx[m] = c[k];
            x[m++] = vector_content(v[k]);
        }
    add(m, cx, x, vector_content(z));
    return 0;
}

/* --- two ----------------------------------------------------------------- */

static bool same_sum(const struct vector_sum *a, const struct vector_sum *b)
{
    const size_t n = (size_t)a->terms;

    return a->unit == b->unit && a->terms == b->terms
        && memcmp(a->c, b->c, n * sizeof *a->c) == 0 && memcmp(a->x, b->x, n * sizeof *a->x) == 0;
}

static bool same_outside(const struct vector_content *x, const struct vector_content *y)
{
    if (x->outside != y->outside)
        return false;
    return x->outside == VECTOR_ZERO || (x->outside == VECTOR_HERE && x->store == y->store)
        || (x->outside == VECTOR_LATER && same_sum(&x->sum, &y->sum));
}

/* a x - a y, which are the same outside of the ranges. */
static void difference(double a, const struct vector_content *x, const struct vector_content *y,
                       struct vector_content *z)
{
    const double c[2] = { a, -a };
    const double *const inside[2] = { x->store->data, y->store->data };
    const struct vector_sum none = { .terms = 0 };

    if (x->store == y->store)
        nothing(z);
    else
        finish(z, &none, 2, c, inside);
}

/* z = here + later, both once: what is put off gets one term more. */
static void extend(const struct vector_content *here, const struct vector_content *later,
                   struct vector_content *z)
{
    static const double c[2] = { 1, 1 };
    const double *const inside[2] = { here->store->data, later->store->data };
    struct vector_sum sum = later->sum;

    sum.unit = here->store;
    finish(z, &sum, 2, c, inside);
}

static bool extends(const struct vector_content *here, const struct vector_content *later,
                    const struct vector_content *z)
{
    return here->outside == VECTOR_HERE && later->outside == VECTOR_LATER && !later->sum.unit
        && here != z && later != z;
}

void vector_sum_two(sunrealtype a, N_Vector x, sunrealtype b, N_Vector y, N_Vector z)
{
    struct vector_content *cx = vector_content(x), *cy = vector_content(y);
    double c[2] = { a, b };
    N_Vector v[2] = { x, y };

    if (!related(2, v, z))
        add_foreign(2, c, v, z);
    else if (a == -b && same_outside(cx, cy))
        difference(a, cx, cy, vector_content(z));
    else if (a == 1 && b == 1 && extends(cx, cy, vector_content(z)))
        extend(cx, cy, vector_content(z));
    else if (a == 1 && b == 1 && extends(cy, cx, vector_content(z)))
        extend(cy, cx, vector_content(z));
    else
        vector_sum_combination(2, c, v, z);
}

void vector_sum_scale(sunrealtype c, N_Vector x, N_Vector z)
{
    if (c != 1 || x != z)
        vector_sum_combination(1, &c, &x, z);
}

static void fill_block(const struct vector_family *f, long b, double c, double *x)
{
    const long to = b * VECTOR_BLOCK + vector_block_size(f->n, b);
    long from = b * VECTOR_BLOCK, end;

    for (; vector_piece(f, &from, to, &end); from = end)
        for (long i = from; i < end; i++)
            x[i] = c;
}

/* By this thread. */
static void fill_blocks(const struct vector_family *f, double c, double *x)
{
#pragma omp for schedule(static) nowait
    for (long b = 0; b < vector_blocks(f->n); b++)
        fill_block(f, b, c, x);
}

void vector_sum_constant(sunrealtype c, N_Vector z)
{
    const struct vector_family *f = vector_content(z)->family;
    double *to;

    if (c == 0) {
        nothing(vector_content(z));
        return;
    }
    to = vector_renew(vector_content(z));
    THREADS(f->n > VECTOR_LONG, fill_blocks(f, c, to));
}

/* --- ranges -------------------------------------------------------------- */

const double *vector_inside(N_Vector v)
{
    return vector_content(v)->store->data;
}

double *vector_like(N_Vector x, N_Vector z)
{
    struct vector_content *from = vector_content(x), *to = vector_content(z);
    static const double one = 1;
    const double *const inside = from->store->data;
    const struct vector_sum none = { .terms = 0 };

    if (from->outside == VECTOR_HERE || x == z) {
        vector_sum_scale(1, x, z);
        return vector_data(z);
    }
    finish(to, from->outside == VECTOR_LATER ? &from->sum : &none, 1, &one, &inside);
    return to->store->data;
}

void vector_only_inside(N_Vector v)
{
    struct vector_content *c = vector_content(v);

    if (c->outside == VECTOR_HERE && c->family->ranges > 0 && c->store->users == 1)
        c->outside = VECTOR_ZERO;
}
