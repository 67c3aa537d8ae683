/* input-objects.h -- the groups of a scene whose members have names of their own. */
#ifndef PLAN_INPUT_OBJECTS_H
#define PLAN_INPUT_OBJECTS_H

#include "plan/input.h"

enum { INPUT_KEYS = 96 }; /* of one group, the NULL at the end included */

/* Behind n keys those of the rows, and NULL; returns how many there are now. */
int input_add_keys(const struct param *rows, const char **keys, int n);

/* Checks that a group `name` of named objects has only groups in it; zeroed room for its
 * objects and one more (NULL: no memory). */
int input_check_objects(const struct scene_node *group, const char *name);
void *input_objects(const struct scene_node *group, size_t size);

/* Each reads one group.  Fluids need the equation of state, and come before effects;
 * all need the settings and the domain. */
int input_fluids(struct scene *scene, struct input *in);
int input_walls(struct scene *scene, struct input *in);
int input_bodies(struct scene *scene, struct input *in);
int input_contacts(struct scene *scene, struct input *in);
int input_probes(struct scene *scene, struct input *in);
int input_panels(struct scene *scene, struct input *in);

#endif
