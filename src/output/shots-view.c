/* shots-view.c -- all that is seen of a tank from the side and above, without perspective. */
#include "base/status.h"
#include "output/shots-inside.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { FACE, EDGE, FLUID, WALL };

struct item {
    float x, y, r, depth, value;
    int what;
};

struct view {
    const struct shots_scene *scene;
    struct item *item;
    int n, room;
};

static void put(struct view *v, const double *x, double r, double nearer, int what, double value)
{
    const struct shots_scene *s = v->scene;
    const double from_x = x[0] - (s->low[0] + s->high[0]) / 2;
    const double from_y = x[1] - (s->low[1] + s->high[1]) / 2;
    const double away = from_y * cos(SHOTS_TURN) - from_x * sin(SHOTS_TURN);

    if (v->n == v->room)
        return;
    v->item[v->n++] = (struct item){
        .x = (float)(from_x * cos(SHOTS_TURN) + from_y * sin(SHOTS_TURN)),
        .y = (float)(x[2] * cos(SHOTS_TILT) + away * sin(SHOTS_TILT)),
        .depth = (float)(nearer + x[2] * sin(SHOTS_TILT) - away * cos(SHOTS_TILT)),
        .r = (float)r, .what = what, .value = (float)value };
}

/* Faces that look the other way are not seen.  Light falls from above and the left in front. */
static void put_point(struct view *v, const double *row, double pixel)
{
    const double *n = row + 3, dx = v->scene->dx;
    const double away = n[1] * cos(SHOTS_TURN) - n[0] * sin(SHOTS_TURN);
    const double lit = 0.35 + 0.65 * fmax(0, -0.45 * n[0] - 0.5 * n[1] + 0.74 * n[2]);

    if (away * cos(SHOTS_TILT) - n[2] * sin(SHOTS_TILT) >= 0)
        return;
    if (row[6] == FACE)
        put(v, row, fmax(0.3 * dx, 0.75 * pixel), 0.3 * dx, FACE, lit);
    else
        put(v, row, fmax(0.12 * dx, 0.5 * pixel), 0.6 * dx, EDGE, 0);
}

/* Rows x, y, z, nx, ny, nz, what, body, before those of particles. */
static int put_bodies(struct view *v, const char *text, const char *path, double pixel)
{
    double row[8];

    for (int i = 0; i < 3 && text; i++)
        text = strchr(text, '\n') ? strchr(text, '\n') + 1 : NULL;
    while (text && *text) {
        if (!shot_numbers(&text, row, 8))
            return status_fail(STATUS_IO, "%s: a line in it is no point, 8 numbers with commas "
                               "between; run the scene again", path);
        if (row[6] > EDGE)
            break;
        put_point(v, row, pixel);
    }
    return STATUS_DONE;
}

static bool is_inside(const struct shots_scene *s, const float *x)
{
    for (int d = 0; d < 3; d++)
        if (!(x[d] > s->low[d] && x[d] < s->high[d]))
            return false;
    return true;
}

/* Solids within the tank, whose own walls would hide it; skins of bodies hide below surfaces. */
static void put_particles(struct view *v, const struct shot *s, double r, bool shaped)
{
    for (int i = 0; i < s->n; i++) {
        const double x[3] = { s->x[i][0], s->x[i][1], s->x[i][2] };
        const bool fluid = s->kind[i] == SHOT_FLUID;
        if (fluid || (is_inside(v->scene, s->x[i]) && !(shaped && s->kind[i] >= SHOT_SKIN)))
            put(v, x, r, 0, fluid ? FLUID : WALL, fluid ? s->speed[i] : 0);
    }
}

static int by_depth(const void *one, const void *two)
{
    const struct item *a = one, *b = two;

    return (a->depth > b->depth) - (a->depth < b->depth);
}

/* Those that are seen to the front of the list, what is far first. */
static int sift(struct view *v, const struct shots_picture *p)
{
    unsigned char *seen = status_alloc((size_t)v->n + 1, 1);
    struct canvas c;
    int n = 0, code = shots_canvas(p, &c);

    if (code == STATUS_DONE && seen) {
        for (int i = 0; i < v->n; i++)
            canvas_disc(&c, v->item[i].x, v->item[i].y, v->item[i].r, v->item[i].depth, i);
        canvas_mark(&c, seen);
        for (int i = 0; i < v->n; i++)
            if (seen[i])
                v->item[n++] = v->item[i];
        v->n = n;
        qsort(v->item, (size_t)n, sizeof *v->item, by_depth);
    }
    canvas_free(&c);
    code = seen ? code : STATUS_FAILED;
    free(seen);
    return code;
}

static int write_view(const struct view *v, int k)
{
    char path[ASIDE_PATH], name[32];
    struct aside a;

    snprintf(name, sizeof name, "view-%d.csv", k + 1);
    TRY(aside_join(path, v->scene->to, name));
    TRY(aside_open(&a, path));
    fprintf(a.to, "# t = %.12g s\n# units: m,m,m,,\nx,y,r,what,value\n", v->scene->moment[k].t);
    for (int i = 0; i < v->n; i++)
        fprintf(a.to, "%.6g,%.6g,%.4g,%d,%.4g\n", v->item[i].x, v->item[i].y, v->item[i].r,
                v->item[i].what, v->item[i].value);
    return aside_close(&a);
}

/* The text of points on bodies; NULL also where there are none. */
static int read_bodies(const struct shots_scene *s, int k, char path[ASIDE_PATH], char **text)
{
    char name[80];

    *text = NULL;
    snprintf(name, sizeof name, "%s-surface.csv", s->moment[k].name);
    TRY(aside_join(path, s->run, name));
    if (access(path, F_OK) != 0)
        return STATUS_DONE;
    *text = shot_text(path);
    return *text ? STATUS_DONE : STATUS_IO;
}

static int count_lines(const char *text)
{
    int n = 0;

    for (; text && *text; text++)
        n += *text == '\n';
    return n;
}

int shots_view(const struct shots_scene *scene, const struct shots_picture *p, const struct shot *s,
               int k)
{
    struct view v = { .scene = scene };
    char path[ASIDE_PATH], *bodies;
    int code;

    TRY(read_bodies(scene, k, path, &bodies));
    v.room = s->n + count_lines(bodies) + 1;
    v.item = status_alloc((size_t)v.room, sizeof *v.item);
    code = v.item ? put_bodies(&v, bodies, path, p->pixel) : STATUS_FAILED;
    if (code == STATUS_DONE) {
        put_particles(&v, s, shots_radius(scene, p), bodies != NULL);
        code = sift(&v, p);
    }
    if (code == STATUS_DONE)
        code = write_view(&v, k);
    free(v.item);
    free(bodies);
    return code;
}
