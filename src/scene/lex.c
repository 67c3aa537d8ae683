/* lex.c -- goes through a scene token by token: hands libconfig a plain text
 * and says what is wrong while it is still known where and why.
 *
 * text->last is the token before: k a name before =, = or : itself, v a value,
 * t a text, ( an open list, { an open group, ',' ';', and 0 at the start. */
#include "base/status.h"
#include "scene/text.h"

#include <ctype.h>
#include <string.h>

int scene_lex_put(struct scene_text *text, const char *bytes, int n)
{
    for (int i = 0; i < n; i++) {
        char *larger = scene_pool_grow(text->pool, text->bytes, text->n, &text->room, 1);

        if (!larger)
            return STATUS_FAILED;
        text->bytes = larger;
        text->bytes[text->n++] = bytes[i];
    }
    return STATUS_DONE;
}

bool scene_lex_in_list(const struct scene_text *text)
{
    const char open = text->level[text->depth].open;

    return open == '(' || open == '[';
}

bool scene_lex_awaits_value(const struct scene_text *text)
{
    return text->last == '=' || text->last == ':';
}

/* Characters of s that a message may quote. */
int scene_lex_quotable(const char *s)
{
    int n = 0;

    while (n < 40 && s[n] && !isspace((unsigned char)s[n]) && !strchr(";,=)]}", s[n]))
        n++;
    return n;
}

int scene_lex_lacks_value(const struct scene_lex *l)
{
    return status_fail(STATUS_BAD_SCENE, "%s: %s has no value; write %s = VALUE;",
                       scene_place_text(l->at), l->text->key, l->text->key);
}

/* Refuses a value that stands where none is expected. */
int scene_lex_expect_value(const struct scene_lex *l, char token)
{
    struct scene_text *text = l->text;
    const int n = scene_lex_quotable(l->s);

    if (scene_lex_awaits_value(text) || (token == 't' && text->last == 't'))
        return STATUS_DONE;
    if (scene_lex_in_list(text) && strchr("(,", text->last))
        return STATUS_DONE;
    if (scene_lex_in_list(text))
        return status_fail(STATUS_BAD_SCENE, "%s: a comma is missing before %.*s",
                           scene_place_text(l->at), n, l->s);
    return status_fail(STATUS_BAD_SCENE, "%s: %.*s stands where a name is expected; settings "
                       "are written NAME = VALUE;", scene_place_text(l->at), n, l->s);
}

/* Hands n characters on as a token of the given sort. */
int scene_lex_take(struct scene_lex *l, int n, char token)
{
    TRY(scene_lex_put(l->text, l->s, n));
    l->text->last = token;
    l->s += n;
    return STATUS_DONE;
}

static int lex_open(struct scene_lex *l)
{
    struct scene_text *text = l->text;
    const char *name = scene_lex_awaits_value(text) ? text->key : "";
    const char open = *l->s;

    TRY(scene_lex_expect_value(l, 'v'));
    if (text->depth == SCENE_DEPTH_MAX)
        return status_fail(STATUS_BAD_SCENE, "%s: more than %d brackets inside each other",
                           scene_place_text(l->at), SCENE_DEPTH_MAX);
    text->level[++text->depth] = (struct scene_level){ .open = open, .at = l->at, .name = name };
    text->last = open == '{' ? '{' : '(';
    l->s++;
    return scene_lex_put(text, open == '{' ? "{" : "(", 1);
}

static int lex_close(struct scene_lex *l)
{
    struct scene_text *text = l->text;
    const struct scene_level *level = &text->level[text->depth];
    const char *where = scene_place_text(l->at);
    const char close = *l->s, fits = close == '}' ? '{' : close == ')' ? '(' : '[';

    if (text->depth == 0)
        return status_fail(STATUS_BAD_SCENE, "%s: this %c closes nothing; it is one too many, or "
                           "a %c is missing before it", where, close, fits);
    if (level->open != fits)
        return status_fail(STATUS_BAD_SCENE, "%s: this %c does not close the %c of %s", where,
                           close, level->open, scene_place_text(level->at));
    if (scene_lex_awaits_value(text))
        return scene_lex_lacks_value(l);
    if (text->last == ',' && fits != '{')
        return status_fail(STATUS_BAD_SCENE, "%s: a value is missing between , and %c; leave the "
                           "comma out", where, close);
    text->depth--;
    text->last = 'v';
    l->s++;
    return scene_lex_put(text, close == '}' ? "}" : ")", 1);
}

static int lex_separator(struct scene_lex *l)
{
    struct scene_text *text = l->text;
    const char c = *l->s;

    if (c == '=' || c == ':') {
        if (text->last != 'k')
            return status_fail(STATUS_BAD_SCENE, "%s: this %c has no name before it",
                               scene_place_text(l->at), c);
        return scene_lex_take(l, 1, c);
    }
    if (scene_lex_awaits_value(text))
        return scene_lex_lacks_value(l);
    if (scene_lex_in_list(text) && c == ';')
        return status_fail(STATUS_BAD_SCENE, "%s: values in a list are separated by commas, not "
                           "by ;", scene_place_text(l->at));
    if (text->last != 'v' && text->last != 't')
        return status_fail(STATUS_BAD_SCENE, "%s: nothing stands before this %c; leave it out",
                           scene_place_text(l->at), c);
    return scene_lex_take(l, 1, c);
}

static int stray(const struct scene_lex *l)
{
    const unsigned char c = (unsigned char)*l->s;
    const char *where = scene_place_text(l->at);

    if (c == '@')
        return status_fail(STATUS_BAD_SCENE, "%s: @include \"file\" stands alone on its line",
                           where);
    if (c == '\'')
        return status_fail(STATUS_BAD_SCENE, "%s: a text stands in double quotes \"...\"", where);
    if (c == '+' || c == '-')
        return status_fail(STATUS_BAD_SCENE, "%s: a number must follow %c at once, as in %c5",
                           where, c, c);
    if (c < ' ' || c > '~')
        return status_fail(STATUS_BAD_SCENE, "%s: a letter outside a to z (byte 0x%02x) may stand "
                           "only in \"quotes\" and in comments", where, c);
    return status_fail(STATUS_BAD_SCENE, "%s: %c means nothing here; a text stands in double "
                       "quotes", where, c);
}

static int lex_comment(struct scene_lex *l)
{
    struct scene_text *text = l->text;
    const char *end;

    if (!text->in_comment) {
        text->in_comment = true;
        text->comment = l->at;
        l->s += 2;
    }
    end = strstr(l->s, "*/");
    text->in_comment = !end;
    l->s = end ? end + 2 : l->s + strlen(l->s);
    return scene_lex_put(text, " ", 1);
}

static int lex_token(struct scene_lex *l)
{
    const char c = *l->s;

    if (l->text->in_comment || (c == '/' && l->s[1] == '*'))
        return lex_comment(l);
    if (isspace((unsigned char)c)) {
        l->s++;
        return scene_lex_put(l->text, " ", 1);
    }
    if (c == '#' || (c == '/' && l->s[1] == '/')) {
        l->s += strlen(l->s);
        return STATUS_DONE;
    }
    if (c == '"')
        return scene_token_text(l);
    if (strchr("({[", c))
        return lex_open(l);
    if (strchr(")}]", c))
        return lex_close(l);
    if (strchr("=:;,", c))
        return lex_separator(l);
    if (scene_token_is_number(l->s))
        return scene_token_number(l);
    return isalpha((unsigned char)c) || c == '*' ? scene_token_name(l) : stray(l);
}

int scene_lex_line(struct scene_text *text, struct scene_place at, const char *line)
{
    struct scene_lex l = { text, at, line };
    struct scene_place *larger =
        scene_pool_grow(text->pool, text->place, text->lines, &text->places_room, sizeof *larger);

    if (!larger)
        return STATUS_FAILED;
    text->place = larger;
    text->place[text->lines++] = at;
    while (*l.s)
        TRY(lex_token(&l));
    return scene_lex_put(text, "\n", 1);
}

int scene_lex_end(struct scene_text *text)
{
    const struct scene_level *level = &text->level[text->depth];

    if (text->depth > 0)
        return status_fail(STATUS_BAD_SCENE, "%s: the %c that stands here%s%s is never closed",
                           scene_place_text(level->at), level->open,
                           level->name[0] ? " after " : "", level->name);
    if (scene_lex_awaits_value(text))
        return status_fail(STATUS_BAD_SCENE, "%s: %s has no value; write %s = VALUE;",
                           scene_place_text(text->place[text->lines - 1]), text->key, text->key);
    return scene_lex_put(text, "", 1); /* the zero at the end of a string */
}
