/* token.c -- names, numbers and texts of a scene file, see lex.c. */
#include "base/status.h"
#include "scene/text.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static bool name_letter(char c)
{
    return isalnum((unsigned char)c) || (c && strchr("-_*", c));
}

static int name_length(const char *s)
{
    int n = 0;

    while (name_letter(s[n]))
        n++;
    return n;
}

static const char *after_blanks(const char *s)
{
    while (isspace((unsigned char)*s))
        s++;
    return s;
}

int scene_token_text(struct scene_lex *l)
{
    const char *end = l->s + 1;

    TRY(scene_lex_expect_value(l, 't'));
    for (; *end != '"'; end++) {
        if (*end == '\\' && end[1])
            end++;
        if (!*end)
            return status_fail(STATUS_BAD_SCENE, "%s: a text has no closing quote on its line: "
                               "%.40s", scene_place_text(l->at), l->s);
    }
    return scene_lex_take(l, (int)(end + 1 - l->s), 't');
}

bool scene_token_is_number(const char *s)
{
    if (*s == '+' || *s == '-')
        s++;
    if (*s == '.')
        s++;
    return isdigit((unsigned char)*s);
}

static int number_length(const char *s)
{
    int n = 1;

    while (name_letter(s[n]) || s[n] == '.' || (s[n] == '+' && tolower(s[n - 1]) == 'e'))
        n++;
    return n;
}

/* Every number goes on as a float that reads back to the same bits: libconfig
 * cuts integers to 32 bits and wants the elements of an array to be alike. */
int scene_token_number(struct scene_lex *l)
{
    const int n = number_length(l->s);
    char token[256], *end;
    double number;

    TRY(scene_lex_expect_value(l, 'v'));
    snprintf(token, sizeof token, "%.*s", n, l->s);
    number = strtod(token, &end);
    end += strspn(end, "L"); /* libconfig's mark of long integers */
    if (*end || n >= (int)sizeof token)
        return status_fail(STATUS_BAD_SCENE, "%s: %.40s is not a number (values are SI without "
                           "a unit, names start with a letter, there is no arithmetic)",
                           scene_place_text(l->at), token);
    snprintf(token, sizeof token, isfinite(number) ? "%.17g" : number > 0 ? "1e999" : "-1e999",
             number);
    if (!strpbrk(token, ".e"))
        strcat(token, ".0");
    l->s += n;
    l->text->last = 'v';
    return scene_lex_put(l->text, token, (int)strlen(token));
}

/* "fluid.water" for the setting `name` where the text stands now. */
static void write_address(const struct scene_text *text, const char *name, char *to, size_t room)
{
    size_t n = 0;

    to[0] = '\0';
    for (int i = 1; i <= text->depth && n < room; i++)
        if (text->level[i].name[0])
            n += (size_t)snprintf(to + n, room - n, "%s.", text->level[i].name);
    if (n < room)
        snprintf(to + n, room - n, "%s", name);
}

/* Notes the name of a setting; two of the same name in one group are refused. */
static int add_key(struct scene_lex *l, const char *name)
{
    struct scene_level *level = &l->text->level[l->text->depth];
    struct scene_key *key;
    char address[256];

    for (key = level->keys; key; key = key->before)
        if (strcmp(key->name, name) == 0) {
            write_address(l->text, name, address, sizeof address);
            return status_fail(STATUS_BAD_SCENE, "%s: %s is given twice, first at %s; keep one, "
                               "or give one of them another name", scene_place_text(l->at),
                               address, scene_place_text(key->at));
        }
    if (level->n++ >= SCENE_KEYS_MAX)
        return status_fail(STATUS_BAD_SCENE, "%s: more than %d settings in one group",
                           scene_place_text(l->at), SCENE_KEYS_MAX);
    key = scene_pool_take(l->text->pool, sizeof *key);
    if (!key)
        return STATUS_FAILED;
    *key = (struct scene_key){ name, l->at, level->keys };
    level->keys = key;
    return STATUS_DONE;
}

static bool is_word(const char *s, int n, const char *word)
{
    return n == (int)strlen(word) && strncasecmp(s, word, (size_t)n) == 0;
}

static bool is_flag(const char *s, int n)
{
    return is_word(s, n, "true") || is_word(s, n, "false");
}

static int lex_key(struct scene_lex *l, int n)
{
    if (is_flag(l->s, n))
        return status_fail(STATUS_BAD_SCENE, "%s: %.*s is a value and cannot be a name",
                           scene_place_text(l->at), n, l->s);
    l->text->key = scene_pool_print(l->text->pool, "%.*s", n, l->s);
    if (!l->text->key)
        return STATUS_FAILED;
    TRY(add_key(l, l->text->key));
    return scene_lex_take(l, n, 'k');
}

/* A word where a value stands: only true and false go without quotes. */
static int lex_word(struct scene_lex *l, int n, const char *next)
{
    const char *where = scene_place_text(l->at);
    const int all = scene_lex_quotable(l->s);

    if (*next == '=' && scene_lex_awaits_value(l->text))
        return scene_lex_lacks_value(l);
    TRY(scene_lex_expect_value(l, 'v'));
    if (*next == '=')
        return status_fail(STATUS_BAD_SCENE, "%s: %.*s = ... stands in a list, which holds values "
                           "only; settings with names stand in { }", where, n, l->s);
    if (all == n && is_flag(l->s, n))
        return scene_lex_take(l, n, 'v');
    if (is_word(l->s, n, "yes") || is_word(l->s, n, "no") || is_word(l->s, n, "on") ||
        is_word(l->s, n, "off"))
        return status_fail(STATUS_BAD_SCENE, "%s: %.*s means nothing here; write true or false",
                           where, n, l->s);
    return status_fail(STATUS_BAD_SCENE, "%s: %.*s has no quotes; a text is written \"%.*s\"",
                       where, all, l->s, all, l->s);
}

int scene_token_name(struct scene_lex *l)
{
    const int n = name_length(l->s);
    const char *next = after_blanks(l->s + n);

    if (scene_lex_awaits_value(l->text) || scene_lex_in_list(l->text))
        return lex_word(l, n, next);
    if (l->s[n] & 0x80) { /* lex.c knows what is wrong with the letter that follows */
        l->s += n;
        return STATUS_DONE;
    }
    if (*next == '=' || *next == ':')
        return lex_key(l, n);
    if (*next == '.')
        return status_fail(STATUS_BAD_SCENE, "%s: %.*s: dots are for the command line; in a file "
                           "groups stand inside each other, as %.*s = { ... }",
                           scene_place_text(l->at), scene_lex_quotable(l->s), l->s, n, l->s);
    return status_fail(STATUS_BAD_SCENE, "%s: %.*s has no = after it; settings are written "
                       "NAME = VALUE;", scene_place_text(l->at), scene_lex_quotable(l->s), l->s);
}
