/* json-find.c -- reads back what json.c wrote, which puts every key, and every text of a list,
 * on a line of its own. */
#include "output/json-find.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A file with the line that was read last; value: what stands behind the key in it. */
struct finder {
    FILE *from;
    char *line, *value;
    size_t room;
};

static bool next_line(struct finder *f)
{
    if (getline(&f->line, &f->room, f->from) < 0)
        return false;
    f->value = f->line + strspn(f->line, " ");
    return true;
}

static bool find(struct finder *f, const char *path, const char *key)
{
    char quoted[80];

    *f = (struct finder){ .from = fopen(path, "r") };
    snprintf(quoted, sizeof quoted, "\"%s\": ", key);
    while (f->from && next_line(f))
        if (strncmp(f->value, quoted, strlen(quoted)) == 0) {
            f->value += strlen(quoted);
            return true;
        }
    return false;
}

static void end(struct finder *f)
{
    if (f->from)
        fclose(f->from);
    free(f->line);
}

/* The escapes that json.c writes. */
static bool take_text(const char *at, char *to, size_t size)
{
    size_t n = 0;

    if (*at++ != '"')
        return false;
    for (; *at && *at != '"' && n + 4 < size; at++) {
        if (at[0] == '\\' && at[1] == 'u' && strlen(at) > 5) {
            const bool unknown = strncmp(at + 2, "fffd", 4) == 0;
            n += (size_t)snprintf(to + n, size - n, "%s", unknown ? "\xef\xbf\xbd" : " ");
            at += 5;
            continue;
        }
        at += at[0] == '\\' && at[1];
        to[n++] = *at;
    }
    to[n] = '\0';
    return true;
}

double json_find_number(const char *path, const char *key)
{
    struct finder f;
    double value = NAN;
    char *behind;

    if (find(&f, path, key)) {
        value = strtod(f.value, &behind);
        if (behind == f.value)
            value = NAN;
    }
    end(&f);
    return value;
}

bool json_find_text(const char *path, const char *key, char *to, unsigned long size)
{
    struct finder f;
    bool found;

    *to = '\0';
    found = find(&f, path, key) && take_text(f.value, to, size);
    end(&f);
    return found;
}

bool json_find_item(const char *path, const char *key, int i, char *to, unsigned long size)
{
    struct finder f;
    bool found;

    *to = '\0';
    found = find(&f, path, key) && strncmp(f.value, "[\n", 2) == 0;
    for (; found && i >= 0; i--)
        found = next_line(&f) && f.value[0] == '"';
    found = found && take_text(f.value, to, size);
    end(&f);
    return found;
}
