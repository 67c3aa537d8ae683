/* book.h -- mass, momentum and energy by name: quadratures that ride in y, what is stored at
 * a moment, and the identity that both must keep:
 *
 *   total - total(0) - sum of work = defect,  momentum - momentum(0) - given = defect
 *
 * What is left is the error of time integration. */
#ifndef BOOK_BOOK_H
#define BOOK_BOOK_H

#include "plan/inside.h"

enum { BOOK_WORKS = 557, BOOK_NAME = 80, /* works: of parts, walls, two of each body, contacts,
                                            looking ahead, corrections of a method */
       BOOK_COLUMNS = BOOK_WORKS + 10 + DIM };

/* --- rates of the quadratures ------------------------------------------------------ */

/* What happens at a moment. */
struct book_powers {
    const double *work;              /* [columns] power of each law           [W] */
    double walls;                    /* of the fluid on walls that move       [W] */
    const double *pull;              /* [DIM] of body forces beside the weight [N] */
    const double (*force)[DIM];      /* [objects][DIM] on solids              [N] */
    const struct moment_body *body;  /* [bodies]: their loads                     */
    const double *contacts;          /* [columns] power of contacts on bodies [W] */
    const double *dissipated;        /* [0 or 1] of a pressure that looks ahead [W] */
};

/* All quadratures' rates, book [n] = the book's row of ydot. */
void book_rates(const struct plan *p, const struct book_powers *of, double *book);

/* Adds `share` times what body i gets by this load. */
void book_add_load(const struct plan *p, int i, double share, const struct body_load *load,
                   double *book);

/* --- what is stored ---------------------------------------------------------------- */

struct book_sheet {
    double t;
    struct energies energy;
    double total;             /* sum of energies                     [J]      */
    int works;
    double work[BOOK_WORKS];  /* energy each part gave so far        [J]      */
    double pressure_defect;   /* by pressure and continuity together [J]      */
    double mass;              /* of the fluid                        [kg]     */
    double momentum[DIM];     /* of fluid and bodies                 [kg m/s] */
    double momentum_given[DIM]; /* by gravity, walls, supports, loads [N s]   */
    double defect;            /* of energy since the first sheet; whoever keeps that
                                 sets it                             [J]      */
};

/* Names of the works, in order; returns how many. */
int book_work_names(const struct plan *p, char (*name)[BOOK_NAME]);

/* Sums over particles have no order; where the view has some rows alone (view_has()) all ranks read it
 * together, and have the same.  The view is of y, at its t; the layout is that of y; bodies are those of a moment. */
void book_read(const struct plan *p, const struct layout *l, const struct moment_body *body,
               const struct view *v, const double *y, struct book_sheet *to);

/* What the book cannot explain since `first`: energy [J]; the largest component of
 * momentum [N s]. */
double book_defect(const struct book_sheet *first, const struct book_sheet *now);
double book_momentum_defect(const struct book_sheet *first, const struct book_sheet *now);

/* --- columns of book.csv ----------------------------------------------------------- */

struct book_column {
    char name[BOOK_NAME];
    const char *unit;   /* "J"; 2D: "J/m"                                     */
    size_t at;          /* offset of its double in struct book_sheet          */
};

/* All but t, in order; returns how many, at most BOOK_COLUMNS. */
int book_columns(const struct plan *plan, struct book_column *to);

static inline double book_value(const struct book_sheet *s, const struct book_column *c)
{
    return *(const double *)((const char *)s + c->at);
}

#endif
