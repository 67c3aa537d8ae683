/* mps-gradient.c -- what the pressure does to velocities.
 *
 *     minimum  grad p = D/n0 sum (p_j - q_i) r_ij/r^2 w,  q_i the least p around   (M5)
 *     cmps     grad p = D/n0 sum (p_i + p_j - q_i - q_j) r_ij/r^2 w               (M13)
 *     gc       grad p = M^-1 sum (p_j - p_i) r_ij/r^2 w,  M = sum w r_ij r_ij/r^2 (M14)
 *     du = -dt/rho0 grad p                                                        (M8)
 *
 * over neighbours with a pressure, those at a surface (p = 0) among them.  (M5): Koshizuka and
 * Oka 1996; (M13): Khayyer and Gotoh, Coastal Eng. J. 50 (2008) 179-207; (M14): the same,
 * J. Comput. Phys. 230 (2011) 3093-3118.  Where M is nearly singular, as in spray, (M14) is
 * taken with the M of a lattice, n0/D. */
#include "solved/mps-inside.h"

#include <math.h>
#include <string.h>

static const double worst = 1e-3; /* det M over (trace M/D)^D below which M is not used */

/* Neighbour k of i, if it has a pressure: its place as a particle, with the way to it, and
 * w/r^2 in *share; else -1. */
static int partner(const struct mps *s, int i, size_t k, double *step, double *share)
{
    const struct near *at = &s->near;
    const int j = at->origin[at->place[k]];
    const double r2 = near_step(at, i, at->place[k], step);

    if (s->role[j] == POISSON_DUMMY || !(r2 < s->gradient.re * s->gradient.re) || !(r2 > 0))
        return -1;
    *share = weights_w(&s->gradient, sqrt(r2)) / r2;
    return j;
}

static double lowest(const struct mps *s, int i)
{
    double least = s->p[i], step[DIM], share;

    for (size_t k = s->near.from[i]; k < s->near.from[i + 1]; k++) {
        const int j = partner(s, i, k, step, &share);
        if (j >= 0)
            least = fmin(least, s->p[j]);
    }
    return least;
}

static double minimum(const struct mps *s, int i, int j)
{
    return s->p[j] - s->lowest[i];
}

static double cmps(const struct mps *s, int i, int j)
{
    return s->p[i] + s->p[j] - s->lowest[i] - s->lowest[j];
}

static double plain(const struct mps *s, int i, int j)
{
    return s->p[j] - s->p[i];
}

static mps_pair *choose(const char *word)
{
    if (mps_is(word, "minimum"))
        return minimum;
    return mps_is(word, "cmps") ? cmps : plain;
}

/* v = M^-1 v by elimination; M is symmetric and positive definite. */
static void divide(double M[DIM][DIM], double *v)
{
    for (int a = 0; a < DIM; a++)
        for (int b = a + 1; b < DIM; b++) {
            const double share = M[b][a] / M[a][a];
            for (int c = a; c < DIM; c++)
                M[b][c] -= share * M[a][c];
            v[b] -= share * v[a];
        }
    for (int a = DIM - 1; a >= 0; a--) {
        for (int b = a + 1; b < DIM; b++)
            v[a] -= M[a][b] * v[b];
        v[a] /= M[a][a];
    }
}

static double determinant(double M[DIM][DIM])
{
#if DIM == 2
    return M[0][0] * M[1][1] - M[0][1] * M[1][0];
#else
    return M[0][0] * (M[1][1] * M[2][2] - M[1][2] * M[2][1])
         - M[0][1] * (M[1][0] * M[2][2] - M[1][2] * M[2][0])
         + M[0][2] * (M[1][0] * M[2][1] - M[1][1] * M[2][0]);
#endif
}

/* sum = grad p from the sums of (M14). */
static void correct(const struct mps *s, double M[DIM][DIM], double *sum)
{
    double mean = 0;

    for (int d = 0; d < DIM; d++)
        mean += M[d][d] / DIM;
    if (determinant(M) > worst * pow(mean, DIM)) {
        divide(M, sum);
        return;
    }
    for (int d = 0; d < DIM; d++)
        sum[d] *= DIM / s->gradient.n0;
}

static void gradient(const struct mps *s, int i, double *sum)
{
    double M[DIM][DIM] = { { 0 } }, step[DIM], share;

    memset(sum, 0, DIM * sizeof *sum);
    for (size_t k = s->near.from[i]; k < s->near.from[i + 1]; k++) {
        const int j = partner(s, i, k, step, &share);
        if (j < 0)
            continue;
        const double by = s->rise(s, i, j) * share;
        for (int d = 0; d < DIM; d++) {
            sum[d] += by * step[d];
            for (int c = 0; c < DIM; c++)
                M[d][c] += share * step[d] * step[c];
        }
    }
    if (s->rise == plain)
        correct(s, M, sum);
    else
        for (int d = 0; d < DIM; d++)
            sum[d] *= DIM / s->gradient.n0;
}

/* What solid j gets by the pairs of (M5) or (M13) that act on fluid; of (M14) with M of the
 * lattice. */
static void push_solid(struct mps *s, int j)
{
    const struct near *at = &s->near;
    const double c = s->h / s->moment->plan->scales.rho0 * DIM / s->gradient.n0;
    double step[DIM], share;

    for (size_t k = at->from[j]; k < at->from[j + 1]; k++) {
        const int i = partner(s, j, k, step, &share);
        if (i < 0 || i >= at->fluid)
            continue;
        mps_push(s, MPS_PRESSURE, j, -c * mps_mass(s, i) * s->rise(s, i, j) * share, step);
    }
}

void mps_gradient(struct mps *s)
{
    const double c = -s->h / s->moment->plan->scales.rho0;

    s->rise = choose(s->key->gradient);
#pragma omp parallel for schedule(static)
    for (int i = 0; i < s->near.n; i++)
        s->lowest[i] = s->role[i] == POISSON_DUMMY ? 0 : lowest(s, i);
#pragma omp parallel for schedule(static)
    for (int i = 0; i < s->near.fluid; i++) {
        double sum[DIM];
        gradient(s, i, sum);
        for (int d = 0; d < DIM; d++)
            s->du[i][d] = c * sum[d];
    }
    for (int j = s->near.fluid; j < s->near.n; j++)
        if (s->role[j] != POISSON_DUMMY)
            push_solid(s, j);
}
