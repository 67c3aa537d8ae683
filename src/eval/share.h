/* share.h -- a moment whose particles are shared between ranks.
 *
 * All ranks hold y and the particles in full, but each answers for its own rows: it owns them,
 * finds their neighbours and gives their rates; in rates, rows of others are 0.  What pairs
 * read of neighbours that others own comes with each evaluation (the halo), and so do densities that
 * solids press by, unless these may be any solids'; forces on solids go from all to all.  The list of
 * pairs has own rows and those near them in the
 * order that they have on one rank, and is made anew when it is there, so no sum changes a bit.
 *
 * Where something wants numbers of all particles (`full`), all ranks have the whole of y and of
 * its rates, share sums over pairs alone, and each does all else for itself: those sums come from
 * all to all as soon as they are there (share-full.c).
 *
 * A moment for looking is lent the share of the run where own rows are packed (share-beside.c).  Else it
 * has none, and looks at a y that is whole (moment_whole()). */
#ifndef EVAL_SHARE_H
#define EVAL_SHARE_H

#include "eval/balance.h"
#include "eval/passes.h"
#include "space/drift.h"
#include "space/list.h"

struct balance_move;
struct ranks_route;

struct sum_job;

enum {
    SHARE_HALO = 2 * DIM + 1, /* numbers of fluid: place, velocity, density; of solids a density */
    SHARE_WIDEST = SHARE_HALO /* of a row of any message                       */
};

/* What a rank finds where it compares displacements (space/drift.h). */
struct share_drift {
    enum drift_harm harm;
    double pairs;          /* that it looked at                                */
};

struct moment_share {
    int ranks, me, n;      /* n: particles                                     */
    bool *mine;            /* [n] by row                                       */
    int *owner;            /* [n] rank, by id                                  */
    int *row;              /* [n] by rank, of one by id                        */
    int (*from)[KINDS + 1]; /* [ranks] of rank r and kind k: row[from[r][k]] ..
                              row[from[r][k + 1] - 1]                          */
    int *count;            /* [ranks] scratch                                  */
    struct {
        double *x, *u, *rho; /* [fluid][DIM] [fluid][DIM] [n]                  */
    } now;                 /* the halo now, of others some time ago; own rows where they are
                              not packed, and solids; own places when lists are made or judged */
    double *built;         /* [n][DIM] where the list was made, of those it has: share_was() */
    struct ranks_route *route; /* of own rows to others; NULL                  */
    struct share_halo {
        int n, *row;       /* [n] that come, by owner                          */
        double *in;        /* [numbers that come]                              */
        int leaves, *out;  /* [leaves] own ones that leave, by who asked       */
        double *sent;      /* [numbers that leave]                             */
        double leaving;    /* numbers that passes read of rows that leave, by the plan */
        bool any;          /* passes may read densities of any solid           */
        bool goes;         /* it has been sent for this right-hand side        */
    } halo;
    struct {
        int *row, *from;   /* [from[ranks]] solids with neighbours in the list, those of
                              rank r row[from[r]] ..                           */
        bool pressed;      /* solids that press have been told which ones are own */
    } wet;
    double *pack, *all;    /* [n][SHARE_HALO] and powers of each rank: scratch */
    double *whole;         /* [size] y of all                                  */
    struct exact_sum *power; /* [slots] this rank's part                       */
    bool packed;           /* own rows stand before others, own.c              */
    struct {
        long piece[LAYOUT_ROWS][2]; /* of y                                    */
        bool joins;
    } here;                /* then                                             */
    bool full;             /* all rows of y and of rates are here: of the members below and
                              above, then, are there mine .. count, built, pack and all   */
    struct {
        int *place;        /* [n] by rank, kind and place: of rank r and kind k those in the list, from
                              from[r][k] on                                    */
        int (*n)[KINDS];   /* [ranks] so many                                  */
        long builds;       /* of the list when they were sorted                */
    } places;              /* then                                             */
    struct {
        bool refuses;      /* some rank has a density out of bounds            */
        bool apart;        /* ranks are not at one time: refused, in the moment's words */
        double brings, wish; /* what this rank brings with each, the largest of all */
    } heard;               /* of all, by the last right-hand side              */
    struct {
        struct ranks_route *route; /* of own fluid to ranks that it is near to; NULL: no list yet */
        int leaves, *out;  /* [leaves] rows that take it, as they are packed   */
        int n, *row;       /* [n] rows that come                               */
        struct list_whole whole;
        int seen_n, *seen; /* [seen_n] rows whose places came at the last look: now.x */
        double *aside;     /* [n][DIM] the same as `built`, of a list for a look */
        bool looked, made_aside; /* since the last restart; is that one there?  */
        bool far;          /* since the list was made a rank has seen one that moved */
        bool listed;       /* the list has all own rows that may move          */
        struct share_drift drift; /* of the last time                          */
    } near;                /* what the list has, where own rows are packed     */
    struct balance balance; /* of work, so far                                 */
    struct balance_move *move; /* a new cut, while it is carried out; NULL     */
};

/* share-own.c: what is seen of own rows before others are heard.  What is seen is added. */
struct share_seen {
    bool moved;   /* further than half the margin                                */
    bool back;    /* was left out, and is inside again; or there is no list yet  */
    bool refuses; /* a density in y is out of bounds: all have to know before they sum */
    int bad;      /* smallest id of those that are nowhere, n: none              */
};
void share_see_places(const struct moment *m, const struct view *v, struct share_seen *l);

/* Densities; and what is not read where y has it goes to where those of others will be, `now`. */
void share_see_densities(const struct moment *m, const struct view *v, struct share_seen *l);

/* Does the list have all own rows that may move? */
bool share_listed(const struct moment *m);

/* share-make.c */
void share_free(struct moment_share **share); /* NULL is welcome */

/* own.c: do own rows of this kind stand before those of others? */
bool own_packs(const struct moment *m, int k);

/* Rows of such kinds, in the order of owners by id [n], at first in order of ids; with
 * y. */
int own_divide(struct moment *m, const int *owner, double *y);

/* The same of kind k later: row i becomes what row from[i] was, and as few as can be move.  Returns
 * how many are this rank's. */
int own_exchange(const struct moment *m, int k, const int *owner, int *from);

/* share.c */

/* From now on the particle with id i belongs to rank owner[i] [n]. */
void share_own(const struct moment *m, const int *owner);

/* Numbers of a row of this kind as it travels. */
static inline int share_width(int kind)
{
    return kind == KIND_FLUID ? SHARE_HALO : 1;
}

/* Rows of a kind, c numbers each, of their owners to all; `from` and `to` may be the same. */
void share_gather(struct moment_share *s, const struct particles *p, enum kind k, size_t c,
                  const double *from, double *to);

/* press.c: the same of own solids, in a view of own rows, all ranks together. */
void press_together(struct moment *m, struct view *v);

/* balance-where.c: space cut anew, by places where the list was made.  Each rank brings its own particles
 * with their rows, [particles] to be 0 before, and spreads over these what its groups take that are its
 * own in part only; all hear whose each particle is then, owner [particles] by id, and how many that
 * moves.  On all ranks the first failure. */
int balance_where(const struct moment *m, double *rows, int *owner, long *moved);

/* share-beside.c */

/* A moment for looking finds forces at (t, y), of own rows, on all ranks together where own rows are packed.
 * What the run has is the same afterwards.  On all ranks the first failure. */
int share_look(struct moment *m, double t, const double *y);

/* share.c */

/* Do particles of this kind never move? */
static inline bool share_stands(const struct moment *m, int k)
{
    return m->own->def.still & KIND_BIT(k);
}

/* Where rows of this kind were when the list was made, [count of kind][DIM]: of fluid those that the
 * list has.  Kinds that never move are where they were. */
static inline const double *share_was(const struct moment *m, int k)
{
    const size_t first = (size_t)m->particles->from[k];

    return share_stands(m, k) ? m->particles->x[first] : m->share->built + first * DIM;
}

/* The same of all kinds. */
void share_cloud(const struct moment *m, struct cloud *cloud);

/* Notes other places in `built`, while those of the run's list are set aside; and back. */
void share_set_aside(struct moment_share *s);

/* Makes another list, of a moment for looking, what the run's would be on one rank. */
int share_remake(const struct moment *run, struct list *list);

/* share-near.c */

/* Before a list is made of own rows at cloud: what it has of others, their places in x, which cloud has.
 * On all ranks the first failure. */
int share_near(struct moment *m, const struct cloud *cloud, double *x);

/* Own rows stand at x [own fluid][DIM] now: to now.x, for lists are made of one array.  Where own rows
 * are packed. */
void share_place(const struct moment *m, const double *x);

/* The same, and places now of rows that are near; notes which these are. */
void share_see_near(struct moment *m, const double *x);

/* Compares displacements, after places of others have come, to now.x. */
struct share_drift share_drift(struct moment *m, const struct cloud *cloud);

/* Some particle has moved further than half the margin: would one rank make the list anew? */
bool share_harms(struct moment *m, const struct cloud *cloud);

/* Of the last share_drift(), of which no rank looked at more pairs than this: are they more than patience
 * allows, all together? */
bool share_is_tired(struct moment *m, double most);

/* share-list.c */

/* A list anew at these places, of which others' come to x. */
int share_make(struct moment *m, const struct cloud *cloud, double *x);

/* The list of pairs, and a view with what the rows of it need. */
int share_list(struct evaluation *e, struct cloud *cloud);

/* The same for a look: where the list does not fit, another is made aside. */
int share_list_beside(struct evaluation *e, struct cloud *cloud);

/* share-hear.c */

/* The halo goes, if there is a list; and has come. */
void share_halo_begin(struct moment *m, const struct view *v);
void share_halo_end(struct moment_share *s);

/* What neighbours have, now that there is a list: to `now`. */
void share_hear(struct moment *m, const struct view *v);

/* share-halo.c */

/* Do numbers of this kind come from those ranks that have them in y?  Else all have all: where solids
 * press by more than a density of their own, they may read that of any. */
bool share_comes(const struct moment *m, int kind);

/* Numbers that the plan's passes read of a neighbour of this kind and that come from its owner. */
int share_reads(const struct moment *m, int kind);

/* What rows of the list need of other ranks, after it was made with this status here: on all ranks
 * the first that is none.  Settles how unequal work is, too.  From then on drift_near_group() tells which
 * groups can have neighbours that others own. */
int share_halo(struct moment *m, int status);
void share_free_halo(struct share_halo *halo);

/* share-solids.c */

/* Ids of own solids that have a neighbour in the list; how many. */
int share_wet(struct moment *m, int *id);

/* All hear of those of all ranks, count [ranks], and send the forces of these alone from now on. */
void share_hear_wet(struct moment *m, const int *count, const int *id);

/* Where laws leave this rank's part of the powers; NULL: they are to add up those of all at once,
 * as powers are read before forces on solids are heard, or these are not asked for. */
struct exact_sum *share_parts(const struct evaluation *e);

/* Forces of pairs on solids, of all ranks, on their rows, and with them powers, if parts of these
 * were left. */
void share_forces(struct evaluation *e);

/* share.c */

/* All ranks refuse a density that one refuses: the first in the order of the list.  Where none has
 * one out of bounds in y, nothing is asked: densities that y does not have are the same on all. */
int share_agree(struct moment *m, int status);

/* share-looks.c */

/* Limits [n] that parts have found in own rows become those of all rows. */
void share_limits(const struct moment *m, int n, struct limit *limit);

/* share-full.c */

/* A function of struct list: sums of all ranks, by place, to the moment `others`. */
void share_complete(void *others, unsigned kinds, int width, double *to);

/* What laws gave, likewise, in one message. */
void share_laws(struct moment *m, const struct sum_job *job);

/* Rates of rows of other ranks are 0. */
void share_silence(const struct moment *m, double *ydot);

#endif
