/* parse.h -- from the lines of a scene file and its includes to nodes, in one pass.
 *
 * source.c finds the lines, lex.c parts them into tokens and brackets, token.c knows names,
 * numbers and texts, and both ask parse.c where they stand; each value becomes a node as soon
 * as its first token is there. */
#ifndef SCENE_PARSE_H
#define SCENE_PARSE_H

#include "scene/tree.h"

enum {
    SCENE_DEPTH_MAX = 64,       /* brackets inside brackets                  */
    SCENE_INCLUDES_MAX = 16,    /* files including files                     */
    SCENE_BYTES_MAX = 8 << 20,  /* of all files together                     */
    SCENE_KEYS_MAX = 10000      /* settings in one group (the search is linear) */
};

struct scene_level {          /* an open bracket */
    char open;                /* { ( or [, 0 for the file itself */
    struct scene_place at;    /* where the bracket stands */
    struct scene_node *node;  /* the group or list that it fills */
};

struct scene_parse { /* begins as 0 but for pool, keep and level[0].node, the root to fill */
    struct scene_pool *pool;     /* for as long as files are read: their bytes */
    struct scene_pool *keep;     /* for as long as the scene: nodes, names     */
    int read;                    /* bytes of all files so far                  */
    struct scene_level level[SCENE_DEPTH_MAX + 1];
    int depth;
    char last;                   /* token before: see parse.c                   */
    const char *key;             /* the last name followed by =                */
    struct scene_place key_at;
    struct scene_node *text;     /* the last text, which the next may continue */
    char *bytes;                 /* [n] of that text, in keep                  */
    int n, room;
    struct scene_place at;       /* the line read last                         */
    bool included;               /* it stands in an included file              */
    struct scene_place comment;  /* where an open comment started              */
    bool in_comment;
};

/* All settings of a file and its includes. */
int scene_source_file(struct scene_parse *parse, const char *path);
/* The same from the command line, without includes. */
int scene_source_string(struct scene_parse *parse, const char *source);

/* Reads one line (no newline in it). */
int scene_lex_line(struct scene_parse *parse, struct scene_place at, const char *line);
/* Refuses what is still open at the end of the last file. */
int scene_lex_end(const struct scene_parse *parse);

struct scene_lex { /* a line on its way */
    struct scene_parse *parse;
    struct scene_place at;
    const char *s;     /* what is left of it */
};

/* parse.c */
bool scene_parse_in_list(const struct scene_parse *parse);
bool scene_parse_awaits_value(const struct scene_parse *parse); /* stands behind an = */
int scene_parse_quotable(const char *s);                        /* length to quote in a message */
/* The first n letters of s for a message; WORD instead where they are from an included file, which
 * may be no scene but a file with secrets. */
const char *scene_parse_quote(const struct scene_parse *parse, int n, const char *s);
int scene_parse_lacks_value(const struct scene_lex *l);
/* Refuses a value that stands where none is expected. */
int scene_parse_expect_value(const struct scene_lex *l, char token);
/* A new value of the open group or list; NULL if there is no memory. */
struct scene_node *scene_parse_value(const struct scene_lex *l, enum scene_kind kind);
/* Goes on behind the next n characters, a token of the given sort. */
void scene_parse_take(struct scene_lex *l, int n, char token);

/* token.c */
int scene_token_text(struct scene_lex *l);
bool scene_token_is_number(const char *s);
int scene_token_number(struct scene_lex *l);
int scene_token_name(struct scene_lex *l);

#endif
