/* scene.h -- a tree of settings with their files and lines.  Knows no key:
 * what keys there are, the rows (base/param.h) of other rooms say. */
#ifndef SCENE_SCENE_H
#define SCENE_SCENE_H

#include "base/param.h"
#include <stdbool.h>
#include <stdio.h>

struct scene;      /* a scene file, its includes and overrides              */
struct scene_node; /* one setting in it: group, list or value               */

/* Reads path, written as doc/scene.md says under Syntax: the notation of libconfig, where
 * every number is a double, arrays and lists are one thing (so [0, -9.81] is fine), a text
 * ends on its line, and @include looks beside the including file.  On failure *out is NULL.
 * Free with scene_free(&scene); nodes and texts lent by the scene end with it. */
int scene_read(const char *path, struct scene **out);
void scene_free(struct scene **scene);

/* Applies "KEY=VALUE".  KEY is dotted; a name left out means all of that
 * kind: when beam has no E and holds nothing but groups, "beam.E=5e9" sets E
 * in each of them.  Groups that are missing on the way are made, so what
 * matches nothing is refused later: by scene_fill() as an unknown key, or by
 * scene_check_named() when there is no beam at all.  What does not parse as a
 * value is a text; where a text is wanted, a number is taken as it was typed. */
int scene_override(struct scene *scene, const char *assignment);

const char *scene_path(const struct scene *scene);
const struct scene_node *scene_root(const struct scene *scene);

/* Child by name, NULL if there is none (or group is NULL). */
const struct scene_node *scene_child(const struct scene_node *group, const char *name);

/* Answers whether the command line gives `key` of the group, a word: *now, where the file
 * says *was, which stays as it is when the file says nothing. */
bool scene_changed(const struct scene_node *group, const char *key, const char **was,
                   const char **now);
/* Takes a key out of a group of the top level, as if nobody had given it. */
void scene_leave_out(struct scene *scene, const char *group, const char *key);

int scene_count(const struct scene_node *group);           /* 0 for NULL     */
const struct scene_node *scene_at(const struct scene_node *group, int i);
const char *scene_name(const struct scene_node *node);     /* "" in a list   */
bool scene_is_group(const struct scene_node *node);
const char *scene_file(const struct scene_node *node);     /* or "command line" */
int scene_line(const struct scene_node *node);             /* 0: an override */

/* "FILE:LINE" or "command line" for messages, with the name that may be meant where the command line
 * alone has an object of a similar one; the last two answers stay valid. */
const char *scene_where(const struct scene_node *node);

/* Refuses values where only named groups may stand, as in beam = { gate = { ... } }.
 * To be asked of fluid, wall, beam ... before their groups are filled; NULL is fine. */
int scene_check_named(const struct scene_node *kind);

/* Fills the struct `into` from the group (NULL: defaults only) by its rows,
 * which may be NULL.  `path` is the dotted address of the group ("" for the
 * top level).  Keys that are neither in rows nor in `also` (NULL-ended list
 * of names that others read; may be NULL) are refused with the nearest known
 * key; so are wrong types and values out of range.  Every value is noted for
 * scene_write_used(). `dimension` says how many numbers a vector has.
 *
 * min = max (both left 0) means no range; the range of a vector or points holds
 * for each number.  Defaults: of a vector fallback in every component, of a
 * word the first, of a text "", of points none; a fallback NAN leaves NAN in a
 * number or vector and INT_MIN in an integer.  Components of a vector beyond
 * `dimension` are 0.  Filling one group by several tables of rows is fine: each
 * names the other's keys in `also`. */
int scene_fill(struct scene *scene, const struct scene_node *group,
               const char *path, const struct param *rows,
               const char *const *also, int dimension, void *into);

/* Writes down what a default that the row calls computed came to be; does
 * nothing when the scene gave the value. */
void scene_computed(struct scene *scene, const char *path, const char *key, double value);
void scene_computed_word(struct scene *scene, const char *path, const char *key, const char *word);

/* All noted values as a scene file: value, unit, whether default.  Running
 * it again gives the same bits (numbers have up to 17 digits).  Groups that were
 * filled are there even without values, for what is named is switched on. */
int scene_write_used(const struct scene *scene, FILE *to);

/* All that files and the command line give, in its order: a line for each setting, its dotted address and
 * its value.  Two scenes with the same lines are the same. */
void scene_write_given(const struct scene *scene, FILE *to);

/* The nearest of names (NULL-ended) to word, NULL if none is near. */
const char *scene_nearest(const char *word, const char *const *names);

#endif
