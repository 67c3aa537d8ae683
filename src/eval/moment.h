/* moment.h -- a plan at one (t, y): what is evaluated there, and what that leaves behind.
 *
 * A plan says what there is and never changes; a moment holds where everything stands, the
 * list of pairs, summed densities, forces and the book of one evaluation, with the counters and the
 * complaints of the run that it belongs to.  A run has one.  Outputs look through another,
 * made beside it (eval/observe.h), so that looking disturbs nothing.
 *
 * This header knows no dimension: time/ sees only this and plan.h. */
#ifndef EVAL_MOMENT_H
#define EVAL_MOMENT_H

#include "algebra/vector.h"
#include "base/archive.h"
#include "plan/plan.h"

struct moment;

enum { /* sides of f */
    ASK_EXPLICIT = 1 << 0, /* everything but the implicit side                 */
    ASK_IMPLICIT = 1 << 1  /* the stiff side of bodies, and a viscosity whose key
                              `side` says so; rows of others are 0             */
};

enum { /* rates of the explicit side */
    ASK_POSITIONS = 1 << 0,
    ASK_VELOCITIES = 1 << 1, /* and forces on solids                           */
    ASK_DENSITIES = 1 << 2
};

/* What an evaluation is asked for. */
struct ask {
    unsigned sides;       /* added up, unless `apart` takes the implicit one      */
    unsigned rates;       /* 0: of everything.  ASK_VELOCITIES or ASK_DENSITIES: one half
                             of the explicit side, a pass over pairs each; rows of others,
                             positions among them, are 0; see plan_halves()       */
    bool without_pressure; /* laws that read no pressure, and what is not pairs': for a
                             pressure that is solved for                          */
    double ahead;         /* powers are booked with the velocities of the fluid (half:
                             velocities) or the pressures (half: densities) that the rates
                             lead to in this time; with half of h, the book gets the very
                             work of a kick v += h A [s]                          */
    double *apart;        /* [size] the implicit side, for both at once; with an implicit
                             viscosity that is one pass over pairs instead of two; or NULL */
};

/* The usual ones. */
#define ASK_ALL ((struct ask){ .sides = ASK_EXPLICIT | ASK_IMPLICIT })
#define ASK_EXPLICIT_SIDE ((struct ask){ .sides = ASK_EXPLICIT })
#define ASK_IMPLICIT_SIDE ((struct ask){ .sides = ASK_IMPLICIT })
#define ASK_HALF(RATES, AHEAD)                                                           \
    ((struct ask){ .sides = ASK_EXPLICIT, .rates = (RATES), .ahead = (AHEAD) })

/* How many rows of y and of its rates a rank has. */
enum moment_rows {
    MOMENT_OWN,  /* its own of both, before those of others, which are 0 */
    MOMENT_RATES, /* its own of rates alone; all of y, rows are ids      */
    MOMENT_ALL   /* all of both, rows are ids                            */
};

/* On many ranks: each becomes the owner of a part of the particles, cut where they are at y,
 * which all ranks have alike; on one rank nothing happens.  From now on all ranks evaluate
 * together.  Where the plan wants it, each has all rows.  With MOMENT_OWN rows of y change places.
 * STATUS_FAILED, on all. */
int moment_share(struct moment *moment, double *y, enum moment_rows rows);

/* Each has all particles for itself again; not after MOMENT_OWN. */
void moment_unshare(struct moment *moment);

/* What this rank has of vectors of the size of y; lent until the next call. */
struct vector_own moment_own(const struct moment *moment);

/* `to` becomes y in what this rank has; or the sum of terms c x, by vector_combine(). */
void moment_take(const struct moment *moment, const double *y, double *to);
void moment_combine(const struct moment *moment, int terms, const double *c, const double *const *x,
                    double *to);

/* Of numbers from..to-1, those that this rank has become 0. */
void moment_clear(const struct moment *moment, long from, long to, double *y);

/* Rows of a kind of this rank's alone?  Numbers of y that a rank has. */
bool moment_is_packed(const struct moment *moment);
double moment_numbers(const struct moment *moment);

/* Is each rank given the rates of all rows?  Bytes of what a moment is shared with; 0 on one rank. */
bool moment_is_full(const struct moment *moment);
double moment_share_bytes(const struct moment *moment);

/* The same if each had all rows, as while fluid is let go. */
double moment_share_bytes_all(const struct moment *moment);

/* Bytes that are written of its list, which stands, and of sums over its pairs. */
double moment_list_bytes(const struct moment *moment);
double moment_sums_bytes(const struct moment *moment);

/* Fluid of other ranks that is near own particles: rows that the list has. */
int moment_nears(const struct moment *moment);

/* Numbers that passes declare to read of neighbours (house.md), of this rank's rows that go to others in
 * a right-hand side; 0 where all rows are known to all. */
double moment_share_read(const struct moment *moment);

/* Each x[i] becomes the largest of all ranks that have own rows of y (MOMENT_OWN), which ask together;
 * else it stays.  None is NaN. */
void moment_most(const struct moment *moment, int n, double *x);

/* y with the rows of all ranks: y itself where there is one, else lent until the next call.  All
 * ranks ask together. */
const double *moment_whole(struct moment *moment, const double *y);

/* The same on the first rank, for what it alone writes; on others y itself. */
const double *moment_first(struct moment *moment, const double *y);

/* Takes all memory that a run's evaluations need; the plan must outlive it. */
int moment_create(const struct plan *plan, struct moment **out);
void moment_free(struct moment **moment); /* NULL is welcome */

/* A checkpoint: forgets all that is no function of (t, y), so that what follows has the bits
 * of a new moment's.  The list of pairs is made at the next evaluation, guesses of solves are
 * gone, the observer is as before its first look.  What a run has counted stays. */
void moment_restart(struct moment *moment);

/* The same by a new moment in its place, so that arrays which are written in part from now on take
 * memory for that part alone.  STATUS_FAILED: there is none, *moment is NULL. */
int moment_renew(struct moment **moment);

/* From now on an evaluation that begins when quit() says so has no answer. */
void moment_quit(struct moment *moment, bool (*quit)(void));

const struct plan *moment_plan(const struct moment *moment);

/* Sizes belong to the segment that the moment is in. */
long moment_size(const struct moment *moment);                   /* entries of y */
const struct layout *moment_layout(const struct moment *moment); /* lent         */

/* Those of plan_stiff_ranges(): all other entries have f_I = 0. */
int moment_stiff_ranges(const struct moment *moment, int most, long (*range)[2]);

/* Error weights for a tolerance, constant during a segment, of what this rank has. */
void moment_weights(const struct moment *moment, double tol, double *weight);

/* "velocity of fluid.water particle 17" for entry i of y; static buffer. */
const char *moment_entry(const struct moment *moment, long i);

/* The id, of its kind, of the particle number `which` in a row of the layout; of what is no
 * particle, `which`. */
int moment_id(const struct moment *moment, int row, int which);

/* y as it would be if rows were ids; `to` is not y. */
void moment_by_id(const struct moment *moment, const double *y, double *to);

/* ydot [size] = what was asked for of f(t, y).  0, or STATUS_FAILED when it cannot
 * answer (density out of bounds, a position not finite): then moment_refusal() says
 * particle, part and value, and ydot is not to be used.  Allocates nothing between
 * list rebuilds; f does not depend on history but for the last bits (the order of
 * sums follows the last rebuild). */
int moment_eval(struct moment *moment, struct ask ask, double t, const double *y, double *ydot);
const char *moment_refusal(const struct moment *moment);

/* What happens to y at a time of plan_event(), between two segments: filters of densities
 * replace them and book the energy that this takes.  STATUS_FAILED: there is no right-hand side. */
int moment_event(struct moment *moment, double t, double *y);

/* Is a pair of bodies near that has no place for what its contact remembers?  Then the segment ends,
 * and moment_settle() gives it one, in y.  STATUS_FAILED: there are too few. */
bool moment_lacks(struct moment *moment, double t, const double *y);
int moment_settle(struct moment *moment, double t, double *y);

/* y [size], by id, without places for contacts that serve none, and how many numbers are left: for a
 * hash that does not tell how many places there are. */
long moment_tidy(const struct moment *moment, double *y);

/* Finds z with z - gamma f_I(t, z) = r in the stiff ranges (z comes in as a guess);
 * other entries are not touched.  STATUS_FAILED: without a failure kept, a refusal as
 * that of moment_eval() -- try a shorter step -- else the failure. */
int moment_solve(struct moment *moment, double t, double gamma, const double *r, double *z);

/* The error, in units of scales, that a step may have: a solve with an implicit viscosity
 * is exact to a small part of it (until this is called: of the scene's tol). */
void moment_solve_tolerance(struct moment *moment, double tol);

/* Largest explicit step the physics allows: rates of waves and of decay [1/s],
 * with part and particle.  All ranks ask together.  `stiff` says whether the implicit side is taken
 * explicitly too and so limits as well.  limit[0] is for waves, [1] for decay. */
void moment_limit(struct moment *moment, double t, const double *y, bool stiff,
                  struct limit limit[2]);

/* --- rigid bodies in steps of their own ---------------------------------------------- */

/* NULL, or why the plan's bodies have no side of f by themselves, without the fluid's forces. */
const char *moment_rigid_lacks(const struct plan *plan);

/* Entries of y that this side moves: those of bodies, of what contacts remember, and the book;
 * y[range[k][0]] up to y[range[k][1]].  Returns how many, at most `most`. */
int moment_rigid_ranges(const struct moment *moment, int most, long (*range)[2]);

/* That side at (t, y), set in these entries of ydot, others untouched: contacts, weight, joints,
 * springs, and what they book (RT7).  Of y it reads these entries alone.  STATUS_FAILED: no contact
 * can part two as they stand; see moment_refusal(). */
int moment_rigid(struct moment *moment, double t, const double *y, double *ydot);

/* moment_limit() of this side alone, of the same entries of y; and of all else. */
void moment_rigid_limit(struct moment *moment, double t, const double *y, struct limit limit[2]);
void moment_fluid_limit(struct moment *moment, double t, const double *y, struct limit limit[2]);

/* Of contacts alone, for methods that know no bound of stability: a step much longer than 1/rate
 * goes past a contact, and neither errors nor books see what it missed.  Rate 0: nothing is near. */
void moment_contact_limit(struct moment *moment, double t, const double *y, struct limit *out);

/* Of bodies with an implicit side: the highest frequency of a first mode that is not above
 * `most` [rad/s], with the body's name; rate 0: there is none. */
void moment_swing(const struct moment *moment, double most, struct limit *out);

/* For methods that move bodies by other stages than those at which they ask for
 * right-hand sides.  Adds to ydot, the book alone, `share` times what bodies get there at
 * (t, y) under the forces of the last right-hand side: impulse of supports and of
 * prescribed loads, energy that damping takes and loads give.  A right-hand side of the
 * same y has booked the same with share 1. */
void moment_body_book(struct moment *moment, double t, const double *y, double share,
                      double *ydot);

/* How many right-hand sides have been asked for, by side (two halves are one),
 * passes over all pairs for them and for solves, products of the implicit viscosity's
 * matrix, and list rebuilds. */
struct moment_counts {
    long rhs_explicit, rhs_implicit /* with moment_rigid() */, passes, solves, products, rebuilds, refused;
    long settled, looked; /* ends of segments for seats of contacts; pairs of solids looked at */
    double deepest;       /* overlap of solids that a right-hand side met [m]      */
    long iterations;      /* for pressures solved step by step                    */
    double compression;   /* the largest that a step has left, of the rest density */
    double gain;          /* what an iteration corrects, of what it should        */
};
const struct moment_counts *moment_counts(const struct moment *moment);

/* Is there an answer at (t, y)?  Asked of a fresh moment, as moment_eval().  If there is one, what it made
 * stands until moment_tried(): then the moment is fresh again, its counters too. */
struct moment_trial {
    struct moment_counts counts;
    long builds;
};
int moment_try(struct moment *moment, double t, const double *y, struct moment_trial *was);
void moment_tried(struct moment *moment, const struct moment_trial *was);

/* These counts, to a checkpoint and back. */
int moment_keep(struct moment *moment, struct archive *a);

/* Entries in the rows of its pair list; 0: it has none yet. */
double moment_pairs(const struct moment *moment);

#endif
