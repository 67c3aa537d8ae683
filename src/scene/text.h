/* text.h -- a scene file made ready for libconfig: includes put in, comments
 * left out, every line remembering where it came from.
 *
 * libconfig 1.5 alone would look for every include beside the first file, take
 * 3000000000 for a negative number without a word, refuse [0, -9.81] because an
 * integer stands beside a float, and say "syntax error" to everything. */
#ifndef SCENE_TEXT_H
#define SCENE_TEXT_H

#include "scene/tree.h"

enum {
    SCENE_DEPTH_MAX = 64,       /* brackets inside brackets                  */
    SCENE_INCLUDES_MAX = 16,    /* files including files                     */
    SCENE_BYTES_MAX = 8 << 20,  /* of all files together                     */
    SCENE_KEYS_MAX = 10000      /* settings in one group (the search is linear) */
};

struct scene_key {
    const char *name;
    struct scene_place at;
    struct scene_key *before;
};

struct scene_level {      /* an open bracket */
    char open;            /* { ( or [, 0 for the file itself */
    struct scene_place at;
    const char *name;     /* the setting whose value it is, "" in a list */
    struct scene_key *keys;
    int n;
};

struct scene_text {
    struct scene_pool *pool;     /* for as long as the text is needed         */
    struct scene_pool *keep;     /* for as long as the scene: names of files  */
    char *bytes;                 /* [n] what libconfig reads, ends with a 0   */
    int n, room;
    struct scene_place *place;   /* [lines] where each line of bytes is from  */
    int lines, places_room;
    int read;                    /* bytes of all files so far                 */
    struct scene_level level[SCENE_DEPTH_MAX + 1];
    int depth;
    char last;                   /* token before: see lex.c                   */
    struct scene_place comment;  /* where an open comment started             */
    bool in_comment;
    const char *key;             /* the last name followed by =               */
};

/* text->bytes from a file and its includes. */
int scene_text_file(struct scene_text *text, const char *path);
/* The same from the command line, without includes. */
int scene_text_string(struct scene_text *text, const char *source);

/* Adds one line (no newline in it). */
int scene_lex_line(struct scene_text *text, struct scene_place at, const char *line);
/* Refuses what is still open at the end of the last file, closes text->bytes. */
int scene_lex_end(struct scene_text *text);

struct scene_lex { /* a line on its way */
    struct scene_text *text;
    struct scene_place at;
    const char *s;     /* what is left of it */
};

/* Questions of lex.c and value tokens of token.c to each other. */
bool scene_lex_in_list(const struct scene_text *text);
bool scene_lex_awaits_value(const struct scene_text *text); /* stands behind an = */
int scene_lex_quotable(const char *s);                      /* length to quote in a message */
int scene_lex_expect_value(const struct scene_lex *l, char token);
int scene_lex_lacks_value(const struct scene_lex *l);
int scene_lex_put(struct scene_text *text, const char *bytes, int n);
/* Hands the next n characters on as a token of the given sort. */
int scene_lex_take(struct scene_lex *l, int n, char token);

int scene_token_text(struct scene_lex *l);
bool scene_token_is_number(const char *s);
int scene_token_number(struct scene_lex *l);
int scene_token_name(struct scene_lex *l);

#endif
