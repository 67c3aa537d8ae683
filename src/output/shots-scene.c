/* shots-scene.c -- the scene of pictures of particles: its tank, and which moments are shown. */
#include "base/status.h"
#include "output/figures-data.h"
#include "output/shots-inside.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int read_scene(struct shots_scene *s)
{
    char path[ASIDE_PATH], name[16];

    TRY(aside_join(path, s->to, "constants.gp"));
    s->dim = figures_data_constant(path, "dim") == 3 ? 3 : 2;
    s->dx = figures_data_constant(path, "dx");
    for (int d = 0; d < s->dim; d++) {
        snprintf(name, sizeof name, "low_%c", "xyz"[d]);
        s->low[d] = figures_data_constant(path, name);
        snprintf(name, sizeof name, "high_%c", "xyz"[d]);
        s->high[d] = figures_data_constant(path, name);
    }
    s->moves = figures_data_constant(path, "walls_move") != 0; /* an older version did not say: NAN */
    return s->dx > 0 ? STATUS_DONE : status_fail(STATUS_IO, "%s: there is no spacing dx in it; run "
                                                 "the scene again", path);
}

/* Which of n moments is panel k: the first, the last, and those between at equal distances. */
static int which(const struct shots_scene *s, int k, int n)
{
    return s->moments > 1 ? (int)((double)k * (n - 1) / (s->moments - 1) + 0.5) : 0;
}

/* Rows "t,snapshots/0003.csv": how many; those that are shown are put down if n, which this gave
 * before, is not 0. */
static int scan_moments(const char *text, struct shots_scene *s, int n)
{
    struct shots_moment one;
    int found = 0;

    for (const char *at = text; at; at = strchr(at, '\n')) {
        at += *at == '\n';
        if (sscanf(at, "%lf,%63[^.\n].csv", &one.t, one.name) != 2)
            continue;
        for (int k = 0; n > 0 && k < s->moments; k++)
            if (found == which(s, k, n))
                s->moment[k] = one;
        found++;
    }
    return found;
}

static int choose_moments(struct shots_scene *s)
{
    char path[ASIDE_PATH];
    char *text;
    int n;

    TRY(aside_join(path, s->run, "snapshots.csv"));
    text = shot_text(path);
    if (!text)
        return STATUS_IO;
    n = scan_moments(text, s, 0);
    s->moments = n < SHOTS_MOST ? n : SHOTS_MOST;
    scan_moments(text, s, n);
    free(text);
    return STATUS_DONE;
}

int shots_read(const struct shots_scene *s, int k, struct shot *shot)
{
    char path[ASIDE_PATH], name[80];

    snprintf(name, sizeof name, "%s.csv", s->moment[k].name);
    TRY(aside_join(path, s->run, name));
    return shot_read(shot, path, s->dim);
}

/* Where the walls of a moment end along each axis. */
static void wall_ends(const struct shot *s, double low[3], double high[3])
{
    for (int d = 0; d < 3; d++) {
        low[d] = HUGE_VAL;
        high[d] = -HUGE_VAL;
        for (int i = 0; i < s->n; i++)
            if (shot_is_wall(s, i)) {
                low[d] = fmin(low[d], s->x[i][d]);
                high[d] = fmax(high[d], s->x[i][d]);
            }
    }
}

/* A tank moves where all its outermost walls have gone one way: pictures are to have room for it. */
static int follow_walls(struct shots_scene *s)
{
    double first_low[3], first_high[3], low[3], high[3];

    for (int k = 0; k < s->moments && s->moves; k++) {
        struct shot shot;
        const int code = shots_read(s, k, &shot);
        if (code == STATUS_DONE)
            wall_ends(&shot, k > 0 ? low : first_low, k > 0 ? high : first_high);
        shot_free(&shot);
        TRY(code);
        for (int d = 0; d < s->dim && k > 0; d++) {
            const double way = low[d] - first_low[d];
            if (!(fabs(way - (high[d] - first_high[d])) < s->dx))
                continue;
            s->down[d] = fmin(s->down[d], way);
            s->up[d] = fmax(s->up[d], way);
        }
    }
    return STATUS_DONE;
}

int shots_scene(struct shots_scene *s, const char *run, const char *to)
{
    *s = (struct shots_scene){ .run = run, .to = to };
    TRY(read_scene(s));
    TRY(choose_moments(s));
    return follow_walls(s);
}

/* --- pictures -------------------------------------------------------------------------- */

/* Panels of equal scale in two rows of three, those of long tanks in three of two, on a sheet of
 * 1560 pixels; a panel is no higher than 900. */
static void arrange(const struct shots_scene *s, struct shots_picture *p)
{
    const double wide = p->right - p->left, high = p->above - p->bottom;
    const bool is_long = high < 0.45 * wide;

    p->across = s->moments < 3 ? s->moments
              : s->moments == 4 || (is_long && s->moments > 4) ? 2 : 3;
    p->pixel = fmax(wide / (1560.0 / fmax(1, p->across) - 24), high / 900);
}

void shots_flat(const struct shots_scene *s, int up, struct shots_picture *p)
{
    const double rim = 3.5 * s->dx;

    p->left = s->low[0] - rim + s->down[0];
    p->right = s->high[0] + rim + s->up[0];
    p->bottom = s->low[up] - rim + s->down[up];
    p->above = s->high[up] + rim + s->up[up];
    arrange(s, p);
}

void shots_whole(const struct shots_scene *s, struct shots_picture *p)
{
    const double rim = 3.5 * s->dx;
    const double half_x = (s->high[0] - s->low[0]) / 2, half_y = (s->high[1] - s->low[1]) / 2;
    const double side = half_x * cos(SHOTS_TURN) + half_y * sin(SHOTS_TURN);
    const double back = half_x * sin(SHOTS_TURN) + half_y * cos(SHOTS_TURN);

    p->left = -side - rim;
    p->right = side + rim;
    p->bottom = s->low[2] * cos(SHOTS_TILT) - back * sin(SHOTS_TILT) - rim;
    p->above = s->high[2] * cos(SHOTS_TILT) + back * sin(SHOTS_TILT) + rim;
    arrange(s, p);
}

double shots_radius(const struct shots_scene *s, const struct shots_picture *p)
{
    return fmax(0.65 * s->dx, 0.75 * p->pixel);
}

int shots_canvas(const struct shots_picture *p, struct canvas *c)
{
    return canvas_make(c, p->left, p->right, p->bottom, p->above, p->pixel / 2);
}
