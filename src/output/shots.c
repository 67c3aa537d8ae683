/* shots.c -- what pictures of particles at several moments show. */
#include "output/shots.h"

#include "base/status.h"
#include "output/figures-data.h"
#include "output/shots-inside.h"

#include <math.h>
#include <stdlib.h>

static int by_value(const void *one, const void *two)
{
    const float a = *(const float *)one, b = *(const float *)two;

    return (a > b) - (a < b);
}

struct scales {
    double low, high, fastest; /* pressures that 1 of 40 is below, above [Pa]; speed [m/s] */
    int dyes, walls, skins;    /* the highest dye, -1: no water; particles                 */
};

static int take_scales(const struct shot *s, struct scales *to)
{
    float *p = status_alloc((size_t)s->n + 1, sizeof *p);
    int n = 0;

    if (!p)
        return STATUS_FAILED;
    *to = (struct scales){ .dyes = -1 };
    for (int i = 0; i < s->n; i++) {
        to->walls += shot_is_wall(s, i);
        to->skins += s->kind[i] >= SHOT_SKIN;
        if (s->kind[i] != SHOT_FLUID)
            continue;
        p[n++] = s->p[i];
        to->fastest = fmax(to->fastest, s->speed[i]);
        to->dyes = s->dye[i] > to->dyes ? s->dye[i] : to->dyes;
    }
    qsort(p, (size_t)n, sizeof *p, by_value);
    if (n > 0) {
        to->low = p[n / 40];
        to->high = p[n - 1 - n / 40];
    }
    free(p);
    return STATUS_DONE;
}

static bool is_in(const struct shots_scene *scene, int up, const float *x)
{
    if (scene->dim == 2)
        return true;
    if (up == 1)
        return x[2] > scene->low[2] && x[2] < scene->low[2] + 3 * scene->dx;
    return fabs(x[1] - (scene->low[1] + scene->high[1]) / 2) < 1.01 * scene->dx;
}

/* In the order in which they are drawn: walls, fluid, skins. */
static void look(const struct shots_scene *scene, const struct shots_picture *p, int up,
                 const struct shot *s, struct canvas *c)
{
    const double r = shots_radius(scene, p);

    for (int i = 0; i < s->n; i++)
        if (is_in(scene, up, s->x[i]))
            canvas_disc(c, s->x[i][0], s->x[i][up], r,
                        shot_is_wall(s, i) ? 0 : s->kind[i] == SHOT_FLUID ? 1 : 2, i);
}

static int write_rows(const char *path, const struct shot *s, const unsigned char *seen)
{
    struct aside a;

    TRY(aside_open(&a, path));
    fwrite(s->text, 1, s->head, a.to);
    for (int i = 0; i < s->n; i++)
        if (seen[i])
            fwrite(s->text + s->line[i], 1, s->line[i + 1] - s->line[i], a.to);
    return aside_close(&a);
}

/* TO/NAME-K.csv. */
static int flat(const struct shots_scene *scene, const struct shots_picture *p, int up,
                const struct shot *s, int k)
{
    char path[ASIDE_PATH], name[32];
    unsigned char *seen = status_alloc((size_t)s->n + 1, 1);
    struct canvas c;
    int code = shots_canvas(p, &c);

    snprintf(name, sizeof name, "%s-%d.csv", p->name, k + 1);
    if (code == STATUS_DONE)
        code = seen ? aside_join(path, scene->to, name) : STATUS_FAILED;
    if (code == STATUS_DONE) {
        look(scene, p, up, s, &c);
        canvas_mark(&c, seen);
        code = write_rows(path, s, seen);
    }
    canvas_free(&c);
    free(seen);
    return code;
}

/* --- all ------------------------------------------------------------------------------- */

enum { CUT, FLOOR, VIEW, PICTURES };

static void tell_picture(FILE *to, const struct shots_picture *p)
{
    const struct {
        const char *what;
        double value;
    } row[] = { { "left", p->left }, { "right", p->right }, { "bottom", p->bottom },
                { "above", p->above }, { "pixel", p->pixel }, { "across", p->across } };
    char name[32];

    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        snprintf(name, sizeof name, "%s_%s", p->name, row[i].what);
        figures_data_number(to, name, row[i].value);
    }
}

static int tell_pictures(const struct shots_scene *s, const struct shots_picture *p)
{
    char path[ASIDE_PATH];
    struct aside a;

    TRY(aside_join(path, s->to, "shots.gp"));
    TRY(aside_open(&a, path));
    fputs("# shots.gp -- pictures of particles: corners and pixels [m], panels in a row\n", a.to);
    fprintf(a.to, "moments = %d\n", s->moments);
    for (int i = 0; i < (s->dim == 2 ? 1 : PICTURES); i++)
        tell_picture(a.to, &p[i]);
    figures_data_number(a.to, "turn", SHOTS_TURN);
    figures_data_number(a.to, "tilt", SHOTS_TILT);
    return aside_close(&a);
}

/* Its files and its row. */
static int tell_moment(const struct shots_scene *s, const struct shots_picture *p, int k, FILE *to)
{
    const struct shots_moment *m = &s->moment[k];
    struct shot shot;
    struct scales is;
    int code = shots_read(s, k, &shot);

    if (code == STATUS_DONE)
        code = take_scales(&shot, &is);
    if (code == STATUS_DONE) {
        fprintf(to, "%.12g,../%s,%.9g,%.9g,%.9g,%d,%d,%d\n", m->t, m->name, is.low, is.high,
                is.fastest, is.dyes, is.walls, is.skins);
        code = flat(s, &p[CUT], s->dim - 1, &shot, k);
    }
    if (code == STATUS_DONE && s->dim == 3)
        code = flat(s, &p[FLOOR], 1, &shot, k);
    if (code == STATUS_DONE && s->dim == 3)
        code = shots_view(s, &p[VIEW], &shot, k);
    if (code == STATUS_DONE && s->dim == 3)
        code = shots_bodies(s, k);
    shot_free(&shot);
    return code;
}

static int tell_moments(const struct shots_scene *s, const struct shots_picture *p)
{
    char path[ASIDE_PATH];
    struct aside a;
    int code = STATUS_DONE;

    TRY(aside_join(path, s->to, "shots.csv"));
    TRY(aside_open(&a, path));
    fputs("# units: s,,Pa,Pa,m/s,,,\nt,name,p_low,p_high,fastest,dye,walls,skins\n", a.to);
    for (int k = 0; k < s->moments && code == STATUS_DONE; k++)
        code = tell_moment(s, p, k, a.to);
    if (code == STATUS_DONE)
        return aside_close(&a);
    aside_drop(&a);
    return code;
}

int shots_prepare(const char *run, const char *to)
{
    struct shots_scene s;
    struct shots_picture p[PICTURES] = {
        [CUT] = { .name = "cut" }, [FLOOR] = { .name = "floor" }, [VIEW] = { .name = "view" } };

    TRY(shots_scene(&s, run, to));
    shots_flat(&s, s.dim - 1, &p[CUT]);
    shots_flat(&s, 1, &p[FLOOR]);
    shots_whole(&s, &p[VIEW]);
    TRY(tell_pictures(&s, p));
    return tell_moments(&s, p);
}
