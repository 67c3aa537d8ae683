/* value.c -- one value of a scene: read, checked, or set to its default. */
#include "base/status.h"
#include "scene/tree.h"

#include <assert.h>
#include <ctype.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The node's value as the scene has it, cut short for messages. */
static const char *shown(const struct scene_node *node)
{
    static char text[64];
    char *all = NULL;
    size_t n = 0;
    FILE *stream = open_memstream(&all, &n);

    strcpy(text, "...");
    if (!stream)
        return text;
    scene_write_node(node, stream);
    if (fclose(stream) == 0 && snprintf(text, sizeof text, "%s", all) >= (int)sizeof text)
        strcpy(text + sizeof text - 4, "...");
    free(all);
    return text;
}

static const char *kind_text(const struct scene_node *node)
{
    static const char *const kinds[] = {
        [SCENE_GROUP] = "a group", [SCENE_LIST] = "a list", [SCENE_NUMBER] = "a number",
        [SCENE_FLAG] = "true or false", [SCENE_TEXT] = "a text",
    };

    return kinds[node->kind];
}

/* "" for numbers without a unit, which rows may write as "1". */
static const char *unit_of(const struct param *row)
{
    return row->unit && strcmp(row->unit, "1") != 0 ? row->unit : "";
}

const char *scene_value_expected(const struct param *row, int dimension)
{
    static const char *const kinds[] = {
        [PARAM_NUMBER] = "a number", [PARAM_INTEGER] = "a whole number",
        [PARAM_FLAG] = "true or false", [PARAM_WORD] = "a word in quotes",
        [PARAM_TEXT] = "a text in quotes", [PARAM_VECTOR] = "a list of",
        [PARAM_POINTS] = "a list of points like", [PARAM_PAIRS] = "a list of pairs like [a, b]",
        [PARAM_WORDS] = "a list of words in quotes",
    };
    static const char *const vectors[] = { "", " [x]", " [x, y]", " [x, y, z]" };
    static char text[128];
    const bool vector = row->type == PARAM_VECTOR || row->type == PARAM_POINTS;

    snprintf(text, sizeof text, "%s%s%s%s", kinds[row->type], vector ? vectors[dimension] : "",
             unit_of(row)[0] ? " in " : "", unit_of(row));
    return text;
}

/* KEY=off of the command line, which takes away what a file says; this one says nothing. */
static bool takes_nothing(const struct scene_node *node)
{
    return !node->at.file && node->kind == SCENE_TEXT && strcmp(node->text, "off") == 0;
}

static int refuse_kind(const struct scene_wish *w, const struct scene_node *node)
{
    const bool unit = node->kind == SCENE_TEXT && isdigit((unsigned char)node->text[0]);

    if (takes_nothing(node))
        return status_fail(STATUS_BAD_SCENE, "command line: %s = off takes away what the scene says, and "
                           "it says nothing of that: leave it out (%s)", w->name, w->row->about);
    return status_fail(STATUS_BAD_SCENE, "%s: %s = %s is %s, but %s is expected%s%s%s%s",
                       scene_where(node), w->name, shown(node), kind_text(node),
                       scene_value_expected(w->row, w->dimension), w->row->about[0] ? " (" : "",
                       w->row->about, w->row->about[0] ? ")" : "",
                       unit ? "; numbers stand without quotes and units" : "");
}

/* "lies outside 0 to 5" or what is true when one end is open. */
static int refuse_range(const struct scene_wish *w, const struct scene_node *node)
{
    const struct param *row = w->row;
    const char *gap = unit_of(row)[0] ? " " : "";
    char range[80];

    if (row->max >= 1e300)
        snprintf(range, sizeof range, "must be at least %g", row->min);
    else if (row->min <= -1e300)
        snprintf(range, sizeof range, "must be at most %g", row->max);
    else
        snprintf(range, sizeof range, "lies outside %g to %g", row->min, row->max);
    return status_fail(STATUS_BAD_SCENE, "%s: %s = %s%s%s %s (%s)", scene_where(node), w->name,
                       shown(node), gap, unit_of(row), range, row->about);
}

/* A finite number in the row's range; a row with min = max has no range. */
static int number_of(const struct scene_wish *w, const struct scene_node *node, double *number)
{
    const struct param *row = w->row;

    if (node->kind != SCENE_NUMBER)
        return refuse_kind(w, node);
    if (!isfinite(node->number))
        return status_fail(STATUS_BAD_SCENE, "%s: %s has a number too large for a computer "
                           "(about 1.8e308 is the largest)", scene_where(node), w->name);
    if (row->min < row->max && !(node->number >= row->min && node->number <= row->max))
        return refuse_range(w, node);
    *number = node->number;
    return STATUS_DONE;
}

static int read_number(const struct scene_wish *w)
{
    return number_of(w, w->node, w->to);
}

static int read_integer(const struct scene_wish *w)
{
    double number;

    TRY(number_of(w, w->node, &number));
    if (number != trunc(number) || fabs(number) > INT_MAX)
        return status_fail(STATUS_BAD_SCENE, "%s: %s = %s is not a whole number (%s)",
                           scene_where(w->node), w->name, shown(w->node), w->row->about);
    *(int *)w->to = (int)number;
    return STATUS_DONE;
}

static int read_flag(const struct scene_wish *w)
{
    if (w->node->kind != SCENE_FLAG)
        return refuse_kind(w, w->node);
    *(bool *)w->to = w->node->flag;
    return STATUS_DONE;
}

static int read_text(const struct scene_wish *w)
{
    if (!w->node->text)
        return refuse_kind(w, w->node);
    *(const char **)w->to = w->node->text;
    return STATUS_DONE;
}

static int refuse_word(const struct scene_wish *w, const struct scene_node *node)
{
    const char *nearest = scene_nearest(node->text, w->row->words);
    char allowed[2000] = "";
    size_t n = 0;

    for (int i = 0; w->row->words[i] && n < sizeof allowed; i++)
        n += (size_t)snprintf(allowed + n, sizeof allowed - n, "%s\"%s\"", i > 0 ? ", " : "",
                              w->row->words[i]);
    return status_fail(STATUS_BAD_SCENE, "%s: %s = \"%.60s\" is not one of %s%s%s%s (%s)",
                       scene_where(node), w->name, node->text, allowed,
                       nearest ? "; did you mean \"" : "", nearest ? nearest : "",
                       nearest ? "\"?" : "", w->row->about);
}

static int word_of(const struct scene_wish *w, const struct scene_node *node, int *which)
{
    assert(w->row->words);
    if (!node->text)
        return refuse_kind(w, node);
    for (int i = 0; w->row->words[i]; i++)
        if (strcmp(node->text, w->row->words[i]) == 0) {
            *which = i;
            return STATUS_DONE;
        }
    return refuse_word(w, node);
}

static int read_word(const struct scene_wish *w)
{
    int which;

    TRY(word_of(w, w->node, &which));
    *(const char **)w->to = w->row->words[which];
    return STATUS_DONE;
}

/* A list of words, or one word alone. */
static int read_words(const struct scene_wish *w)
{
    unsigned set = 0;
    int which;

    if (w->node->kind == SCENE_TEXT) {
        TRY(word_of(w, w->node, &which));
        set = 1u << which;
    } else if (w->node->kind != SCENE_LIST) {
        return refuse_kind(w, w->node);
    }
    for (int i = 0; i < w->node->n; i++) {
        TRY(word_of(w, w->node->child[i], &which));
        set |= 1u << which;
    }
    *(unsigned *)w->to = set;
    return STATUS_DONE;
}

static int vector_of(const struct scene_wish *w, const struct scene_node *node, double to[3])
{
    static const char *const dimensions[] = { "", "in 1 dimensions ", "in 2 dimensions ",
                                              "in 3 dimensions " };
    double x[3] = { 0, 0, 0 };

    assert(w->dimension >= 1 && w->dimension <= 3);
    if (node->kind != SCENE_LIST)
        return refuse_kind(w, node);
    if (node->n != w->dimension)
        return status_fail(STATUS_BAD_SCENE, "%s: %s: %s holds %d value%s, but %s%d "
                           "numbers are expected (%s)", scene_where(node), w->name, shown(node),
                           node->n, node->n == 1 ? "" : "s",
                           w->row->type == PARAM_PAIRS ? "" : dimensions[w->dimension],
                           w->dimension, w->row->about);
    for (int d = 0; d < node->n; d++)
        TRY(number_of(w, node->child[d], &x[d]));
    memcpy(to, x, sizeof x);
    return STATUS_DONE;
}

static int read_vector(const struct scene_wish *w)
{
    return vector_of(w, w->node, w->to);
}

static int read_points(const struct scene_wish *w)
{
    struct param_points points = { .n = w->node->n };

    if (w->node->kind != SCENE_LIST)
        return refuse_kind(w, w->node);
    points.x = scene_pool_take(&w->scene->pool, (size_t)points.n * sizeof *points.x);
    if (!points.x)
        return STATUS_FAILED;
    for (int i = 0; i < points.n; i++)
        TRY(vector_of(w, w->node->child[i], points.x[i]));
    *(struct param_points *)w->to = points;
    return STATUS_DONE;
}

static int read_pairs(const struct scene_wish *w)
{
    struct scene_wish pairs = *w;

    pairs.dimension = 2;
    return read_points(&pairs);
}

int scene_value_read(const struct scene_wish *wish)
{
    static int (*const read[])(const struct scene_wish *) = {
        [PARAM_NUMBER] = read_number, [PARAM_INTEGER] = read_integer, [PARAM_FLAG] = read_flag,
        [PARAM_WORD] = read_word, [PARAM_TEXT] = read_text, [PARAM_VECTOR] = read_vector,
        [PARAM_POINTS] = read_points, [PARAM_PAIRS] = read_pairs, [PARAM_WORDS] = read_words,
    };

    return read[wish->row->type](wish);
}

void scene_value_default(const struct scene_wish *wish)
{
    const double fallback = wish->row->fallback;
    const bool computed = isnan(fallback);

    switch (wish->row->type) {
    case PARAM_NUMBER:
        *(double *)wish->to = fallback;
        break;
    case PARAM_INTEGER:
        *(int *)wish->to = computed ? INT_MIN : (int)fallback;
        break;
    case PARAM_FLAG:
        *(bool *)wish->to = !computed && fallback != 0;
        break;
    case PARAM_WORD:
        *(const char **)wish->to = wish->row->words[0];
        break;
    case PARAM_TEXT:
        *(const char **)wish->to = "";
        break;
    case PARAM_VECTOR:
        for (int d = 0; d < 3; d++)
            ((double *)wish->to)[d] = d < wish->dimension ? fallback : 0;
        break;
    case PARAM_POINTS:
    case PARAM_PAIRS:
        *(struct param_points *)wish->to = (struct param_points){ 0 };
        break;
    case PARAM_WORDS:
        *(unsigned *)wish->to = computed ? 0 : (unsigned)fallback;
        break;
    }
}
