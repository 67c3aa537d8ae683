/* bending.h -- M q'' + D q' + K q = F of a straight beam of equal elements.
 *
 * Degrees of freedom: q[2 i] deflection w [m], q[2 i + 1] rotation theta of node
 * i, nodes from the root (0) to the tip; F holds forces and moments in the same
 * places.  Everything is per metre of width in 2D.  Ends take degrees of freedom
 * away: those stay in the vectors as entries that nothing moves ("held").
 *
 *     bending_create(&def, &b);     const from here on
 *     bending_work_create(b, &w);   what functions work in; one for each caller that may
 *                                   be in the middle of something
 */
#ifndef BODIES_BENDING_H
#define BODIES_BENDING_H

#include "algebra/band.h"

enum bending_end { BENDING_CLAMPED, BENDING_PINNED, BENDING_FREE };

enum bending_inertia { /* m = mu l: mass of an element                          */
    BENDING_CONSISTENT,  /* from the shapes of the elements                      */
    BENDING_LUMPED,      /* (44) as printed: m, m l^2/12 at all nodes; (n + 1) m */
    BENDING_LUMPED_ENDS  /* the same with halves at the two ends; n m            */
};

struct bending_def {
    int elements;
    double length;             /* [m]                                          */
    double EI;                 /* bending stiffness     [N m^2, 2D: N m]       */
    double mu;                 /* mass per length       [kg/m, 2D: kg/m^2]     */
    double alpha, beta;        /* D = alpha M + beta K + drag I  [1/s], [s]    */
    double drag;               /* of every node, (45) [N s/m; N m s for turns;
                                  2D: per metre of width]                      */
    enum bending_inertia inertia;
    enum bending_end root, tip;
};

enum { BENDING_WIDTH = 3 }; /* bandwidth of all matrices */

struct bending {
    struct bending_def def;
    int dofs;                                 /* 2 (elements + 1)              */
    double l;                                 /* length of an element [m]      */
    double fastest;                           /* largest frequency [rad/s], from above
                                                 by 1 % at most                */
    double decay;                             /* largest v . D v / v . M v [1/s], likewise */
    struct band *mass, *stiffness;            /* all degrees of freedom        */
    struct band *mass_free, *stiffness_free;  /* held ones taken out           */
    struct band_factor *mass_factor;          /* of mass_free                  */
    double *shift;                            /* [dofs] M 1, inertia against a shift of
                                                 the whole beam: times g it is weight */
};

struct bending_factor { /* M + gamma D + gamma^2 K of one gamma */
    bool set;
    double gamma;
    struct band_factor *factor;
};

enum { BENDING_FACTORS = 4 };

/* Scratch, and factorizations kept to save time: they change no result by a bit. */
struct bending_work {
    struct band *sum;
    struct bending_factor kept[BENDING_FACTORS];
    int oldest;                /* of kept: the next to go                      */
    struct band_factor *joint; /* see bending_join()                           */
    double *vector;            /* [2][dofs]                                    */
};

/* Each takes all memory it will ever need.  Free with bending_free(&b),
 * bending_work_free(&w). */
int bending_create(const struct bending_def *def, struct bending **out);
void bending_free(struct bending **b); /* NULL is welcome */
int bending_work_create(const struct bending *b, struct bending_work **out);
void bending_work_free(struct bending_work **w); /* NULL is welcome */

static inline bool bending_held(const struct bending *b, int dof)
{
    const int last = b->dofs - 2;

    if (dof >= 2 && dof < last)
        return false;
    const enum bending_end end = dof < 2 ? b->def.root : b->def.tip;
    return end == BENDING_CLAMPED || (end == BENDING_PINNED && dof % 2 == 0);
}

double bending_mass(const struct bending *b); /* of all nodes together [kg, 2D: kg/m] */

/* to [dofs] = K q + D v, rows of held degrees of freedom included. */
void bending_resist(const struct bending *b, struct bending_work *w, const double *q,
                    const double *v, double *to);

/* f [dofs]: forces come in, accelerations M^-1 f go out; held ones are 0. */
void bending_accelerate(const struct bending *b, double *f);

/* Solves z - gamma f_I(z) = r with f_I = (v, -M^-1 (K q + D v)): r comes in
 * through q and v, z goes out.  Held entries keep r. */
int bending_solve(const struct bending *b, struct bending_work *w, double gamma, double *q,
                  double *v);

/* The same with forces that are linear in v and not the beam's own: a solver of the
 * whole goes by (M + gamma D + gamma^2 K) v = right + gamma (those forces).
 * bending_inertia(): to = (M + gamma D + gamma^2 K) v, held entries v.
 * bending_right(): v, that comes in as r, becomes M r_v - gamma K r_q, held entries r_v. */
void bending_inertia(const struct bending *b, struct bending_work *w, double gamma,
                     const double *v, double *to);
void bending_right(const struct bending *b, struct bending_work *w, double gamma,
                   const double *q, double *v);

/* M + gamma D + gamma^2 K and what resists at points: bending_join(), then for each
 * point c times shape shape^T [4][4] at the degree of freedom `first`, then
 * bending_joined(), after which bending_join_solve() solves in place. */
void bending_join(const struct bending *b, struct bending_work *w, double gamma);
void bending_join_point(struct bending_work *w, int first, const double *shape, double c);
int bending_joined(const struct bending *b, struct bending_work *w);
void bending_join_solve(const struct bending_work *w, double *x);

/* f [dofs]: forces come in, (M + gamma D + gamma^2 K)^-1 f goes out; held ones are 0.
 * STATUS_FAILED: that matrix is not finite; never after it went well with this gamma. */
int bending_yield(const struct bending *b, struct bending_work *w, double gamma, double *f);

double bending_kinetic(const struct bending *b, const double *v); /* [J, 2D: J/m]        */
double bending_elastic(const struct bending *b, const double *q); /* [J, 2D: J/m]        */
double bending_damping(const struct bending *b, const double *v); /* power, <= 0 [W, ..] */

/* Frequency [rad/s] of the first mode that bends, from theory; ends may not
 * both be free. */
double bending_first(const struct bending_def *def);

/* The same [rad/s], or 0 if damping lets it creep back and not vibrate. */
double bending_swing(const struct bending_def *def);

#endif
