/* input.h -- a scene's values, read and checked one by one; nothing built yet. */
#ifndef PLAN_INPUT_H
#define PLAN_INPUT_H

#include "bodies/bodies.h"
#include "plan/engine.h"
#include "plan/settings-contact.h"
#include "plan/settings-mps.h"
#include "plan/settings.h"
#include "fill/flow.h"
#include "state/motion.h"

struct scene;
struct scene_node;

struct input_fluid {
    char name[64], where[256];
    struct settings_fluid set;
    struct flow flow;
};

struct input_wall {
    char name[64], path[80], where[256];
    struct settings_wall set;
    struct motion motion;
};

struct input_body {
    char name[64], path[80], where[256];
    const struct body_kind *kind;
    void *params; /* kind->size bytes, owned */
};

struct input_contact {
    char name[64], where[256];
    struct settings_contact set;
};

struct input_probe {
    char name[64];
    struct settings_probe set;
};

struct input_panel {
    char name[64], where[256];
    struct settings_panel set;
};

struct input_pairs { /* of solids: what contact.NAME says */
    int n;
    struct input_contact *of;
};

struct input_panels {
    int n;
    struct input_panel *of;
};

struct input_effect {
    const struct part *part;
    char path[80];
    void *self; /* part->size bytes, owned; NULL when size is 0 */
};

enum { INPUT_EFFECTS = 24, INPUT_BODIES = 256 };

struct input {
    struct settings set;
    struct settings_kernel kernel;
    struct settings_domain domain;
    struct settings_reference reference;
    struct settings_disturbance disturbance;
    struct settings_pcisph pcisph;
    struct settings_mps mps;
    struct settings_eos eos;
    struct settings_output output;
    const struct part *pressure; /* equation of state */
    void *pressure_self;         /* begins with struct eos */
    const struct part *walls;
    void *walls_self;            /* NULL when its size is 0 */
    int effects, fluids, wall_count, bodies, probes;
    struct input_effect effect[INPUT_EFFECTS];
    struct input_fluid *fluid;
    struct input_wall *wall;
    struct input_body *body;
    struct input_probe *probe;
    struct input_pairs pairs;
    struct input_panels panels;
};

/* Reads every key of the scene, refuses what no row knows.  Parameter structs
 * move to the plan that takes them (it sets the pointers here to NULL). */
int input_read(struct scene *scene, const struct engine *engine, struct input *in);
void input_free(struct input *in);

#endif
