/* lex.c -- goes through a scene token by token and says what is wrong while it is still
 * known where and why. */
#include "base/status.h"
#include "scene/parse.h"

#include <ctype.h>
#include <string.h>

static int lex_open(struct scene_lex *l)
{
    struct scene_parse *parse = l->parse;
    const char open = *l->s;
    struct scene_node *node;

    TRY(scene_parse_expect_value(l, 'v'));
    if (parse->depth == SCENE_DEPTH_MAX)
        return status_fail(STATUS_BAD_SCENE, "%s: more than %d brackets inside each other",
                           scene_place_text(l->at), SCENE_DEPTH_MAX);
    node = scene_parse_value(l, open == '{' ? SCENE_GROUP : SCENE_LIST);
    if (!node)
        return STATUS_FAILED;
    parse->level[++parse->depth] = (struct scene_level){ open, l->at, node };
    scene_parse_take(l, 1, open == '{' ? '{' : '(');
    return STATUS_DONE;
}

static int lex_close(struct scene_lex *l)
{
    struct scene_parse *parse = l->parse;
    const struct scene_level *level = &parse->level[parse->depth];
    const char *where = scene_place_text(l->at);
    const char close = *l->s, fits = close == '}' ? '{' : close == ')' ? '(' : '[';

    if (parse->depth == 0)
        return status_fail(STATUS_BAD_SCENE, "%s: this %c closes nothing; it is one too many, or "
                           "a %c is missing before it", where, close, fits);
    if (level->open != fits)
        return status_fail(STATUS_BAD_SCENE, "%s: this %c does not close the %c of %s", where,
                           close, level->open, scene_place_text(level->at));
    if (scene_parse_awaits_value(parse))
        return scene_parse_lacks_value(l);
    if (parse->last == ',' && fits != '{')
        return status_fail(STATUS_BAD_SCENE, "%s: a value is missing between , and %c; leave the "
                           "comma out", where, close);
    parse->depth--;
    scene_parse_take(l, 1, 'v');
    return STATUS_DONE;
}

static int lex_separator(struct scene_lex *l)
{
    struct scene_parse *parse = l->parse;
    const char c = *l->s;

    if (c == '=' || c == ':') {
        if (parse->last != 'k')
            return status_fail(STATUS_BAD_SCENE, "%s: this %c has no name before it",
                               scene_place_text(l->at), c);
        scene_parse_take(l, 1, c);
        return STATUS_DONE;
    }
    if (scene_parse_awaits_value(parse))
        return scene_parse_lacks_value(l);
    if (scene_parse_in_list(parse) && c == ';')
        return status_fail(STATUS_BAD_SCENE, "%s: values in a list are separated by commas, not "
                           "by ;", scene_place_text(l->at));
    if (parse->last != 'v' && parse->last != 't')
        return status_fail(STATUS_BAD_SCENE, "%s: nothing stands before this %c; leave it out",
                           scene_place_text(l->at), c);
    scene_parse_take(l, 1, c);
    return STATUS_DONE;
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

static void lex_comment(struct scene_lex *l)
{
    struct scene_parse *parse = l->parse;
    const char *end;

    if (!parse->in_comment) {
        parse->in_comment = true;
        parse->comment = l->at;
        l->s += 2;
    }
    end = strstr(l->s, "*/");
    parse->in_comment = !end;
    l->s = end ? end + 2 : l->s + strlen(l->s);
}

/* Steps over a blank or a comment; answers whether there was one. */
static bool skip(struct scene_lex *l)
{
    const char c = *l->s;

    if (l->parse->in_comment || (c == '/' && l->s[1] == '*'))
        lex_comment(l);
    else if (isspace((unsigned char)c))
        l->s++;
    else if (c == '#' || (c == '/' && l->s[1] == '/'))
        l->s += strlen(l->s);
    else
        return false;
    return true;
}

static int lex_token(struct scene_lex *l)
{
    const char c = *l->s;

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

int scene_lex_line(struct scene_parse *parse, struct scene_place at, const char *line)
{
    struct scene_lex l = { parse, at, line };

    parse->at = at;
    while (*l.s)
        if (!skip(&l))
            TRY(lex_token(&l));
    return STATUS_DONE;
}

int scene_lex_end(const struct scene_parse *parse)
{
    const struct scene_level *level = &parse->level[parse->depth];

    if (parse->depth > 0)
        return status_fail(STATUS_BAD_SCENE, "%s: the %c that stands here%s%s is never closed",
                           scene_place_text(level->at), level->open,
                           level->node->name[0] ? " after " : "", level->node->name);
    if (scene_parse_awaits_value(parse))
        return status_fail(STATUS_BAD_SCENE, "%s: %s has no value; write %s = VALUE;",
                           scene_place_text(parse->at), parse->key, parse->key);
    return STATUS_DONE;
}
