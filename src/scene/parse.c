/* parse.c -- where a line on its way stands, and the next value: what brackets and separators
 * (lex.c) and names, numbers and texts (token.c) both ask.
 *
 * parse->last is the token before: k a name before =, = or : itself, v a value,
 * t a text, ( an open list, { an open group, ',' ';', and 0 at the start. */
#include "scene/parse.h"

#include "base/status.h"

#include <ctype.h>
#include <string.h>

bool scene_parse_in_list(const struct scene_parse *parse)
{
    const char open = parse->level[parse->depth].open;

    return open == '(' || open == '[';
}

bool scene_parse_awaits_value(const struct scene_parse *parse)
{
    return parse->last == '=' || parse->last == ':';
}

/* Characters of s that a message may quote. */
int scene_parse_quotable(const char *s)
{
    int n = 0;

    while (n < 40 && s[n] && !isspace((unsigned char)s[n]) && !strchr(";:,=)]}", s[n]))
        n++;
    return n;
}

const char *scene_parse_quote(const struct scene_parse *parse, int n, const char *s)
{
    const char *quote = parse->included ? "WORD" : scene_pool_print(parse->pool, "%.*s", n, s);

    return quote ? quote : "";
}

int scene_parse_lacks_value(const struct scene_lex *l)
{
    const char *key = scene_parse_quote(l->parse, 40, l->parse->key);

    return status_fail(STATUS_BAD_SCENE, "%s: %s has no value; write %s = VALUE;",
                       scene_place_text(l->at), key, key);
}

int scene_parse_expect_value(const struct scene_lex *l, char token)
{
    struct scene_parse *parse = l->parse;
    const char *word;

    if (scene_parse_awaits_value(parse) || (token == 't' && parse->last == 't'))
        return STATUS_DONE;
    if (scene_parse_in_list(parse) && strchr("(,", parse->last))
        return STATUS_DONE;
    word = scene_parse_quote(parse, scene_parse_quotable(l->s), l->s);
    if (scene_parse_in_list(parse))
        return status_fail(STATUS_BAD_SCENE, "%s: a comma is missing before %s",
                           scene_place_text(l->at), word);
    return status_fail(STATUS_BAD_SCENE, "%s: %s stands where a name is expected; settings "
                       "are written NAME = VALUE;", scene_place_text(l->at), word);
}

struct scene_node *scene_parse_value(const struct scene_lex *l, enum scene_kind kind)
{
    struct scene_parse *parse = l->parse;
    const bool named = scene_parse_awaits_value(parse);
    struct scene_node *node = scene_node_create(parse->keep, named ? parse->key : "", kind,
                                                named ? parse->key_at : l->at);

    if (!node || scene_node_add(parse->keep, parse->level[parse->depth].node, node) != STATUS_DONE)
        return NULL;
    return node;
}

void scene_parse_take(struct scene_lex *l, int n, char token)
{
    l->parse->last = token;
    l->s += n;
}
