/* source.c -- the lines of a scene file and, in their places, of the files it includes. */
#include "scene/parse.h"
#include "base/status.h"

#include <ctype.h>
#include <errno.h>
#include <string.h>
#include <sys/stat.h>

struct source { /* a file being read and those that include it */
    const char *path;
    struct scene_place asked; /* by which line, file NULL for the first */
    const struct source *outer;
    struct stat id;
    int depth;
};

static int add_source(struct scene_parse *parse, struct source *source);

static int unreadable(const struct source *source, const char *why)
{
    if (!source->outer)
        return status_fail(STATUS_BAD_SCENE, "%s: cannot read this scene: %s", source->path, why);
    return status_fail(STATUS_BAD_SCENE, "%s: cannot include %s: %s (includes are looked for "
                       "beside the file that asks for them)",
                       scene_place_text(source->asked), source->path, why);
}

static int check_kind(const struct source *source)
{
    if (S_ISDIR(source->id.st_mode))
        return unreadable(source, "it is a directory, not a file");
    if (source->outer && !S_ISREG(source->id.st_mode))
        return unreadable(source, "it is no plain file, but a pipe or a device");
    if (source->depth > SCENE_INCLUDES_MAX)
        return unreadable(source, "too many files include each other");
    for (const struct source *s = source->outer; s; s = s->outer)
        if (s->id.st_dev == source->id.st_dev && s->id.st_ino == source->id.st_ino)
            return unreadable(source, "it includes itself in the end");
    return STATUS_DONE;
}

/* All bytes of the file and a zero. */
static int slurp(struct scene_parse *parse, const struct source *source, FILE *file, char **bytes)
{
    int n = 0, room = 0;
    size_t got;

    do {
        char *larger = scene_pool_grow(parse->pool, *bytes, n, &room, 1);

        if (!larger)
            return STATUS_FAILED;
        *bytes = larger;
        got = fread(*bytes + n, 1, (size_t)(room - n), file);
        n += (int)got;
        if (n > SCENE_BYTES_MAX - parse->read)
            return unreadable(source, "a scene with all its includes may have 8 MB");
    } while (got > 0);
    if (ferror(file))
        return unreadable(source, strerror(errno));
    if (memchr(*bytes, '\0', (size_t)n))
        return unreadable(source, "it holds zero bytes, so it is not a text file");
    parse->read += n;
    (*bytes)[n] = '\0'; /* there is room: the last read asked for a byte more */
    return STATUS_DONE;
}

static int load(struct scene_parse *parse, struct source *source, char **bytes)
{
    FILE *file;
    int status;

    if (stat(source->path, &source->id) != 0) /* before it is opened, which may wait for ever */
        return unreadable(source, strerror(errno));
    TRY(check_kind(source));
    file = fopen(source->path, "r");
    if (!file && errno == ENOMEM)
        return status_starved("%s cannot be read", source->path);
    if (!file)
        return unreadable(source, strerror(errno));
    status = fstat(fileno(file), &source->id) == 0 ? check_kind(source)
                                                   : unreadable(source, strerror(errno));
    if (status == STATUS_DONE)
        status = slurp(parse, source, file, bytes);
    fclose(file);
    return status;
}

/* The path of `name` seen from the file that includes it. */
static const char *beside(struct scene_pool *pool, const char *file, const char *name)
{
    const char *slash = strrchr(file, '/');

    if (name[0] == '/' || !slash)
        return scene_pool_print(pool, "%s", name);
    return scene_pool_print(pool, "%.*s/%s", (int)(slash - file), file, name);
}

static const char *skip_blanks(const char *s)
{
    while (isspace((unsigned char)*s))
        s++;
    return s;
}

static bool is_include(const char *line)
{
    return strncmp(skip_blanks(line), "@include", strlen("@include")) == 0;
}

static int include(struct scene_parse *parse, const struct source *source, int number,
                   const char *line)
{
    const struct scene_place at = { source->path, number };
    const char *name = skip_blanks(skip_blanks(line) + strlen("@include"));
    const char *end = name[0] == '"' ? strchr(name + 1, '"') : NULL;
    const char *rest = end ? skip_blanks(end + 1) : "";
    struct source inner = { .asked = at, .outer = source, .depth = source->depth + 1 };

    if (!end || end == name + 1 || (rest[0] && !strchr("#/;", rest[0])))
        return status_fail(STATUS_BAD_SCENE, "%s: an include is written alone on its line, "
                           "as @include \"file.cfg\"", scene_place_text(at));
    name = scene_pool_print(parse->pool, "%.*s", (int)(end - name - 1), name + 1);
    if (!name)
        return STATUS_FAILED;
    inner.path = beside(parse->keep, source->path, name);
    return inner.path ? add_source(parse, &inner) : STATUS_FAILED;
}

static int add_lines(struct scene_parse *parse, const struct source *source, char *bytes)
{
    int number = 0;

    if (strncmp(bytes, "\xEF\xBB\xBF", 3) == 0)
        bytes += 3; /* the mark that some editors put before UTF-8 */
    for (char *line = bytes, *end; line; line = end) {
        end = strchr(line, '\n');
        if (end)
            *end++ = '\0';
        number++;
        parse->included = source && source->outer;
        if (source && !parse->in_comment && is_include(line))
            TRY(include(parse, source, number, line));
        else
            TRY(scene_lex_line(parse, (struct scene_place){ source ? source->path : NULL, number },
                               line));
    }
    if (parse->in_comment)
        return status_fail(STATUS_BAD_SCENE, "%s: the comment that starts here never ends; "
                           "close it with */", scene_place_text(parse->comment));
    return STATUS_DONE;
}

static int add_source(struct scene_parse *parse, struct source *source)
{
    char *bytes = NULL;

    TRY(load(parse, source, &bytes));
    return add_lines(parse, source, bytes);
}

int scene_source_file(struct scene_parse *parse, const char *path)
{
    struct source source = { .path = path };

    TRY(add_source(parse, &source));
    return scene_lex_end(parse);
}

int scene_source_string(struct scene_parse *parse, const char *source)
{
    char *bytes = scene_pool_print(parse->pool, "%s", source);

    if (!bytes)
        return STATUS_FAILED;
    TRY(add_lines(parse, NULL, bytes));
    return scene_lex_end(parse);
}
