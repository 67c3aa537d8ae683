/* inside.h -- a moment as the rooms that evaluate see it. */
#ifndef EVAL_INSIDE_H
#define EVAL_INSIDE_H

#include "book/book.h"
#include "eval/moment.h"
#include "eval/observe.h"
#include "eval/wet.h"
#include "plan/inside.h"

struct face;
struct moment_given;
struct moment_share;

/* What an evaluation works in: read while it lasts.  A moment made beside another shares
 * that one's, as one evaluation is over before the next. */
struct workspace {
    double *record;  /* [places][RECORD], 64-byte aligned                     */
    size_t slots;    /* room for so many; with images it may grow, and from few where
                        there are many ranks                                  */
    double *f;       /* [slots][DIM] by place; of the fluid only what struct sum_rates
                        leaves there                                          */
    double *drho;    /* [slots] likewise                                      */
    double *power;   /* [columns], and what a pressure that looks ahead dissipates */
    double *rho;     /* [n] densities that fields or the pass of solids give, by row; NULL */
    double *p2;      /* [solids] p/rho^2 that they press with, by row; NULL   */
    double *mean;    /* [solids] densities before their one side, for a pressure that looks
                        ahead; NULL                                           */
    double *law;     /* [solids] p2 by the density alone; NULL likewise       */
    double *between; /* that of these two by which solids press each other     */
    double *pressed; /* [solids][DIM] for that, and for densities that a view shows; NULL */
    struct part_press_work *press; /* likewise                                  */
    int *rows;       /* [solids] of other solids near them; NULL              */
    struct {
        const struct list *list; /* whose records are all there, when it had been made so
                                    often; NULL: they are not                  */
        long builds;
        unsigned char *of;       /* blocks of places that are read, pack.c; room for more
                                    than there are                             */
    } busy;
    struct wet_solids wet;  /* solids that something meets, and forces on solids     */
    const struct list *narrowed; /* the list that `press` knows solids of, when it had been */
    long narrowed_builds;        /* made so often                              */
    double (*sum)[PART_SUMS]; /* [n] for a summed density, by place; NULL without */
    double (*drift)[DIM];     /* [fluid][DIM] beside velocities [m/s]; NULL   */
    double *sourced; /* [fluid] rates of density that no pair gives, for a pressure that
                        looks ahead; NULL                                     */
    double (*points)[DIM];    /* [points of any body][DIM] scratch            */
    double (*speeds)[DIM];    /* likewise                                     */
    double *rates;   /* [size] of an evaluation that is only looked at        */
    struct sum_scratch scratch;
};

/* What refusals, and looks for runaways, named last. */
enum moment_complaint { MOMENT_TOO_FAST, MOMENT_DENSITY_OUT, MOMENT_PLACE_LOST,
                        MOMENT_COMPLAINTS };
struct moment_culprit {
    bool known;
    int particle; /* id                                                         */
    double t;  /* [s]                                                        */
};

struct moment {
    const struct plan *plan;
    struct moment *beside;             /* the run's, whose work it shares; NULL: its own */
    struct moment *observer;           /* made at the first look              */
    struct layout layout;
    struct particles *particles;       /* solids stand where they are now     */
    struct list *list, *own;           /* of the evaluation; its own          */
    struct workspace *work;
    struct moment_body *body;          /* [bodies]                            */
    double (*force)[DIM];              /* [objects + panels][DIM] on solids, and on parts
                                          of them [N]                         */
    double (*turn)[3];                 /* [panels][3] moments of those; 2D: the last [N m] */
    double wall_power;                 /* v . f of moving walls [W]           */
    struct contacts_moment meeting;    /* body [bodies], wall [walls], power [columns] */
    double pull[DIM];                  /* of other body forces than the weight [N] */
    double density[2];                 /* bounds, beyond them it refuses      */
    void *solver;                      /* what plan->solver works in; of the run's */
    void *ahead;                       /* what implicit_ahead works in; of the run's; NULL */
    struct face *face;                 /* eval/face.h; NULL                   */
    struct moment_given *given;        /* eval/given.h; of the run's; NULL    */
    struct moment_share *share;        /* eval/share.h; of the run's; NULL: all rows are
                                          this rank's                         */
    bool (*quit)(void);                /* NULL: nothing ends it               */
    char refusal[600];
    struct moment_culprit culprit[MOMENT_COMPLAINTS];
    struct moment_counts counts;
};

/* Complaints belong to the run, whichever moment has them. */
static inline void moment_note(struct moment *m, enum moment_complaint what, int particle, double t)
{
    struct moment *run = m->beside ? m->beside : m;

    run->culprit[what] = (struct moment_culprit){ true, particle, t };
}

/* workspace.c: zeroed numbers on cache lines; the memory of an evaluation; after a rebuild
 * there may be more images. */
double *workspace_lines(size_t numbers);
int workspace_create(const struct plan *p, struct workspace **out);
void workspace_free(const struct plan *p, struct workspace **w);
int workspace_fit(struct workspace *w, const struct list *l);

/* Bytes of it that are written: records, sums, forces on solids; not `rates`, which are like y. */
double workspace_written(const struct plan *p, const struct workspace *w);

/* share-full.c: STATUS_DONE where all that share this moment bring that, for what one may lack. */
int moment_agree(const struct moment *m, int status);

/* own.c: rows of a kind, from the first on, that this rank gives the rates of: all on one rank, and
 * where rows stand by id. */
int moment_rows_of(const struct moment *m, enum kind k);

/* moment.c: another moment of the run's plan, for looking. */
int moment_create_beside(struct moment *run, struct moment **out);

/* touching.c: where bodies and walls are at (t, y), as contacts see them. */
struct contacts_moment touching_now(struct moment *m, double t, const double *y);

/* touching.c: load() of body i; what walls give to a skin that touches them is support, too. */
void touching_load(const struct moment *m, int i, double t, const double *y, double *ydot,
                   struct body_load *out);

/* rearrange.c: rows of a fresh moment become those of the run, for as long as that does not change them. */
void moment_follow(struct moment *m, const struct moment *run);

/* view.c: moves solids to (t, y) and says where everything is, but for densities
 * that are summed. */
void moment_view(struct moment *m, double t, const double *y, struct view *v);

/* Where the particle in row c (of all kinds) is in the domain: "(x, y)" in metres. */
void moment_place(const struct moment *m, const struct view *v, int c, char text[PLAN_PLACE]);

/* pack.c: records of these kinds (bits) in list order.  STATUS_FAILED: refused. */
int moment_pack(struct moment *m, const struct view *v, unsigned kinds);

/* pack.c: the record of a dummy, far outside of everything, and those of other numbers far
 * from one another, so that no pair of these is within the support of a kernel. */
void pack_far(const struct plan *p, int number, double *record);

/* press.c: densities that solids show which press by more than a density of their own, in v; their rows
 * there are those of y before.  Nothing where there are none. */
void moment_press(struct moment *m, struct view *v);

/* press.c: tells solids that press by more than a density of their own which ones the fluid meets. */
void press_narrow(struct moment *m);

/* press.c: adds the forces between solids that press by p2 [solids], by row, to those on rows in
 * work, after wet_take(). */
void press_between(struct moment *m, const double *p2);

/* spread.c: where sums over pairs write rates of the fluid at once; there, those of particles
 * outside are 0; its velocities' rates, and the forces of pairs brought there. */
struct sum_rates spread_places(const struct moment *m, const struct ask *ask, double *ydot);
void spread_stop(const struct moment *m, struct sum_rates to);
double (*spread_velocities(const struct moment *m, double *ydot))[DIM];
void spread_accelerations(const struct moment *m, double *ydot);

/* spread.c: what one thread of its region brings from places, and x' = u. */
void spread_part(const struct moment *m, const struct ask *ask, const struct view *v, double *ydot);

/* solids.c: force on each solid by those on rows, and the power of driven walls; forces on the
 * points of one skin.  After wet_take(). */
void solids_sum(struct moment *m);
void solids_skin(const struct moment *m, struct moment_body *b);

/* Adds the moment of a force f at x about a point; in 2D it has its last component alone. */
void solids_turn(const double *about, const double *x, const double *f, double turn[3]);

/* Sums over pairs by these laws.  push: see struct sum_job; it is added to.  apart: see
 * struct ask; forces of the implicit law by place. */
struct rates_job {
    const struct pairs_table *table;
    double ahead;         /* see struct ask */
    double (*push)[DIM];
    struct sum_rates to;
    double *apart;
};

/* rates.c: the explicit side, or what of it was asked for; of the implicit side, laws of
 * pairs but not the stiff side of bodies, and of it alone (then ydot is not touched) their
 * forces and power in the moment.  apart: forces of the implicit law by place, with their
 * power in *power; NULL. */
int rates_eval(struct moment *m, const struct ask *ask, double t, const double *y, double *ydot,
               double *apart, double *power);

/* rates.c: list, records and densities at (t, y), in m and in v.  STATUS_FAILED: refused. */
int rates_fields(struct moment *m, double t, const double *y, struct view *v);

#endif
