/* passes.h -- what an evaluation is made of: passes that read fields and give fields.
 *
 * A pass says which fields it reads of its owners, which of their neighbours, and which it
 * gives.  The plan orders the passes once by that, and an evaluation runs those that it is
 * asked for, one after the other.  A field has one pass that provides it, unless y holds it;
 * others may add to it afterwards, before any pass reads it. */
#ifndef PLAN_PASSES_H
#define PLAN_PASSES_H

#include "plan/plan.h"
#include <stddef.h>

struct plan_field;
struct evaluation; /* eval/passes.h */

enum { /* fields, by bits; name, unit, width and kinds of each: passes-fields.c */
    PASS_POSITION = 1 << 0,
    PASS_VELOCITY = 1 << 1,
    PASS_MOTION = 1 << 2,          /* positions and velocities of solids          */
    PASS_PAIRS = 1 << 3,           /* which particles are near each other      */
    PASS_RECORDS = 1 << 4,         /* what a pair reads, in the order of the list */
    PASS_DENSITY = 1 << 5,
    PASS_SOLID_DENSITY = 1 << 6,
    PASS_PRESSURE = 1 << 7,
    PASS_SOLID_PRESSURE = 1 << 8,
    PASS_DRIFT = 1 << 9,           /* velocities that positions move with besides */
    PASS_PUSH = 1 << 10,           /* body forces, for powers that look ahead     */
    PASS_SLIP = 1 << 11,           /* of solids at whose faces the fluid sticks   */
    PASS_OTHERS = 1 << 12,         /* acceleration by all but the pressure        */
    PASS_FORCE = 1 << 13,          /* of pairs, on fluid and solids               */
    PASS_POWER = 1 << 14,          /* of each law                                 */
    PASS_DENSITY_RATE = 1 << 15,
    PASS_POSITION_RATE = 1 << 16,
    PASS_ACCELERATION = 1 << 17,
    PASS_SOLID_FORCE = 1 << 18,    /* of the fluid on each solid                  */
    PASS_SKIN_FORCE = 1 << 19,     /* on each point of a body                     */
    PASS_BODY_RATES = 1 << 20,
    PASS_BOOK = 1 << 21,
    PASS_HALF_BOOK = 1 << 22,      /* works of the laws of densities alone        */
    PASS_SOLID_PUSH = 1 << 23,     /* on each particle of solids                  */
    PASS_FIELDS = 24
};

enum { /* what an evaluation may be asked for: struct ask of eval/moment.h */
    PASS_FOR_FIELDS = 1 << 0,      /* no rates                                    */
    PASS_FOR_RATES = 1 << 1,       /* all of the sides asked for                  */
    PASS_FOR_APART = 1 << 2,       /* the same, with forces of the implicit side apart */
    PASS_FOR_OTHERS = 1 << 3,      /* all but the pressure                        */
    PASS_FOR_VELOCITIES = 1 << 4,  /* one half                                    */
    PASS_FOR_DENSITIES = 1 << 5,   /* the other                                   */
    PASS_FOR_IMPLICIT = 1 << 6,    /* forces of the law that is implicit          */
    PASS_QUESTIONS = 7
};

/* What a pass goes over; a sum is over pairs, once for each struct plan_field. */
enum pass_kind { PASS_POINTWISE, PASS_OVER_PAIRS, PASS_SOLVE, PASS_BODIES, PASS_EACH_SUM };

/* A line of the table. */
struct pass {
    const char *name;
    enum pass_kind kind;
    unsigned needs;        /* PASS_ bits that it reads of its owners                     */
    unsigned neighbours;   /* and of their neighbours: what a halo must carry            */
    unsigned provides;
    unsigned adds;         /* to what others provide                                     */
    unsigned asked;        /* PASS_FOR_ bits                                             */
    bool (*present)(const struct plan *plan); /* NULL: always                            */
    int (*run)(struct evaluation *e, const struct plan_field *of);
    bool (*all)(const struct plan *plan); /* does it read numbers of all particles, in an order
                              of theirs or as solves do?  NULL: no                       */
};

/* All that there are, ended by a line without name: eval/passes.c. */
extern const struct pass passes_table[];

/* A pass of a plan; bits are those of the table, and what this plan's parts say. */
struct plan_pass {
    const struct pass *pass;
    const char *name;              /* that of the table, or the path of a part    */
    const struct plan_field *of;   /* of PASS_EACH_SUM, else NULL                 */
    unsigned needs, neighbours, provides, adds;
};

/* Leaves out those of the n passes that no wanted field (bits) asks for and puts the others
 * in an order in which each finds what it reads; passes that need not wait stay in the order
 * that they came in.  Fields of `given` need no pass.  Returns how many are left, or -1: a
 * circle, or a field without or with two that provide it, which the failure names. */
int passes_order(struct plan_pass *pass, int n, unsigned given, unsigned wanted);

/* plan->passes of the lines of a table, when rows of y and summed fields are known. */
int passes_make(struct plan *plan, const struct pass *table);

/* "density, pressure": names of these fields (bits); of field i name, unit and numbers of
 * a particle, 0: not of particles; fields that are not of other kinds (bits) alone. */
void passes_names(unsigned fields, char *text, size_t room);
void passes_field(int i, const char **name, const char **unit, int *width);
unsigned passes_of_kinds(unsigned kinds);

#endif
