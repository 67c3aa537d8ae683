/* figures-data.c -- constants of figures as data. */
#include "output/figures-data.h"

#include "base/status.h"
#include "output/aside.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* gnuplot divides whole numbers as C does: 1 / 2 is 0.  A point makes a number of any value a real one. */
void figures_data_number(FILE *to, const char *name, double value)
{
    char text[32];

    snprintf(text, sizeof text, "%.17g", value + 0.0);
    if (isfinite(value))
        fprintf(to, "%s = %s%s\n", name, text, strpbrk(text, ".e") ? "" : ".0");
    else
        fprintf(to, "%s = NaN\n", name);
}

/* Bytes of UTF-8 are above 0x7f. */
static bool is_plain(unsigned char c)
{
    return c >= 0x80 || isalnum(c) || (c && strchr(" .,:;()[]+-*/=_", c));
}

void figures_data_text(FILE *to, const char *name, const char *text)
{
    fprintf(to, "%s = \"", name);
    for (; text && *text; text++) {
        const unsigned char c = (unsigned char)*text;
        if (is_plain(c))
            fputc(c, to);
        else
            fprintf(to, "\\%03o", c < 0x20 ? ' ' : c);
    }
    fputs("\"\n", to);
}

static bool is_number(const char *text)
{
    char *end;

    if (strcmp(text, "NaN") == 0)
        return true;
    if (!*text || strspn(text, "0123456789+-.e") != strlen(text))
        return false;
    strtod(text, &end);
    return !*end;
}

/* Signs as figures_data_text() writes them, between quotes. */
static bool is_text(const char *text)
{
    if (*text++ != '"')
        return false;
    for (; *text && *text != '"'; text++)
        if (*text == '\\') {
            if (strspn(text + 1, "01234567") < 3)
                return false;
            text += 3;
        } else if (!is_plain((unsigned char)*text)) {
            return false;
        }
    return text[0] == '"' && !text[1];
}

static bool is_assignment(const char *line)
{
    const char *at = line;

    if (!isalpha((unsigned char)*at))
        return false;
    while (isalnum((unsigned char)*at) || *at == '_')
        at++;
    return strncmp(at, " = ", 3) == 0 && (is_number(at + 3) || is_text(at + 3));
}

static int copy_lines(FILE *in, const char *from, FILE *to)
{
    char *line = NULL;
    size_t room = 0;
    int status = STATUS_DONE;

    for (int n = 1; status == STATUS_DONE && getline(&line, &room, in) >= 0; n++) {
        line[strcspn(line, "\n")] = '\0';
        if (*line == '#' || !*line)
            continue;
        if (is_assignment(line))
            fprintf(to, "%s\n", line);
        else
            status = status_fail(STATUS_IO, "%s:%d: this line is no constant, NAME = NUMBER or "
                                 "NAME = \"TEXT\", and is not carried out; take it away, or run "
                                 "the scene again", from, n);
    }
    free(line);
    return status;
}

int figures_data_copy(const char *from, const char *to)
{
    FILE *in = fopen(from, "r");
    struct aside a;
    int status;

    if (!in)
        return status_fail(STATUS_IO, "%s: cannot be read: %s", from, strerror(errno));
    status = aside_open(&a, to);
    if (status == STATUS_DONE) {
        status = copy_lines(in, from, a.to);
        if (status == STATUS_DONE)
            status = aside_close(&a);
        else
            aside_drop(&a);
    }
    fclose(in);
    return status;
}

/* What stands behind "NAME = " in a file, in a line to be freed; NULL: there is none. */
static char *value_of(const char *path, const char *name)
{
    const size_t n = strlen(name);
    char *line = NULL, *value = NULL;
    size_t room = 0;
    FILE *in = fopen(path, "r");

    while (in && !value && getline(&line, &room, in) >= 0)
        if (strncmp(line, name, n) == 0 && strncmp(line + n, " = ", 3) == 0)
            value = strdup(line + n + 3);
    free(line);
    if (in)
        fclose(in);
    return value;
}

double figures_data_constant(const char *path, const char *name)
{
    char *text = value_of(path, name);
    const double value = text ? strtod(text, NULL) : NAN;

    free(text);
    return value;
}

bool figures_data_word(const char *path, const char *name, int i, char *to, size_t size)
{
    char *text = value_of(path, name), *rest = NULL;
    const char *word = text ? strtok_r(text, "\" \n", &rest) : NULL;

    for (; word && i > 0; i--)
        word = strtok_r(NULL, "\" \n", &rest);
    if (word)
        snprintf(to, size, "%s", word);
    free(text);
    return word != NULL;
}
