/* vector-serial.c -- operations that few methods ask for: SUNDIALS' serial ones, once
 * the numbers are where they look for them. */
#include "algebra/vector-private.h"

#include "ranks/ranks.h"

#include <math.h>

static N_Vector in(N_Vector v)
{
    vector_settle(vector_content(v));
    return v;
}

static N_Vector out(N_Vector v)
{
    vector_data(v);
    return v;
}

static double *array(N_Vector v)
{
    return vector_data(v);
}

/* From now on serial operations see n entries, from `from` on. */
static void show(N_Vector v, long from, long n)
{
    struct vector_content *c = vector_content(v);

    c->serial.data = c->store->data + from;
    c->serial.length = n;
}

/* A piece that this rank has after the other, of these vectors. */
static bool next(N_Vector x, N_Vector y, N_Vector z, long *from)
{
    const struct vector_family *f = vector_content(z)->family;
    long end;
    const bool more = vector_piece(f, from, f->n, &end);

    if (!more)
        end = f->n, *from = 0;
    show(x, *from, end - *from);
    show(y, *from, end - *from);
    show(z, *from, end - *from);
    *from = end;
    return more;
}

static void product(N_Vector x, N_Vector y, N_Vector z)
{
    for (long from = (in(x), in(y), out(z), 0); next(x, y, z, &from);)
        N_VProd_Serial(x, y, z);
}

static void quotient(N_Vector x, N_Vector y, N_Vector z)
{
    for (long from = (in(x), in(y), out(z), 0); next(x, y, z, &from);)
        N_VDiv_Serial(x, y, z);
}

static void absolute(N_Vector x, N_Vector z)
{
    for (long from = (in(x), out(z), 0); next(x, x, z, &from);)
        N_VAbs_Serial(x, z);
}

static void inverse(N_Vector x, N_Vector z)
{
    for (long from = (in(x), out(z), 0); next(x, x, z, &from);)
        N_VInv_Serial(x, z);
}

static void add_constant(N_Vector x, sunrealtype c, N_Vector z)
{
    for (long from = (in(x), out(z), 0); next(x, x, z, &from);)
        N_VAddConst_Serial(x, c, z);
}

static void compare(sunrealtype c, N_Vector x, N_Vector z)
{
    N_VCompare_Serial(c, in(x), out(z));
}

static sunbooleantype inverse_test(N_Vector x, N_Vector z)
{
    return N_VInvTest_Serial(in(x), out(z));
}

static sunbooleantype constraint_mask(N_Vector c, N_Vector x, N_Vector z)
{
    return N_VConstrMask_Serial(in(c), in(x), out(z));
}

/* CVODE and ARKODE bound a first step by it, on all ranks alike: rates of rows of others are 0. */
static sunrealtype largest(N_Vector x)
{
    double most = 0;

    for (long from = (in(x), 0); next(x, x, x, &from);)
        most = fmax(most, N_VMaxNorm_Serial(x));
    ranks_most(1, &most);
    return most;
}

static sunrealtype least(N_Vector x)
{
    return N_VMin_Serial(in(x));
}

static sunrealtype sum_of_absolutes(N_Vector x)
{
    return N_VL1Norm_Serial(in(x));
}

static sunrealtype length_weighted(N_Vector x, N_Vector w)
{
    return N_VWL2Norm_Serial(in(x), in(w));
}

static sunrealtype norm_masked(N_Vector x, N_Vector w, N_Vector mask)
{
    return N_VWrmsNormMask_Serial(in(x), in(w), in(mask));
}

static sunrealtype least_quotient(N_Vector x, N_Vector y)
{
    return N_VMinQuotient_Serial(in(x), in(y));
}

void vector_serial_operations(N_Vector v)
{
    v->ops->nvgetarraypointer = array;
    v->ops->nvprod = product;
    v->ops->nvdiv = quotient;
    v->ops->nvabs = absolute;
    v->ops->nvinv = inverse;
    v->ops->nvaddconst = add_constant;
    v->ops->nvcompare = compare;
    v->ops->nvinvtest = inverse_test;
    v->ops->nvconstrmask = constraint_mask;
    v->ops->nvmaxnorm = largest;
    v->ops->nvmin = least;
    v->ops->nvl1norm = sum_of_absolutes;
    v->ops->nvwl2norm = length_weighted;
    v->ops->nvwrmsnormmask = norm_masked;
    v->ops->nvminquotient = least_quotient;
}
