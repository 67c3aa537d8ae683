/* tree.h -- what the files of this room share: memory, nodes, notes. */
#ifndef SCENE_TREE_H
#define SCENE_TREE_H

#include "base/param.h"
#include "scene/scene.h"
#include <stdbool.h>
#include <stddef.h>

/* Memory that is given back all at once: whatever fails half-way leaks nothing. */
struct scene_pool {
    struct scene_chunk *last;
};

/* Zeroed memory, NULL and a failure kept when there is none. */
void *scene_pool_take(struct scene_pool *pool, size_t bytes);
char *scene_pool_print(struct scene_pool *pool, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* array with room for one more than n of the given size; NULL if there is no memory.
 * Grows by doubling; *room is how many fit. */
void *scene_pool_grow(struct scene_pool *pool, void *array, int n, int *room, size_t size);
void scene_pool_free(struct scene_pool *pool);

/* Where something was written; file NULL means the command line. */
struct scene_place {
    const char *file;
    int line; /* 0: the file as a whole */
};

/* "FILE:LINE" or "command line"; the last two answers stay valid. */
const char *scene_place_text(struct scene_place at);

enum scene_kind { SCENE_GROUP, SCENE_LIST, SCENE_NUMBER, SCENE_FLAG, SCENE_TEXT };

struct scene_node {
    const char *name;          /* "" in a list                                       */
    enum scene_kind kind;
    struct scene_place at;
    double number;
    bool flag;
    bool off;                  /* a group that the command line has taken away       */
    const char *text;          /* of a text; of any override: as it was typed        */
    const char *beside;        /* of a group that the command line made: a group of the file that
                                * it stands beside and has nearly its name, NULL: none        */
    const struct scene_node *was; /* of an override: what the file has, NULL: nothing */
    struct scene_node **child; /* [n] of a group or list                             */
    int n, room;
};

struct scene_note {
    const char *path, *key; /* key NULL: only says that the group is there           */
    const char *value;      /* as a scene writes it                                  */
    const char *unit;
    const char *origin;     /* "default" or "computed", "" if the scene gave it      */
    bool silent;            /* a scene cannot say it (not a number yet): a comment   */
};

struct scene {
    struct scene_pool pool; /* owns all that the members point to */
    const char *path;
    struct scene_node *root;
    struct scene_note *note; /* [notes] in the order of scene_fill() */
    int notes, notes_room;
    int *seat;               /* [seats], a power of two: 0, or 1 + the place of a note that is
                              * found by its path and key                            */
    size_t seats;
};

struct scene_node *scene_node_create(struct scene_pool *pool, const char *name,
                                     enum scene_kind kind, struct scene_place at);
int scene_node_add(struct scene_pool *pool, struct scene_node *parent, struct scene_node *child);
/* Adds child to group, in the place of the one with its name if there is one. */
int scene_node_put(struct scene_pool *pool, struct scene_node *group, struct scene_node *child);
/* Child by name that may be changed, NULL if there is none. */
struct scene_node *scene_node_find(const struct scene_node *group, const char *name);
/* Takes a child out of the group. */
void scene_node_remove(struct scene_node *group, const struct scene_node *child);

/* Settings from the command line, below a new root. */
int scene_read_string(struct scene_pool *keep, const char *source, struct scene_node **root);

/* Values as a scene writes them; a group only as { ... }. */
void scene_write_node(const struct scene_node *node, FILE *to);
void scene_write_text(const char *text, FILE *to);
void scene_write_number(double number, FILE *to);

/* One value that a row asks for: reads it, or says what is wrong with it. */
struct scene_wish {
    struct scene *scene;
    const struct param *row;
    const struct scene_node *node; /* NULL: take the default                         */
    const char *name;              /* dotted address, for messages                   */
    int dimension;
    void *to;                      /* the member of the caller's struct              */
};

int scene_value_read(const struct scene_wish *wish);
/* "a number in m/s", for messages; static buffer. */
const char *scene_value_expected(const struct param *row, int dimension);
void scene_value_default(const struct scene_wish *wish);
/* Notes what now stands in the struct. */
int scene_value_note(const struct scene_wish *wish, const char *path);

/* Notes that a group is there, though it may have no values. */
int scene_note_group(struct scene *scene, const char *path);
/* Notes a value that no row describes; notes of rows come before it. */
int scene_note_raw(struct scene *scene, const char *path, const struct scene_node *node);

#endif
