/* contacts-uplift.c -- water's pressure in narrow gaps at the faces of a box.
 *
 * The forces on the two rows of the skin beside an edge are a mean pressure there, p_e, and
 * gravity takes it to the depth of the gap.  In between                              (UP1)
 *   p = sum_e w_e o_e p_e / sum_e w_e o_e,  o_e = 1 - (closed share of the face beyond e),
 * w_e linear from 1 at edge e to 0 at the one across, over the square of the way between them.
 * Of each cell of a face that lies at a partner the force on the box is              (UP2)
 *   -n p S((3/2 - gap/dx)) S((-n . m - 0.7)/0.3) dA,  S(x) = x^2 (3 - 2 x) in 0..1,
 * with m out of the partner at the point of it that is nearest, and the partner has the opposite. */
#include "bodies/contacts-uplift.h"

#include "base/status.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double rows = 2;        /* of a strip beside an edge [dx]                  */
static const double widest = 1.5;    /* gap that is still too narrow for particles [dx] */
static const double aslant = 0.7;    /* cosine at which faces no longer face each other */
static const double dry = 1e-15;     /* where every way out is closed                   */

struct contacts_uplift {
    const struct solid *solid;
    double dx, rho0, g[DIM];
    double half[DIM];        /* of its sides [m]                                   */
    int cells[DIM];          /* that a side is cut into                            */
    int points;
    unsigned char *beside;   /* [points] faces, bits, within `rows` of it          */
    unsigned char *behind;   /* [points] faces whose skin it belongs to            */
};

static int axis_of(int face)
{
    return face / 2;
}

static double sign_of(int face)
{
    return face % 2 ? 1 : -1;
}

static double width(const struct contacts_uplift *u, int axis)
{
    return fmin(rows * u->dx, 2 * u->half[axis]);
}

/* Which faces each point of the skin is near; x [points][DIM] at the start. */
static void sort_points(struct contacts_uplift *u, const double (*x)[DIM])
{
    for (int i = 0; i < u->points; i++) {
        double step[DIM], own[DIM];
        for (int d = 0; d < DIM; d++)
            step[d] = x[i][d] - u->solid->start.x[d];
        solid_own(&u->solid->start, step, own);
        for (int f = 0; f < UPLIFT_FACES; f++) {
            const int k = axis_of(f);
            const double deep = u->half[k] - sign_of(f) * own[k];
            if (deep < width(u, k))
                u->beside[i] |= (unsigned char)(1u << f);
            if (deep < u->half[k])
                u->behind[i] |= (unsigned char)(1u << f);
        }
    }
}

static int fill(struct contacts_uplift *u, const struct contacts_body *b, const struct scales *s)
{
    double (*x)[DIM] = status_alloc((size_t)b->points + 1, sizeof *x);
    enum kind kind;

    u->beside = status_alloc((size_t)b->points + 1, sizeof *u->beside);
    u->behind = status_alloc((size_t)b->points + 1, sizeof *u->behind);
    if (!x || !u->beside || !u->behind) {
        free(x);
        return STATUS_FAILED;
    }
    u->points = b->points;
    u->dx = s->dx;
    u->rho0 = s->rho0;
    memcpy(u->g, s->g, sizeof u->g);
    for (int k = 0; k < DIM; k++) {
        u->half[k] = u->solid->core.half[k] + u->solid->core.ball;
        u->cells[k] = (int)fmax(1, round(2 * u->half[k] / s->dx));
    }
    b->kind->skin(b->body, x, &kind);
    sort_points(u, (const double (*)[DIM])x);
    free(x);
    return STATUS_DONE;
}

int contacts_uplift_create(const struct solid *solid, const struct contacts_body *b,
                           const struct scales *scales, struct contacts_uplift **out)
{
    struct contacts_uplift *u = status_alloc(1, sizeof *u);

    *out = NULL;
    if (!u)
        return STATUS_FAILED;
    u->solid = solid;
    if (fill(u, b, scales) == STATUS_DONE)
        *out = u;
    else
        contacts_uplift_free(&u);
    return *out ? STATUS_DONE : STATUS_FAILED;
}

void contacts_uplift_free(struct contacts_uplift **u)
{
    if (!*u)
        return;
    free((*u)->beside);
    free((*u)->behind);
    free(*u);
    *u = NULL;
}

/* Sums of forces into faces, on the strips beside others. */
static void sum_strips(const struct contacts_uplift *u, const struct solid_place *at,
                       const double (*force)[DIM], struct uplift_faces *to)
{
    for (int i = 0; i < u->points; i++) {
        double own[DIM];
        solid_own(at, force[i], own);
        for (int f = 0; f < UPLIFT_FACES; f++)
            for (int e = 0; e < UPLIFT_FACES && u->beside[i] >> f & 1; e++)
                if (axis_of(e) != axis_of(f) && u->behind[i] >> e & 1)
                    to->edge[f][e] -= sign_of(e) * own[axis_of(e)];
    }
}

/* From the middle of the strip to the gap, by the weight of the water; no tension. */
static double at_gap(const struct contacts_uplift *u, const struct solid_place *at, int f, double p)
{
    const int k = axis_of(f);
    double fall = 0;

    for (int d = 0; d < DIM; d++)
        fall += sign_of(f) * at->R[d][k] * u->g[d];
    fall *= 0.5 * u->rho0 * width(u, k);
    return p > 0 ? p + fmax(-p, fmin(p, fall)) : 0;
}

void contacts_uplift_read(const struct contacts_uplift *u, const struct solid_place *at,
                          const double (*force)[DIM], struct uplift_faces *to)
{
    memset(to, 0, sizeof *to);
    sum_strips(u, at, force, to);
    for (int f = 0; f < UPLIFT_FACES; f++)
        for (int e = 0; e < UPLIFT_FACES; e++) {
            double area = width(u, axis_of(f));
            for (int d = 0; d < DIM; d++)
                area *= d == axis_of(f) || d == axis_of(e) ? 1 : 2 * u->half[d];
            to->edge[f][e] = at_gap(u, at, f, to->edge[f][e] / area);
        }
}

static double smooth(double x)
{
    const double c = fmin(1, fmax(0, x));

    return c * c * (3 - 2 * c);
}

/* A place at the surface of the box, for cell i of a face. */
static void cell(const struct contacts_uplift *u, int f, int i, double *own)
{
    for (int d = 0; d < DIM; d++) {
        own[d] = sign_of(f) * u->half[d];
        if (d == axis_of(f))
            continue;
        own[d] = ((i % u->cells[d] + 0.5) / u->cells[d] * 2 - 1) * u->half[d];
        i /= u->cells[d];
    }
}

static int cells_of(const struct contacts_uplift *u, int f)
{
    int count = 1;

    for (int d = 0; d < DIM; d++)
        count *= d == axis_of(f) ? 1 : u->cells[d];
    return count;
}

/* How far that place of face f is from the partner [m]; *facing: cosine of n and -m. */
static double gap_at(const struct contacts_guest *g, int f, const double *own, double *facing)
{
    double at[DIM], nearest[DIM], square = 0, along = 0;

    contacts_guest_place(g, own, at);
    core_nearest(&g->partner->core, at, nearest);
    for (int d = 0; d < DIM; d++) {
        const double step = at[d] - nearest[d];
        square += step * step;
        along -= sign_of(f) * g->in.R[d][axis_of(f)] * step;
    }
    *facing = square > 0 ? along / sqrt(square) : 1;
    return sqrt(square) - g->partner->core.ball;
}

/* What part of the pressure acts there. */
static double share(const struct contacts_uplift *u, const struct contacts_guest *g, int f,
                    const double *own)
{
    double facing;
    const double gap = gap_at(g, f, own, &facing);

    return smooth(widest - gap / u->dx) * smooth((facing - aslant) / (1 - aslant));
}

/* Can any place of the face be near? */
static bool is_near(const struct contacts_uplift *u, const struct contacts_guest *g, int f)
{
    double own[DIM] = { 0 }, square = 0, facing;

    for (int d = 0; d < DIM; d++)
        square += d == axis_of(f) ? 0 : u->half[d] * u->half[d];
    own[axis_of(f)] = sign_of(f) * u->half[axis_of(f)];
    return gap_at(g, f, own, &facing) < widest * u->dx + sqrt(square);
}

void contacts_uplift_close(const struct contacts_uplift *u, const struct contacts_guest *g,
                           struct uplift_faces *to)
{
    for (int f = 0; f < UPLIFT_FACES; f++)
        for (int i = 0, n = cells_of(u, f); i < n && is_near(u, g, f); i++) {
            double own[DIM];
            cell(u, f, i, own);
            to->closed[f] += share(u, g, f, own) / n;
        }
}

/* (UP1) */
static double pressure(const struct contacts_uplift *u, const struct uplift_faces *faces, int f,
                       const double *own)
{
    double sum = 0, all = dry;

    for (int e = 0; e < UPLIFT_FACES; e++) {
        const int k = axis_of(e);
        const double way = (1 + sign_of(e) * own[k] / u->half[k]) / 2;
        const double w = way * fmax(0, 1 - faces->closed[e]) * pow(u->half[axis_of(f)] / u->half[k], 2);
        if (k == axis_of(f))
            continue;
        sum += w * faces->edge[f][e];
        all += w;
    }
    return sum / all;
}

void contacts_uplift_push(const struct contacts_uplift *u, const struct contacts_guest *g,
                          const struct uplift_faces *faces, struct body_push *on_guest,
                          struct body_push *on_partner, double *power)
{
    for (int f = 0; f < UPLIFT_FACES; f++) {
        const int n = cells_of(u, f);
        double area = 1.0 / n;
        for (int d = 0; d < DIM; d++)
            area *= d == axis_of(f) ? 1 : 2 * u->half[d];
        for (int i = 0; i < n && is_near(u, g, f); i++) {
            double own[DIM], force[DIM] = { 0 };
            cell(u, f, i, own);
            force[axis_of(f)] = -sign_of(f) * area * share(u, g, f, own) * pressure(u, faces, f, own);
            contacts_guest_press(g, own, force, on_guest, on_partner, power);
        }
    }
}
