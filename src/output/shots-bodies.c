/* shots-bodies.c -- rigid bodies as they are seen from above. */
#include "base/status.h"
#include "output/shots-inside.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct face {
    const char *rows;
    size_t length;
    double height; /* of its highest corner [m] */
};

/* Rows x, y, z, nx, ny, nz, body up to a line without any; 0: a line is something else. */
static int read_face(const char **at, struct face *f, double *up)
{
    double row[7];

    *f = (struct face){ .rows = *at, .height = -HUGE_VAL };
    while (**at && **at != '\n') {
        if (!shot_numbers(at, row, 7))
            return 0;
        f->height = fmax(f->height, row[2]);
        *up = row[5];
    }
    f->length = (size_t)(*at - f->rows);
    *at += strspn(*at, "\n");
    return 1;
}

static int by_height(const void *one, const void *two)
{
    const struct face *a = one, *b = two;

    return (a->height > b->height) - (a->height < b->height);
}

static int read_faces(const char *at, const char *path, struct face *face, int *n)
{
    double up = 0;

    *n = 0;
    while (*at) {
        if (!read_face(&at, &face[*n], &up))
            return status_fail(STATUS_IO, "%s: a line in it is no corner, 7 numbers with commas "
                               "between; run the scene again", path);
        *n += up > 0;
    }
    qsort(face, (size_t)*n, sizeof *face, by_height);
    return STATUS_DONE;
}

static int write_faces(const struct shots_scene *s, int k, const char *text, size_t head,
                       const struct face *face, int n)
{
    char path[ASIDE_PATH], name[32];
    struct aside a;

    snprintf(name, sizeof name, "floor-bodies-%d.csv", k + 1);
    TRY(aside_join(path, s->to, name));
    TRY(aside_open(&a, path));
    fwrite(text, 1, head, a.to);
    for (int i = 0; i < n; i++) {
        fwrite(face[i].rows, 1, face[i].length, a.to);
        fputs("\n\n", a.to); /* what gnuplot counts */
    }
    return aside_close(&a);
}

/* Bytes of the three lines of head. */
static size_t head_of(const char *text)
{
    const char *at = text;

    for (int i = 0; i < 3; i++)
        at += strcspn(at, "\n") + (at[strcspn(at, "\n")] == '\n');
    return (size_t)(at - text);
}

int shots_bodies(const struct shots_scene *s, int k)
{
    char path[ASIDE_PATH], name[80], *text;
    struct face *face;
    int n, code;

    snprintf(name, sizeof name, "%s-bodies.csv", s->moment[k].name);
    TRY(aside_join(path, s->run, name));
    if (access(path, F_OK) != 0)
        return STATUS_DONE;
    text = shot_text(path);
    if (!text)
        return STATUS_IO;
    face = status_alloc(strlen(text) / 16 + 1, sizeof *face); /* a row has no fewer signs */
    code = face ? read_faces(text + head_of(text), path, face, &n) : STATUS_FAILED;
    if (code == STATUS_DONE)
        code = write_faces(s, k, text, head_of(text), face, n);
    free(face);
    free(text);
    return code;
}
