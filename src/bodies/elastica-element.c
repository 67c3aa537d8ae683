/* elastica-element.c -- an element of a beam that bends far: energy, force, tangent.
 *
 *   E = int EA/4 (|r'|^2 - 1 - ln |r'|^2) + EI/2 kappa^2 ds,
 *   kappa = (r' x r'')/|r'|^2                                                   (BE4)
 *
 * kappa is dtheta/ds, how the tangent turns per rest length: Reissner's beam, J. Appl.
 * Math. Phys. 23 (1972) 795-804, without shear; where that has EA/2 (|r'| - 1)^2 stands
 * what is the same for small strains, but never lets a soft beam be pressed to nothing.
 * r is a cubic (Hermite), as in Gerstmayr and Shabana, Nonlinear Dynamics 45 (2006)
 * 109-130, so that mass does not depend on the position, a turn strains nothing, and
 * small deflections are those of element.c.  kappa is looked at in two points of Gauss,
 * which is exact for small deflections; stretch at both ends and in the middle: an element
 * that keeps its length there bends as freely as a linear one.  More points would stiffen
 * it, and with two of Gauss all nodes could grow together at no cost.
 * Checked in tests/unit/elastica.c. */
#include "bodies/elastica-element.h"

#include "bodies/elastica-turn.h"
#include "bodies/element.h"
#include <math.h>
#include <string.h>

static void look_at(double xi, double weight, double l, struct elastica_point *p)
{
    element_shape(xi, l, p->shape, p->slope);
    p->weight = weight * l;
    p->curve[0] = (12 * xi - 6) / (l * l);
    p->curve[1] = (6 * xi - 4) / l;
    p->curve[2] = -p->curve[0];
    p->curve[3] = (6 * xi - 2) / l;
}

void elastica_element_make(double EA, double EI, double l, struct elastica_element *out)
{
    const double gauss = 0.5 / sqrt(3);

    *out = (struct elastica_element){ .EA = EA, .EI = EI, .l = l };
    look_at(0, 1.0 / 6, l, &out->stretch[0]);
    look_at(0.5, 4.0 / 6, l, &out->stretch[1]);
    look_at(1, 1.0 / 6, l, &out->stretch[2]);
    look_at(0.5 - gauss, 0.5, l, &out->bend[0]);
    look_at(0.5 + gauss, 0.5, l, &out->bend[1]);
}

enum what { STIFFNESS, TANGENT }; /* without and with what makes the other indefinite */

/* --- stretch -------------------------------------------------------------- */

/* r' goes to a; returns |r'|^2 - 1 without taking nearly equal numbers apart. */
static double stretch_of(const struct elastica_point *p, const double *q, double *a)
{
    double d[2], unused[2];

    elastica_turn_derive(p, q, d, unused);
    a[0] = 1 + d[0];
    a[1] = d[1];
    return 2 * d[0] + d[0] * d[0] + d[1] * d[1];
}

static void add_stretch_force(const struct elastica_element *e, const struct elastica_point *p,
                              const double *q, double *f)
{
    double a[2];
    const double d = stretch_of(p, q, a), pull = p->weight * e->EA / 2 * d / (1 + d);

    for (int k = 0; k < 4; k++)
        for (int c = 0; c < 2; c++)
            f[elastica_entry(k, c)] += pull * a[c] * p->slope[k];
}

static void add_stretch_tangent(const struct elastica_element *e, const struct elastica_point *p,
                                enum what what, const double *q,
                                double k[ELASTICA_ELEMENT][ELASTICA_ELEMENT])
{
    double a[2], h[2][2];
    const double d = stretch_of(p, q, a), s = 1 + d;
    const double pull = what == TANGENT || d > 0 ? d / s / 2 : 0;

    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            h[i][j] = p->weight * e->EA * (a[i] * a[j] / (s * s) + (i == j) * pull);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            for (int c = 0; c < 2; c++)
                for (int b = 0; b < 2; b++)
                    k[elastica_entry(i, c)][elastica_entry(j, b)] +=
                        h[c][b] * p->slope[i] * p->slope[j];
}

/* --- bending -------------------------------------------------------------- */

static void add_bending_force(const struct elastica_element *e, const struct elastica_point *p,
                              const double *q, double *f)
{
    const struct elastica_turn t = elastica_turn_at(p, q);

    elastica_turn_spread(p, t.by, p->weight * e->EI * t.kappa, f);
}

static void add_bending_tangent(const struct elastica_element *e, const struct elastica_point *p,
                                enum what what, const double *q,
                                double k[ELASTICA_ELEMENT][ELASTICA_ELEMENT])
{
    const struct elastica_turn t = elastica_turn_at(p, q);
    const double bent = what == TANGENT ? t.kappa : 0;
    double h[4][4];

    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            h[i][j] = p->weight * e->EI * (t.by[i] * t.by[j] + bent * t.twice[i][j]);
    elastica_turn_spread_twice(p, h, k);
}

/* --- the element ---------------------------------------------------------- */

double elastica_element_energy(const struct elastica_element *e, const double *q)
{
    double sum = 0, a[2];

    for (int i = 0; i < ELASTICA_STRETCHES; i++) {
        const double d = stretch_of(&e->stretch[i], q, a);
        sum += 0.25 * e->stretch[i].weight * e->EA * (d - log1p(d));
    }
    for (int i = 0; i < ELASTICA_BENDS; i++)
        sum += 0.5 * e->bend[i].weight * e->EI * pow(elastica_turn_at(&e->bend[i], q).kappa, 2);
    return sum;
}

void elastica_element_force(const struct elastica_element *e, const double *q, double *f)
{
    for (int i = 0; i < ELASTICA_STRETCHES; i++)
        add_stretch_force(e, &e->stretch[i], q, f);
    for (int i = 0; i < ELASTICA_BENDS; i++)
        add_bending_force(e, &e->bend[i], q, f);
}

static void add_up(const struct elastica_element *e, enum what what, const double *q,
                   double k[ELASTICA_ELEMENT][ELASTICA_ELEMENT])
{
    memset(k, 0, ELASTICA_ELEMENT * sizeof k[0]);
    for (int i = 0; i < ELASTICA_STRETCHES; i++)
        add_stretch_tangent(e, &e->stretch[i], what, q, k);
    for (int i = 0; i < ELASTICA_BENDS; i++)
        add_bending_tangent(e, &e->bend[i], what, q, k);
}

void elastica_element_tangent(const struct elastica_element *e, const double *q,
                              double k[ELASTICA_ELEMENT][ELASTICA_ELEMENT])
{
    add_up(e, TANGENT, q, k);
}

void elastica_element_stiffness(const struct elastica_element *e, const double *q,
                                double k[ELASTICA_ELEMENT][ELASTICA_ELEMENT])
{
    add_up(e, STIFFNESS, q, k);
}

/* Across is r' turned by +90 degrees; what is given counts per rest length. */
void elastica_element_press(const struct elastica_element *e, double load, const double *q,
                            double *f)
{
    for (int i = 0; i < ELASTICA_BENDS; i++) {
        const struct elastica_point *p = &e->bend[i];
        double a[2];

        stretch_of(p, q, a);
        const double size = hypot(a[0], a[1]), across[2] = { -a[1] / size, a[0] / size };
        for (int k = 0; k < 4; k++)
            for (int c = 0; c < 2; c++)
                f[elastica_entry(k, c)] += p->weight * load * across[c] * p->shape[k];
    }
}
