/* idle.h -- keys that do nothing without another. */
#ifndef PLAN_IDLE_H
#define PLAN_IDLE_H

#include "plan/input.h"

/* Each refuses (BAD_SCENE) the first key of the group that was given another value than
 * its default and does nothing there; `node` is the group, `path` its address. */
int idle_fluid(const struct scene_node *node, const char *path, const struct input_fluid *f);
int idle_wall(const struct scene_node *node, const char *path, const struct motion *m);
int idle_body(const struct scene_node *node, const char *path, const struct input_body *b);

/* Of the whole scene: refuses probes where nothing can be measured; warns of what is
 * harmless. */
int idle_scene(const struct scene *scene, const struct input *in);

/* idle-methods.c: warns of keys that one method alone reads, where that is not the scene's. */
void idle_methods(const struct scene_node *root, const struct input *in);

#endif
