/* spread.c -- an error bar: runs of one scene that differ by next to nothing.
 *
 * Water that has hit something is chaotic: whatever differs grows until it is as large as the
 * flow allows, and what a single run then shows is one of many answers that are as right.  A
 * disturbance far below all errors shows how many there are. */
#include "study/spread.h"

#include "base/status.h"
#include "run/stop.h"
#include "scene/scene.h"
#include "study/crew.h"
#include "study/picture.h"
#include "study/quantity.h"
#include "study/spread-inside.h"

#include <math.h>
#include <stdlib.h>

static const char *const files[] = {
    "spread.csv", "spread.json", "spread.md", "spread-positions.csv", "spread-front.csv",
    "spread-forces.csv", "spread-beam.csv", "spread-probes.csv", "report.html", NULL,
};
static const char *const folders[] = { "figures", "runs", NULL };
static const struct mark_owner owner = { "spread", files, folders, NULL };

static int read_scene(struct spread *s)
{
    struct scene *scene = NULL;
    int status = scene_read(s->order->scene, &scene);

    for (int i = 0; i < s->order->overrides && status == STATUS_DONE; i++)
        status = scene_override(scene, s->order->override[i]);
    if (status == STATUS_DONE)
        status = facts_read(scene, &s->facts);
    scene_free(&scene);
    return status;
}

static int choose_window(struct spread *s)
{
    const double *w = s->order->window;

    s->window[0] = isnan(w[0]) ? 0 : w[0];
    s->window[1] = isnan(w[1]) ? s->facts.until : w[1];
    if (s->window[0] < s->window[1] && s->window[1] <= s->facts.until * (1 + 1e-9))
        return STATUS_DONE;
    return status_fail(STATUS_BAD_SCENE, "--window %g,%g: the runs last from 0 to %g s, and a "
                       "window is FROM,TO within that, FROM first", s->window[0], s->window[1],
                       s->facts.until);
}

static int check_fluid(const struct spread *s)
{
    if (s->facts.fluid)
        return STATUS_DONE;
    return status_fail(STATUS_BAD_SCENE, "%s: spread shifts particles of fluid at the start, and "
                       "there is no fluid: all runs would be one and the same; `stiffwater run` "
                       "tells what it is", s->order->scene);
}

static int prepare(struct spread *s)
{
    s->home = (struct member_home){
        .scene = s->order->scene, .overrides = s->order->overrides,
        .override = s->order->override, .threads = s->order->threads, .budget = s->order->budget,
        .owner = &owner, .force = s->order->force,
    };
    TRY(read_scene(s));
    TRY(check_fluid(s));
    TRY(choose_window(s));
    TRY(member_home_make(&s->home, s->order->directory, "-spread"));
    s->member = status_alloc(s->order->runs, sizeof *s->member);
    if (!s->member)
        return STATUS_FAILED;
    for (int i = 0; i < s->order->runs; i++) {
        s->member[i].until = s->facts.until;
        snprintf(s->member[i].name, sizeof s->member[i].name, "seed-%d", s->order->seed + i);
    }
    return member_home_claim(&s->home);
}

static struct member *member(void *self, int i)
{
    struct spread *s = self;

    return &s->member[i];
}

static char *settings(void *self, int i)
{
    const struct spread *s = self;
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);

    if (!to)
        return NULL;
    fprintf(to, "disturbance.size=%.17g\ndisturbance.seed=%d\n", s->order->size,
            s->order->seed + i);
    fprintf(to, "output.snapshots=%d\noutput.fields=%.17g\n", SPREAD_INSIDE_PICTURES + 1,
            s->facts.until);
    fclose(to);
    return text;
}

/* The first run that no other seed would help: the scene or the disk is wrong. */
static const struct member *refused(const struct spread *s)
{
    for (int i = 0; i < s->order->runs; i++)
        if (s->member[i].ended
            && (s->member[i].code == STATUS_BAD_SCENE || s->member[i].code == STATUS_IO))
            return &s->member[i];
    return NULL;
}

static bool is_wanted(void *self, int i)
{
    (void)i;
    return !refused(self);
}

static int carry_out(struct spread *s)
{
    const struct crew crew = {
        .home = &s->home, .what = "runs", .n = s->order->runs, .jobs = s->order->jobs,
        .budget = s->order->budget, .quiet = s->order->quiet, .member = member,
        .settings = settings, .wanted = is_wanted, .self = s,
    };

    return crew_run(&crew);
}

/* Those that are done; the first of the others says why there are too few. */
static int count(struct spread *s)
{
    const struct member *bad = NULL;

    for (int i = 0; i < s->order->runs; i++) {
        const struct member *m = &s->member[i];
        s->done += m->ended && m->code == STATUS_DONE;
        if (!m->ended || m->code == STATUS_DONE)
            continue;
        status_warn("%s is left out: %s: %s", m->name, member_status(m), m->message);
        bad = bad ? bad : m;
    }
    if (s->done >= 2)
        return STATUS_DONE;
    return status_fail(STATUS_FAILED, "%d of %d runs came to their end, and a band needs two"
                       "%s%s%s%s", s->done, s->order->runs, bad ? "; " : "", bad ? bad->name : "",
                       bad ? ": " : "", bad ? bad->message : "");
}

static void read_bundles(struct spread *s)
{
    char name[64];

    for (int i = 0; i < SPREAD_INSIDE_TABLES; i++) {
        snprintf(name, sizeof name, "%s.csv", quantity_tables[i]);
        bundle_read(&s->bundle[i], &s->home, s->member, s->order->runs, name);
    }
}

/* What figures need beside the scene. */
static int write_constants(const struct spread *s)
{
    char path[MEMBER_PATH];
    struct aside a;

    TRY(aside_join(path, s->home.directory, "figures"));
    TRY(aside_directory(path));
    TRY(aside_join(path, s->home.directory, "figures/runs.gp"));
    TRY(aside_open(&a, path));
    fprintf(a.to, "# runs.gp -- of a spread\nruns = %d\nsize = %.17g\nshare = %.17g\n", s->done,
            s->order->size, s->order->share);
    if (isfinite(s->apart.lost))
        fprintf(a.to, "lost = %.17g\n", s->apart.lost);
    else
        fputs("lost = NaN\n", a.to);
    return aside_close(&a);
}

static int write_all(struct spread *s)
{
    const struct member *done = s->member;

    while (!done->ended || done->code != STATUS_DONE)
        done++;
    read_bundles(s);
    spread_apart_read(s);
    TRY(spread_bands_write(s));
    TRY(spread_apart_write(s));
    TRY(spread_scalars_write(s));
    TRY(spread_json_write(s));
    TRY(spread_words_write(s));
    TRY(write_constants(s));
    return picture_draw(&s->home, &s->facts, done, s->order->scripts);
}

/* The bands of what is there, also after a signal. */
static int conclude(struct spread *s, int status)
{
    const struct member *bad = refused(s);

    if (bad)
        return status_fail(bad->code, "%s", bad->message);
    if (status != STATUS_DONE && status != STATUS_STOPPED)
        return status;
    if (status == STATUS_STOPPED && count(s) != STATUS_DONE)
        return status; /* that the signal came is what is told */
    if (status == STATUS_DONE)
        TRY(count(s));
    TRY(write_all(s));
    return status;
}

static void release(struct spread *s)
{
    for (int i = 0; i < SPREAD_INSIDE_TABLES; i++)
        bundle_free(&s->bundle[i]);
    free(s->member);
}

int spread_scene(const struct spread_order *order)
{
    struct spread s = { .order = order };
    int status;

    stop_listen();
    status = prepare(&s);
    if (status == STATUS_DONE)
        status = conclude(&s, carry_out(&s));
    release(&s);
    return status;
}
