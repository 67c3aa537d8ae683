/* compare.c -- many runs of one scene: methods x tolerances x swept keys. */
#include "study/compare.h"

#include "base/status.h"
#include "run/stop.h"
#include "study/checks.h"
#include "study/crew.h"
#include "study/keys.h"
#include "study/picture.h"
#include "study/point.h"
#include "study/tabulate.h"
#include "study/trial.h"
#include "study/trials.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const files[] = { "compare.csv", "compare.json", "compare.md", "report.html",
                                     NULL };
static const char *const folders[] = { "figures", "runs", NULL };
static const struct mark_owner owner = { "comparison", files, folders, NULL };

static int check_tols(struct study *s, double *least)
{
    *least = HUGE_VAL;
    for (int i = 0; i < s->tols.n; i++) {
        char *end;
        const double tol = strtod(s->tols.word[i], &end);
        if (*end || !(tol > 0) || strlen(s->tols.word[i]) >= INSIDE_WORD)
            return status_fail(STATUS_BAD_SCENE, "--tols: %.60s is no error allowed in a step; "
                               "numbers above 0 are, like 1e-2,1e-3", s->tols.word[i]);
        *least = fmin(*least, tol);
    }
    return STATUS_DONE;
}

/* Another family than what is compared, a hundred times as tight. */
static int choose_reference(struct study *s)
{
    const char *asked = s->order->reference, *colon = asked ? strchr(asked, ':') : NULL;
    double least;

    TRY(check_tols(s, &least));
    if (s->finest)
        return STATUS_DONE;
    if (asked && (!colon || (size_t)(colon - asked) >= INSIDE_WORD || strlen(colon) >= INSIDE_WORD))
        return status_fail(STATUS_BAD_SCENE, "--reference %.60s: METHOD:TOL is expected, like "
                           "bs54:1e-6, or finest", asked);
    if (asked) {
        snprintf(s->reference_method, INSIDE_WORD, "%.*s", (int)(colon - asked), asked);
        snprintf(s->reference_tol, INSIDE_WORD, "%s", colon + 1);
        return STATUS_DONE;
    }
    snprintf(s->reference_method, INSIDE_WORD, "%s", s->point[0].facts.beam ? "imex4" : "bs54");
    snprintf(s->reference_tol, INSIDE_WORD, "%g", fmin(1e-6, least / 100));
    return STATUS_DONE;
}

static const struct key_owner own_keys[] = {
    { "method", "take --methods A,B,..." },
    { "tol", "take --tols X,Y,..." },
    { "output.snapshots", "positions are compared at times that --early chooses" },
    { "output.fields", "fields are not written but at the end" },
    { 0 },
};

static int prepare(struct study *s)
{
    TRY(keys_free(own_keys, s->order->overrides, s->order->override));
    TRY(keys_free(own_keys, s->order->sweeps, s->order->sweep));
    s->home = (struct member_home){
        .scene = s->order->scene, .overrides = s->order->overrides,
        .override = s->order->override, .threads = s->order->threads, .budget = s->order->budget,
        .owner = &owner, .force = s->order->force,
    };
    TRY(words_split(&s->methods, s->order->methods, "--methods"));
    TRY(words_split(&s->tols, s->order->tols, "--tols"));
    s->finest = s->order->reference && strcmp(s->order->reference, "finest") == 0;
    TRY(point_sweeps(s));
    TRY(point_all(s));
    if (s->finest)
        TRY(point_finest(s));
    TRY(member_home_make(&s->home, s->order->directory, "-compare"));
    TRY(choose_reference(s));
    TRY(trials_make(s));
    return member_home_claim(&s->home);
}

/* The runs of a list that the crew sees to. */
struct list {
    struct study *study;
    struct trial *trial;
};

static struct member *member(void *self, int i)
{
    struct list *l = self;

    return &l->trial[i].run;
}

static char *settings(void *self, int i)
{
    struct list *l = self;

    return trial_settings(l->study, &l->trial[i]);
}

/* A repeat of what did not come to its end would tell nothing. */
static bool is_wanted(void *self, int i)
{
    const struct list *l = self;
    const struct study *s = l->study;
    const struct trial *t = &l->trial[i];

    return t->repeat == 0
           || s->trial[(t - s->trial) % (s->points * s->cases)].run.code == STATUS_DONE;
}

static void came(void *self, int i)
{
    struct list *l = self;

    trial_read(l->study, &l->trial[i]);
}

static int changed(void *self)
{
    struct list *l = self;

    return tabulate_csv(l->study);
}

static int carry_out(struct study *s, const char *what, struct trial *trial, int n, double budget)
{
    struct list list = { s, trial };
    const struct crew crew = {
        .home = &s->home, .what = what, .n = n, .jobs = s->order->jobs, .budget = budget,
        .quiet = s->order->quiet, .member = member, .settings = settings, .wanted = is_wanted,
        .came = came, .changed = changed, .self = &list,
    };

    return crew_run(&crew);
}

/* What refuses the reference refuses all: a wrong key, a wrong method. */
static int check_references(struct study *s)
{
    for (int i = 0; i < s->points; i++) {
        const struct trial *t = &s->reference[i];
        if (t->run.code == STATUS_BAD_SCENE || t->run.code == STATUS_IO)
            return status_fail(t->run.code, "%s%s%s", s->point[i].label,
                               *s->point[i].label ? ": " : "", t->run.message);
        if (t->run.code != STATUS_DONE)
            status_warn("the reference%s%s did not come to its end, so there are no errors: %s; "
                        "name another one with --reference METHOD:TOL",
                        *s->point[i].label ? " at " : "", s->point[i].label, t->run.message);
    }
    return STATUS_DONE;
}

/* Runs with the least spacing may come last. */
static int all_and_finest(struct study *s)
{
    TRY(carry_out(s, "runs", s->trial, s->trials, s->order->budget));
    TRY(tabulate_json(s));
    for (int i = 0; i < s->trials; i++)
        if (s->trial[i].run.ended)
            trial_read(s, &s->trial[i]);
    return tabulate_csv(s);
}

static int all_runs(struct study *s)
{
    TRY(checks_run(s));
    if (s->finest)
        return all_and_finest(s);
    TRY(carry_out(s, "references", s->reference, 2 * s->points, 0));
    TRY(check_references(s));
    TRY(tabulate_json(s));
    return carry_out(s, "runs", s->trial, s->trials, s->order->budget);
}

/* The tables of what is there, also after a signal. */
static int conclude(struct study *s, int status)
{
    if (status != STATUS_DONE && status != STATUS_STOPPED)
        return status;
    TRY(tabulate_best(s));
    TRY(picture_draw(&s->home, &s->point[0].facts, &s->trial[0].reference->run,
                     s->order->scripts));
    return status;
}

static void release(struct study *s)
{
    words_free(&s->methods);
    words_free(&s->tols);
    for (int k = 0; k < s->sweeps; k++)
        words_free(&s->values[k]);
    free(s->point);
    free(s->reference);
    free(s->trial);
}

int compare_scene(const struct compare_order *order)
{
    struct study s = { .order = order };
    int status;

    stop_listen();
    status = prepare(&s);
    if (status == STATUS_DONE) {
        status = all_runs(&s);
        status = conclude(&s, status);
    }
    release(&s);
    return status;
}
