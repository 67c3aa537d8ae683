/* contacts.h -- what solids do to each other where they touch: a pass over all bodies and
 * walls, between move(), which places bodies, and load(), which takes what pushes them.
 *
 * What contacts remember is state, in rows of y of their own. */
#ifndef BODIES_CONTACTS_H
#define BODIES_CONTACTS_H

#include "bodies/bodies.h"
#include "bodies/solid.h"
#include "bodies/touch-materials.h"

enum { CONTACTS_COLUMNS = 4 }; /* of the book, at most                             */

struct shape;
struct contacts; /* what they know of the scene; const once their rows are known   */
struct contacts_work; /* what they work in                                          */

struct contacts_body { /* a body, where its skin stands, and what pushes it              */
    const struct body_kind *kind;
    const struct body *body;
    const char *path;         /* "body.NAME" or "beam.NAME"; for create()          */
    const char *where;        /* its file and line, or NULL; likewise              */
    int points;               /* of its skin; without one 0                        */
    const double (*x)[DIM];   /* [points] [m]                                      */
    const double (*u)[DIM];   /* [points] [m/s]                                    */
    double (*force)[DIM];     /* [points] by the fluid so far [N], to be added to  */
    struct solid_place at;    /* of a solid: set by meet() and limit()              */
    struct body_push push;    /* of a solid: set by meet(); else by_walls only, the part of
                                 force that walls give                             */
};

struct contacts_wall {
    const char *path;          /* "wall.NAME"                                      */
    const char *where;         /* its file and line, or NULL; for create()         */
    const struct shape *shape; /* at t = 0                                         */
    struct solid_place by;     /* it is carried along with, as solid_carry() says; for meet() */
};

enum contacts_law {
    CONTACTS_AS_OTHERS,     /* what other rules say; without one CONTACTS_SOFT     */
    CONTACTS_SOFT,          /* as deep as `softness` of the bodies says, (RT1)     */
    CONTACTS_HERTZ_MINDLIN  /* as hard as materials are, (RT8); 3D                 */
};

struct contacts_rule {             /* of a pair of solids, or of all of two kinds    */
    const char *name, *where;      /* contact.NAME; its file and line              */
    const char *of, *with;         /* paths, or "body", "beam", "wall", "side"     */
    double friction, restitution;  /* NaN: as both have it                         */
    enum contacts_law law;
    struct touch_material material[2]; /* of both, for CONTACTS_HERTZ_MINDLIN  */
};

struct contacts_scene {
    const struct scales *scales;
    int bodies, walls;
    const struct contacts_body *body; /* of these kind, body and points            */
    const struct contacts_wall *wall; /* of these all but `by`                */
    int rules;
    const struct contacts_rule *rule; /* [rules]                              */
};

struct contacts_moment {
    const struct layout *layout;
    double t;
    const double *y;
    struct contacts_body *body;       /* [bodies]                                  */
    struct contacts_wall *wall;       /* [walls]                                   */
    double *ydot;                     /* of meet() only                            */
    double *power; /* [columns] what they give to bodies [W]; likewise             */
    struct contacts_work *work;
    long *looked;  /* counts pairs that meet() looks at                            */
    double *deepest; /* the deepest overlap of solids that meet() has met so far [m] */
};

/* Of contacts whose rows serve few of many pairs at a time. */
struct body_seats {
    /* Between two steps: is it time to end a segment and to serve others? */
    bool (*lack)(const struct contacts *c, const struct contacts_moment *m);

    /* Does so, in y.  STATUS_FAILED, with the reason in text [room]: there are too few rows. */
    int (*settle)(const struct contacts *c, const struct contacts_moment *m, double *y, char *text,
                  size_t room);

    /* y, by id, without rows that serve none; how many numbers are left. */
    long (*tidy)(const struct contacts *c, const struct layout *l, double *y);
};

struct body_contacts {
    const char *about;
    const char *const *column; /* names of works of the book                       */
    int (*columns)(const struct contacts *c); /* how many of them this scene has */

    /* *out is NULL where nothing can touch.  BAD_SCENE: solids overlap at the start. */
    int (*create)(const struct contacts_scene *scene, struct contacts **out);
    void (*free)(struct contacts **contacts); /* a pointer to NULL is welcome       */

    /* Adds their rows, of class LAYOUT_OTHER, after those of bodies; y at t = 0.  NULL: they
     * have none. */
    int (*rows)(struct contacts *c, struct layout *l);
    void (*start)(const struct contacts *c, const struct layout *l, double *y);

    /* Memory for all below; NULL: they need none. */
    int (*work)(const struct contacts *c, struct contacts_work **out);
    void (*work_free)(struct contacts_work **work);

    const struct body_seats *seats; /* NULL: each pair has rows of its own             */

    /* Are body i and solid j, a body, or a wall from `bodies` on, kept apart? */
    bool (*parts)(const struct contacts *c, int i, int j);

    /* Adds forces to skins and sets the pushes of bodies, equal and opposite ones; sets the
     * rates of its rows, and power.  That is booked with velocities of y by all methods: by
     * those that step halves (struct ask, `ahead`) to the first order.  STATUS_FAILED, with
     * the reason in text [room]: no contact can part two as they stand. */
    int (*meet)(const struct contacts *c, const struct contacts_moment *m, char *text,
                size_t room);

    /* The fastest rate of meet() at (t, y), also of two that are about to touch; it names
     * them as `part`.  NULL: they never limit a step. */
    void (*limit)(const struct contacts *c, const struct contacts_moment *m, struct limit *out);
};

/* Of the scenes of this program; NULL: bodies do not meet. */
extern const struct body_contacts *const bodies_contacts;

#endif
