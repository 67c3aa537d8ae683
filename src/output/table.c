/* table.c -- numbers of a CSV file. */
#include "output/table.h"

#include "base/status.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool read_names(struct table *t, char *line)
{
    t->names = strdup(line);
    t->name = status_alloc(strlen(line) + 1, sizeof *t->name);
    if (!t->names || !t->name)
        return false;
    t->names[strcspn(t->names, "\r\n")] = '\0';
    for (char *rest = t->names; rest;)
        t->name[t->columns++] = strsep(&rest, ",");
    return true;
}

/* Numbers of a line; a field that is none, or that is missing, is NAN. */
static void read_row(struct table *t, const char *line)
{
    double *to = t->value + (size_t)t->rows++ * t->columns;

    for (int i = 0; i < t->columns; i++) {
        char *end = (char *)line;
        to[i] = *line ? strtod(line, &end) : NAN;
        if (end == line || !strchr(",\r\n", *end))
            to[i] = NAN;
        line += strcspn(line, ",");
        line += *line == ',';
    }
}

static bool make_room(struct table *t, int *room)
{
    double *more;

    if (t->rows < *room)
        return true;
    *room = *room ? 2 * *room : 1024;
    more = realloc(t->value, (size_t)*room * t->columns * sizeof *more);
    if (more)
        t->value = more;
    return more;
}

bool table_read(struct table *t, const char *path)
{
    static const char units[] = "# units: ";
    FILE *from = fopen(path, "r");
    char *line = NULL;
    size_t size = 0;
    int room = 0;
    bool fine = from;

    *t = (struct table){0};
    while (fine && getline(&line, &size, from) >= 0) {
        if (strncmp(line, units, strlen(units)) == 0 && !t->units)
            t->units = strdup(line + strlen(units));
        if (*line == '#' || *line == '\n')
            continue;
        if (!t->name)
            fine = read_names(t, line);
        else if ((fine = make_room(t, &room)))
            read_row(t, line);
    }
    free(line);
    if (from)
        fclose(from);
    if (!fine || !t->name)
        table_free(t);
    return t->name;
}

void table_free(struct table *t)
{
    free(t->name);
    free(t->names);
    free(t->units);
    free(t->value);
    *t = (struct table){0};
}

int table_column(const struct table *t, const char *name)
{
    for (int i = 0; i < t->columns; i++)
        if (strcmp(t->name[i], name) == 0)
            return i;
    return -1;
}

double table_at(const struct table *t, int row, int column)
{
    return t->value[(size_t)row * t->columns + column];
}

void table_unit(const struct table *t, int column, char *to, unsigned long size)
{
    const char *at = t->units ? t->units : "";

    for (; column > 0 && *at; column--) {
        at += strcspn(at, ",");
        at += *at == ',';
    }
    snprintf(to, size, "%.*s", (int)strcspn(at, ",\r\n"), at);
}

bool table_alike(const struct table *a, const struct table *b)
{
    if (a->columns != b->columns || a->rows != b->rows || a->rows == 0)
        return false;
    for (int i = 0; i < a->columns; i++)
        if (strcmp(a->name[i], b->name[i]) != 0)
            return false;
    return true;
}

bool table_same_times(const struct table *a, const struct table *b)
{
    for (int i = 0; i < a->rows; i++)
        if (!(fabs(table_at(a, i, 0) - table_at(b, i, 0))
              <= 1e-9 * fabs(table_at(b, b->rows - 1, 0))))
            return false;
    return true;
}

void table_put(FILE *to, double value)
{
    if (isnan(value))
        fputs(",nan", to);
    else
        fprintf(to, ",%.8g", value);
}

static void quote(FILE *to, const char *what)
{
    fputc('"', to);
    for (; *what; what++)
        fputc(*what == '"' ? '\'' : *what == '\n' ? ' ' : *what, to);
    fputc('"', to);
}

void table_put_text(FILE *to, const char *what)
{
    fputc(',', to);
    quote(to, what);
}

void table_put_word(FILE *to, const char *what)
{
    fputc(',', to);
    table_put_first(to, what);
}

void table_put_first(FILE *to, const char *what)
{
    for (; *what; what++)
        if (*what != '"')
            fputc(*what == ',' ? ';' : *what, to);
}
