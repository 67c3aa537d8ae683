/* elastica-element.h -- an element of a beam that bends far: its energy, force and
 * tangent at any position.
 *
 * Degrees of freedom of a node, in the frame of the straight beam: displacements u along
 * it and w across, and their slopes du/ds, dw/ds.  So r(s) = (s + u, w) is a cubic along
 * the rest length s.  Per metre of width in 2D. */
#ifndef BODIES_ELASTICA_ELEMENT_H
#define BODIES_ELASTICA_ELEMENT_H

enum {
    ELASTICA_NODE = 4,                   /* u, w, du/ds, dw/ds           */
    ELASTICA_ELEMENT = 2 * ELASTICA_NODE, /* degrees of freedom of two nodes */
    ELASTICA_STRETCHES = 3, ELASTICA_BENDS = 2
};

struct elastica_point { /* where strain is looked at */
    double weight;                    /* of the integral over s [m]           */
    double shape[4], slope[4], curve[4]; /* N, N', N'' of the four shapes     */
};

struct elastica_element {
    double EA, EI, l;                 /* [N, 2D: N/m], [N m^2, 2D: N m], [m]  */
    struct elastica_point stretch[ELASTICA_STRETCHES], bend[ELASTICA_BENDS];
};

void elastica_element_make(double EA, double EI, double l, struct elastica_element *out);

/* Entry of the eight that shape k (value, slope of the first node, of the second)
 * carries for component c: 0 along, 1 across. */
static inline int elastica_entry(int k, int c)
{
    return ELASTICA_NODE * (k / 2) + 2 * (k % 2) + c;
}

double elastica_element_energy(const struct elastica_element *e, const double *q);

/* f [8] += dE/dq; k [8][8] = d2E/dq2. */
void elastica_element_force(const struct elastica_element *e, const double *q, double *f);
void elastica_element_tangent(const struct elastica_element *e, const double *q,
                              double k[ELASTICA_ELEMENT][ELASTICA_ELEMENT]);

/* k [8][8] = the same without the forces that turn with the element, but for a tension: positive
 * semidefinite. */
void elastica_element_stiffness(const struct elastica_element *e, const double *q,
                                double k[ELASTICA_ELEMENT][ELASTICA_ELEMENT]);

/* f [8] += a uniform load across [N/m, 2D: N/m^2] that turns with the element. */
void elastica_element_press(const struct elastica_element *e, double load, const double *q,
                            double *f);

#endif
