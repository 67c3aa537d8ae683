/* token.c -- names, numbers and texts of a scene file, see lex.c. */
#include "base/status.h"
#include "scene/parse.h"

#include <ctype.h>
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

/* The character that begins at s, in *c; answers how long it is written.  A backslash that
 * begins nothing of this list stands for itself. */
static int read_letter(const char *s, char *c)
{
    static const char written[] = "nrtf\\\"", meant[] = "\n\r\t\f\\\"";
    const char *escape = s[0] == '\\' ? strchr(written, s[1]) : NULL;

    *c = escape ? meant[escape - written] : s[0];
    if (s[0] != '\\' || tolower((unsigned char)s[1]) != 'x' || !isxdigit((unsigned char)s[2]) ||
        !isxdigit((unsigned char)s[3]))
        return escape ? 2 : 1;
    *c = (char)strtol((const char[]){ s[2], s[3], '\0' }, NULL, 16);
    return 4;
}

static int put_letter(struct scene_parse *parse, char c)
{
    char *larger = scene_pool_grow(parse->keep, parse->bytes, parse->n, &parse->room, 1);

    if (!larger)
        return STATUS_FAILED;
    parse->bytes = larger;
    parse->bytes[parse->n] = c;
    return STATUS_DONE;
}

/* Adds what stands between the quotes, up to end, to the open text; \x00 adds nothing. */
static int add_text(struct scene_parse *parse, const char *s, const char *end)
{
    for (char c; s < end;) {
        s += read_letter(s, &c);
        TRY(put_letter(parse, c));
        parse->n += c != '\0';
    }
    TRY(put_letter(parse, '\0'));
    parse->text->text = parse->bytes;
    return STATUS_DONE;
}

static int open_text(const struct scene_lex *l)
{
    struct scene_parse *parse = l->parse;

    parse->bytes = NULL;
    parse->n = parse->room = 0;
    parse->text = scene_parse_value(l, SCENE_TEXT);
    return parse->text ? STATUS_DONE : STATUS_FAILED;
}

/* Texts beside each other are one. */
int scene_token_text(struct scene_lex *l)
{
    const char *end = l->s + 1;

    TRY(scene_parse_expect_value(l, 't'));
    for (; *end != '"'; end++) {
        if (*end == '\\' && end[1])
            end++;
        if (!*end)
            return status_fail(STATUS_BAD_SCENE, "%s: a text has no closing quote on its line: "
                               "%s", scene_place_text(l->at),
                               scene_parse_quote(l->parse, 40, l->s));
    }
    if (l->parse->last != 't')
        TRY(open_text(l));
    TRY(add_text(l->parse, l->s + 1, end));
    scene_parse_take(l, (int)(end + 1 - l->s), 't');
    return STATUS_DONE;
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

int scene_token_number(struct scene_lex *l)
{
    const int n = number_length(l->s);
    struct scene_node *node;
    char token[256], *end;
    double number;

    TRY(scene_parse_expect_value(l, 'v'));
    snprintf(token, sizeof token, "%.*s", n, l->s);
    number = strtod(token, &end);
    end += strspn(end, "L"); /* how libconfig marks long integers */
    if (*end || n >= (int)sizeof token)
        return status_fail(STATUS_BAD_SCENE, "%s: %s is not a number (values are SI without "
                           "a unit, names start with a letter, there is no arithmetic)",
                           scene_place_text(l->at), scene_parse_quote(l->parse, 40, token));
    node = scene_parse_value(l, SCENE_NUMBER);
    if (!node)
        return STATUS_FAILED;
    node->number = number;
    scene_parse_take(l, n, 'v');
    return STATUS_DONE;
}

/* "fluid.water" for the setting `name` where the text stands now. */
static void write_address(const struct scene_parse *parse, const char *name, char *to, size_t room)
{
    size_t n = 0;

    to[0] = '\0';
    for (int i = 1; i <= parse->depth && n < room; i++)
        if (parse->level[i].node->name[0])
            n += (size_t)snprintf(to + n, room - n, "%s.", parse->level[i].node->name);
    if (n < room)
        snprintf(to + n, room - n, "%s", name);
}

/* Refuses a second setting of one name in a group, and groups that grow beyond bounds. */
static int check_key(const struct scene_lex *l, const char *name)
{
    const struct scene_node *group = l->parse->level[l->parse->depth].node;
    const struct scene_node *first = scene_node_find(group, name);
    char address[256];

    if (first) {
        write_address(l->parse, name, address, sizeof address);
        return status_fail(STATUS_BAD_SCENE, "%s: %s is given twice, first at %s; keep one, or "
                           "give one of them another name", scene_place_text(l->at), address,
                           scene_place_text(first->at));
    }
    if (group->n >= SCENE_KEYS_MAX)
        return status_fail(STATUS_BAD_SCENE, "%s: more than %d settings in one group",
                           scene_place_text(l->at), SCENE_KEYS_MAX);
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
        return status_fail(STATUS_BAD_SCENE, "%s: %s is a value and cannot be a name",
                           scene_place_text(l->at), scene_parse_quote(l->parse, n, l->s));
    l->parse->key = scene_pool_print(l->parse->pool, "%.*s", n, l->s);
    if (!l->parse->key)
        return STATUS_FAILED;
    l->parse->key_at = l->at;
    TRY(check_key(l, l->parse->key));
    scene_parse_take(l, n, 'k');
    return STATUS_DONE;
}

static int lex_flag(struct scene_lex *l, int n)
{
    struct scene_node *node = scene_parse_value(l, SCENE_FLAG);

    if (!node)
        return STATUS_FAILED;
    node->flag = is_word(l->s, n, "true");
    scene_parse_take(l, n, 'v');
    return STATUS_DONE;
}

/* A word where a value stands: only true and false go without quotes. */
static int lex_word(struct scene_lex *l, int n, const char *next)
{
    const char *where = scene_place_text(l->at);
    const int all = scene_parse_quotable(l->s);
    const char *word = scene_parse_quote(l->parse, all, l->s);

    if (*next == '=' && scene_parse_awaits_value(l->parse))
        return scene_parse_lacks_value(l);
    TRY(scene_parse_expect_value(l, 'v'));
    if (*next == '=')
        return status_fail(STATUS_BAD_SCENE, "%s: %s = ... stands in a list, which holds values "
                           "only; settings with names stand in { }", where,
                           scene_parse_quote(l->parse, n, l->s));
    if (all == n && is_flag(l->s, n))
        return lex_flag(l, n);
    if (is_word(l->s, n, "yes") || is_word(l->s, n, "no") || is_word(l->s, n, "on") ||
        is_word(l->s, n, "off"))
        return status_fail(STATUS_BAD_SCENE, "%s: %s means nothing here; write true or false",
                           where, scene_parse_quote(l->parse, n, l->s));
    return status_fail(STATUS_BAD_SCENE, "%s: %s has no quotes; a text is written \"%s\"",
                       where, word, word);
}

/* What stands behind numbers on paper, up to a power or a bar. */
static bool is_unit(const char *s)
{
    static const char *const units[] = { "m", "mm", "cm", "dm", "km", "um", "s", "ms", "us", "min",
                                         "h", "Pa", "kPa", "MPa", "GPa", "bar", "N", "kN", "kg", "g",
                                         "t", "Hz", "kHz", "rad", "deg", "J", "W" };
    int n = 0;

    while (isalpha((unsigned char)s[n]))
        n++;
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++)
        if (is_word(s, n, units[i]))
            return true;
    return false;
}

/* A name that nothing is set to. */
static int lone_name(const struct scene_lex *l, int n, bool dotted)
{
    const struct scene_parse *parse = l->parse;
    const char *where = scene_place_text(l->at);
    const char *all = scene_parse_quote(parse, scene_parse_quotable(l->s), l->s);
    const char *key = parse->key ? scene_parse_quote(parse, 40, parse->key) : "";

    if (dotted)
        return status_fail(STATUS_BAD_SCENE, "%s: %s: dots are for the command line; in a file "
                           "groups stand inside each other, as %s = { ... }", where, all,
                           scene_parse_quote(parse, n, l->s));
    if (parse->last == 'v' && is_unit(l->s))
        return status_fail(STATUS_BAD_SCENE, "%s: %s: units are not written; %s is a number in "
                           "the SI unit that `stiffwater explain %s` tells", where, all,
                           key, key);
    return status_fail(STATUS_BAD_SCENE, "%s: %s has no = after it; settings are written "
                       "NAME = VALUE;%s", where, all,
                       parse->included ? " (is it a scene? Words of an included file are not told)"
                                       : "");
}

int scene_token_name(struct scene_lex *l)
{
    const int n = name_length(l->s);
    const char *next = after_blanks(l->s + n);

    if (scene_parse_awaits_value(l->parse) || scene_parse_in_list(l->parse))
        return lex_word(l, n, next);
    if (l->s[n] & 0x80) { /* lex.c knows what is wrong with the letter that follows */
        l->s += n;
        return STATUS_DONE;
    }
    if (*next == '=' || *next == ':')
        return lex_key(l, n);
    return lone_name(l, n, *next == '.');
}
