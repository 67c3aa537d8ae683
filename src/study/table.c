/* table.c -- numbers of a CSV file. */
#include "study/table.h"

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
    FILE *from = fopen(path, "r");
    char *line = NULL;
    size_t size = 0;
    int room = 0;
    bool fine = from;

    *t = (struct table){0};
    while (fine && getline(&line, &size, from) >= 0) {
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
