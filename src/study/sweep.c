/* sweep.c -- runs of one scene over values of its keys. */
#include "study/sweep.h"

#include "base/status.h"
#include "run/stop.h"
#include "study/checks.h"
#include "study/crew.h"
#include "study/picture.h"
#include "study/point.h"
#include "study/sweep-table.h"

#include <stdlib.h>
#include <string.h>

enum { WORDS = 256 };

static const char *const files[] = { "sweep.csv", "sweep.md", "report.html", NULL };
static const char *const folders[] = { "figures", "runs", NULL };
static const struct mark_owner owner = { "sweep", files, folders, NULL };

/* The words of the command line, told apart. */
struct asked {
    const char *swept[COMPARE_SWEEPS], *set[WORDS];
    int sweeps, sets;
};

/* Are there several values, with commas between, behind the "="? */
static int count(const char *word, int *values)
{
    const char *equals = strchr(word, '=');
    struct words l = {0};

    *values = 1;
    if (!equals || !equals[1])
        return STATUS_DONE;
    TRY(words_split(&l, equals + 1, word));
    *values = l.n;
    words_free(&l);
    return STATUS_DONE;
}

static int tell_apart(const struct sweep_order *order, struct asked *a)
{
    for (int i = 0; i < order->words && i < WORDS; i++) {
        int values;
        TRY(count(order->word[i], &values));
        if (values > 1 && a->sweeps == COMPARE_SWEEPS)
            return status_fail(STATUS_BAD_SCENE, "%.60s: more than %d keys are swept",
                               order->word[i], COMPARE_SWEEPS);
        if (values > 1)
            a->swept[a->sweeps++] = order->word[i];
        else
            a->set[a->sets++] = order->word[i];
    }
    if (a->sweeps == 0)
        return status_fail(STATUS_BAD_SCENE, "sweep: over what? Give a key and its values, such as "
                           "eos.c0=20,40 or effects.density-diffusion=on,off");
    return STATUS_DONE;
}

static int make_runs(struct sweep *s)
{
    const struct study *study = &s->study;

    s->run = status_alloc(study->points, sizeof *s->run);
    s->result = status_alloc(study->points, sizeof *s->result);
    if (!s->run || !s->result)
        return STATUS_FAILED;
    for (int i = 0; i < study->points; i++) {
        s->run[i].until = study->point[i].facts.until;
        member_name_add(&s->run[i], study->point[i].label);
    }
    return sweep_outputs_create(&s->outputs, study->points);
}

static int prepare(struct sweep *s)
{
    struct study *study = &s->study;
    const struct compare_order *order = study->order;

    study->home = (struct member_home){
        .scene = order->scene, .overrides = order->overrides, .override = order->override,
        .threads = order->threads, .budget = order->budget, .owner = &owner,
        .force = order->force,
    };
    TRY(point_sweeps(study));
    TRY(point_all(study));
    TRY(member_home_make(&study->home, order->directory, "-sweep"));
    TRY(make_runs(s));
    return member_home_claim(&study->home);
}

static struct member *member(void *self, int i)
{
    struct sweep *s = self;

    return &s->run[i];
}

static char *settings(void *self, int i)
{
    const struct sweep *s = self;

    return point_settings(&s->study, &s->study.point[i]);
}

static void came(void *self, int i)
{
    struct sweep *s = self;
    char path[MEMBER_PATH];

    member_path(&s->study.home, &s->run[i], "", path);
    result_read(&s->result[i], path);
    if (s->run[i].code == STATUS_DONE)
        sweep_outputs_read(&s->outputs, i, &s->study.home, &s->run[i]);
}

static int changed(void *self)
{
    return sweep_table_csv(self);
}

static int carry_out(struct sweep *s)
{
    const struct study *study = &s->study;
    const struct crew crew = {
        .home = &study->home, .what = "runs", .n = study->points, .jobs = study->order->jobs,
        .budget = study->order->budget, .quiet = study->order->quiet, .member = member,
        .settings = settings, .came = came, .changed = changed, .self = s,
    };
    const int status = crew_run(&crew);

    if (status != STATUS_DONE && status != STATUS_STOPPED)
        return status;
    TRY(sweep_table_words(s));
    TRY(picture_draw(&study->home, &study->point[0].facts, &s->run[0], study->order->scripts));
    return status;
}

static void release(struct sweep *s)
{
    for (int k = 0; k < s->study.sweeps; k++)
        words_free(&s->study.values[k]);
    free(s->study.point);
    free(s->run);
    free(s->result);
    sweep_outputs_free(&s->outputs);
}

int sweep_scene(const struct sweep_order *asked)
{
    struct asked a = {0};
    struct compare_order order = {
        .scene = asked->scene, .directory = asked->directory, .jobs = asked->jobs,
        .threads = asked->threads, .budget = asked->budget, .quiet = asked->quiet,
        .force = asked->force,
        .scripts = asked->scripts, .unit = asked->unit, .override = a.set, .sweep = a.swept,
    };
    struct sweep s = { .study.order = &order };
    int status;

    stop_listen();
    TRY(tell_apart(asked, &a));
    order.overrides = a.sets;
    order.sweeps = a.sweeps;
    status = prepare(&s);
    if (status == STATUS_DONE)
        status = checks_run(&s.study);
    if (status == STATUS_DONE)
        status = carry_out(&s);
    release(&s);
    return status;
}
