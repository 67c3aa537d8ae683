/* arkode.h -- what the files of the ARKStep methods share.
 *
 * SUNDIALS' ARKStep takes the steps; ours are the tables, the controller, the
 * norm, the stability bound, the implicit solve and the dense output.  Explicit
 * methods always go through ARKStep too: ERKStep of 6.4.1 loses order for tables
 * whose last stage stands at the end of the step but is not its result. */
#ifndef TIME_ARKODE_H
#define TIME_ARKODE_H

#include "algebra/vector.h"
#include "state/limit.h"
#include "time/choice.h"
#include "time/control.h"
#include "time/method.h"
#include "time/tableau.h"

/* One method: `method` comes first, so that its create() finds the row. */
struct arkode_row {
    struct method method;
    const char *erk, *dirk;            /* SUNDIALS' names; dirk alone: see tables */
    const struct tableau *own, *own_dirk; /* instead of erk and dirk           */
    int order;                         /* that the tables must have            */
    const struct control_row *control;
};

/* Each is listed in method.c. */
extern const struct arkode_row arkode_imex3, arkode_imex4, arkode_imex5,
    arkode_ark436, arkode_cks43, arkode_opt53,
    arkode_opt64, arkode_bs54, arkode_imex2, arkode_erk2,
    arkode_erk3, arkode_erk4, arkode_erk5, arkode_erk6,
    arkode_dirk2, arkode_dirk3, arkode_dirk4, arkode_dirk5,
    arkode_heun_euler_2_1_2, arkode_bogacki_shampine_4_2_3, arkode_ark324l2sa_erk_4_2_3,
    arkode_zonneveld_5_3_4, arkode_ark436l2sa_erk_6_3_4, arkode_ark437l2sa_erk_7_3_4,
    arkode_sayfy_aburub_6_3_4, arkode_cash_karp_6_4_5, arkode_fehlberg_6_4_5,
    arkode_dormand_prince_7_4_5, arkode_ark548l2sa_erk_8_4_5, arkode_ark548l2sab_erk_8_4_5,
    arkode_verner_8_5_6, arkode_fehlberg_13_7_8;

enum {
    ARKODE_NODES = 3,   /* ends of steps kept for dense output                 */
    ARKODE_PAST = 4,    /* the same for the stiff entries                      */
    ARKODE_RANGES = 64  /* ranges of stiff entries                             */
};

struct arkode {
    const struct arkode_row *row;
    struct method_def def;
    const struct plan *plan;
    struct moment *moment;
    long n;                      /* entries of y                               */
    bool imex;                   /* the stiff side is taken implicitly         */
    char tables[96];             /* their names, for run.json                  */
    struct tableau table;        /* the explicit one                           */
    struct {
        double wave, decay;      /* stability factors of that table            */
        double swing;            /* of the implicit one, see stability_swing() */
        double h;                /* largest stable step [s]                    */
        struct limit limit;      /* what bounds it                             */
    } stable;

    SUNContext context;
    void *ark;
    SUNNonlinearSolver solver;
    bool launched;               /* ARKStep stands at node[0]                  */

    struct {
        double *weight;          /* [n]                                        */
        N_Vector weighted;       /* vector that holds them already             */
        bool accepted;           /* by the last test                           */
    } error;                     /* tests                                      */
    struct control control;
    struct choice choice[2]; /* for the step to come, for the last one  */
    double natural;              /* last step that no t_stop cut short, or the pace of a
                                    segment before; 0: neither [s]             */
    long rejected;
    char refusal[320];            /* of f since the last error test             */

    struct arkode_node {
        double t;
        N_Vector y;
        N_Vector f;              /* explicit side of f(t, y)                   */
        bool has_f;
    } node[ARKODE_NODES];        /* [0] is the newest                          */
    int nodes, known;            /* as many as there is room for; as are filled */

    int stage;                   /* right-hand sides of this attempt so far    */
    struct {
        double t;
        N_Vector y, f;           /* NULL without first-same-as-last            */
        bool known;
    } last;                      /* stage                                      */

    struct {
        int ranges;              /* of its entries                             */
        long range[ARKODE_RANGES][2];
        long entries;            /* how many they hold                         */
        N_Vector start;          /* implicit side of f at node[0], which comes with
                                    the explicit one if a viscosity is in it; NULL */
        bool has_start;
        N_Vector right;          /* of the solve                               */
        double *z;               /* [n] of which the solve touches the ranges  */
        N_Vector correction;     /* of the last stage, lent by ARKStep         */
        double *past[ARKODE_PAST]; /* [entries] at ends of steps, newest first */
        double past_t[ARKODE_PAST];
        int pasts;
    } stiff;                     /* side of the plan                           */
};

/* arkode-create.c */
int arkode_create(const struct method *m, const struct method_def *def, struct moment *moment,
                  double t, const double *y, void **out);
void arkode_free(void **out);

/* arkode-tables.c: sets both tables and what follows from them; false when there
 * is none with the order that the row claims and an error estimate. */
bool arkode_tables_set(struct arkode *a);
bool arkode_tables_implicit(const struct arkode_row *row); /* has it an implicit one? */
int arkode_tables_stages(const struct arkode_row *row);
void arkode_tables_read(const ARKodeButcherTable from, struct tableau *t);

/* arkode-vectors.c */
int arkode_take_vectors(struct arkode *a);
int arkode_take_last(struct arkode *a); /* stage, of tables with first same as last */
void arkode_free_vectors(struct arkode *a);
int arkode_vectors(const struct method *m, const struct plan *plan);
int arkode_rearrange(void *self, int blocks, const struct vector_rows *block);

/* arkode-rates.c: f for ARKStep, with what is known already not asked again. */
int arkode_explicit(sunrealtype t, N_Vector y, N_Vector ydot, void *self);
int arkode_implicit(sunrealtype t, N_Vector y, N_Vector ydot, void *self);
int arkode_rates(struct arkode *a);         /* fills node[0].f; 0 or a refusal */
void arkode_reuse_last_stage(struct arkode *a);
SUNNonlinearSolver arkode_solver(struct arkode *a);

/* arkode-length.c: how long a step may be, and why. */
int arkode_adapt(N_Vector y, sunrealtype t, sunrealtype h1, sunrealtype h2, sunrealtype h3,
                 sunrealtype e1, sunrealtype e2, sunrealtype e3, int q, int p, sunrealtype *next,
                 void *self);
int arkode_stable(N_Vector y, sunrealtype t, sunrealtype *h, void *self);
double arkode_bound(struct arkode *a, double t, const double *y);   /* of stability */
int arkode_first(struct arkode *a, double t_stop, double *h);
int arkode_stretch(struct arkode *a, double t_stop); /* a constant step; 0 if it may be */
int arkode_constant_failed(struct arkode *a); /* STATUS_FAILED, with the bound it broke */

/* arkode-dense.c */
void arkode_remember(struct arkode *a); /* node[0] into the past of stiff entries */
int arkode_at(void *self, double t, double *y);

/* arkode.c */
int arkode_step(void *self, double t_stop, struct method_step *out);
int arkode_restart(void *self, double t, const double *y, const struct method_pace *pace);

#endif
