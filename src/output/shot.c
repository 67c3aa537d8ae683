/* shot.c -- one snapshot of a run, read back. */
#include "output/shot.h"

#include "base/status.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { HEAD = 3, MOST = 10 }; /* lines above the rows; columns */

char *shot_text(const char *path)
{
    FILE *in = fopen(path, "r");
    long size = -1;
    char *text = NULL;

    if (in && fseek(in, 0, SEEK_END) == 0)
        size = ftell(in);
    if (size >= 0 && fseek(in, 0, SEEK_SET) == 0)
        text = status_alloc((size_t)size + 1, 1);
    if (size < 0 || (text && fread(text, 1, (size_t)size, in) != (size_t)size)) {
        status_fail(STATUS_IO, "%s: cannot be read: %s", path, strerror(errno));
        free(text);
        text = NULL;
    }
    if (in)
        fclose(in);
    return text;
}

int shot_numbers(const char **at, double *to, int n)
{
    for (int i = 0; i < n; i++) {
        char *end;
        to[i] = strtod(*at, &end);
        if (end == *at || *end != (i + 1 < n ? ',' : '\n'))
            return 0;
        *at = end + 1;
    }
    return 1;
}

static int count_lines(const char *text)
{
    int n = 0;

    for (const char *at = strchr(text, '\n'); at; at = strchr(at + 1, '\n'))
        n++;
    return n;
}

static int make_room(struct shot *s)
{
    const int lines = count_lines(s->text);
    const size_t n = lines > HEAD ? (size_t)(lines - HEAD) : 0;

    s->n = (int)n;
    s->line = status_alloc(n + 1, sizeof *s->line);
    s->x = status_alloc(n + 1, sizeof *s->x);
    s->speed = status_alloc(n + 1, sizeof *s->speed);
    s->p = status_alloc(n + 1, sizeof *s->p);
    s->dye = status_alloc(n + 1, 1);
    s->kind = status_alloc(n + 1, 1);
    return s->line && s->x && s->speed && s->p && s->dye && s->kind ? STATUS_DONE : STATUS_FAILED;
}

/* x, u, rho, p, dye, kind */
static void take_row(struct shot *s, int i, int dim, const double *row)
{
    double squares = 0;

    for (int d = 0; d < dim; d++) {
        s->x[i][d] = (float)row[d];
        squares += row[dim + d] * row[dim + d];
    }
    s->speed[i] = (float)sqrt(squares);
    s->p[i] = (float)row[2 * dim + 1];
    s->dye[i] = (unsigned char)row[2 * dim + 2];
    s->kind[i] = (unsigned char)row[2 * dim + 3];
}

int shot_read(struct shot *s, const char *path, int dim)
{
    const char *at;
    double row[MOST];

    *s = (struct shot){ .text = shot_text(path) };
    if (!s->text)
        return STATUS_IO;
    TRY(make_room(s));
    at = s->text;
    for (int i = 0; i < HEAD && s->n > 0; i++)
        at = strchr(at, '\n') + 1;
    s->head = s->n > 0 ? (size_t)(at - s->text) : strlen(s->text);
    for (int i = 0; i < s->n; i++) {
        s->line[i] = (size_t)(at - s->text);
        if (!shot_numbers(&at, row, 2 * dim + 4))
            return status_fail(STATUS_IO, "%s:%d: this line is no particle, %d numbers with commas "
                               "between; run the scene again", path, HEAD + 1 + i, 2 * dim + 4);
        take_row(s, i, dim, row);
    }
    s->line[s->n] = (size_t)(at - s->text);
    return STATUS_DONE;
}

bool shot_is_wall(const struct shot *s, int i)
{
    return s->kind[i] > SHOT_FLUID && s->kind[i] < SHOT_SKIN;
}

void shot_free(struct shot *s)
{
    free(s->text);
    free(s->line);
    free(s->x);
    free(s->speed);
    free(s->p);
    free(s->dye);
    free(s->kind);
}
