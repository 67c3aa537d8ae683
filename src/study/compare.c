/* compare.c -- many runs of one scene: methods x tolerances x swept keys.
 *
 * Runs are child processes, so that one that fails takes nothing with it, its CPU time is its
 * own, and a comparison that is interrupted goes on with what is there. */
#include "study/compare.h"

#include "base/status.h"
#include "output/figures.h"
#include "run/stop.h"
#include "study/children.h"
#include "study/point.h"
#include "study/tabulate.h"
#include "study/tell.h"
#include "study/trial.h"
#include "study/trials.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#ifndef PACKAGE_VERSION
#define PACKAGE_VERSION "unknown"
#endif

/* "path/dam-break.scene" becomes "dam-break-compare". */
static int choose_directory(struct study *s)
{
    const char *scene = s->order->scene, *slash = strrchr(scene, '/');
    const char *from = s->order->directory ? s->order->directory : slash ? slash + 1 : scene;
    const char *dot = strrchr(from, '.');
    const bool ends = !s->order->directory && dot && strcmp(dot, ".scene") == 0;

    if (strlen(from) >= sizeof s->directory - 300)
        return status_fail(STATUS_IO, "%.200s...: this output directory is too far from the root",
                           from);
    snprintf(s->directory, sizeof s->directory, "%.*s%s",
             (int)(ends ? (size_t)(dot - from) : strlen(from)), from,
             s->order->directory ? "" : "-compare");
    return STATUS_DONE;
}

/* The program is part of a run's identity: what was measured with another is another run. */
static int find_program(struct study *s)
{
    const ssize_t n = readlink("/proc/self/exe", s->program, sizeof s->program - 1);
    struct stat about = {0};
    char hash[32];

    if (n <= 0)
        return status_fail(STATUS_IO, "/proc/self/exe cannot be read: where is this program?");
    s->program[n] = '\0';
    stat(s->program, &about);
    TRY(point_hash(s->order->scene, hash, sizeof hash));
    snprintf(s->identity, sizeof s->identity, "program %s, %lld bytes, %lld.%09ld\nscene %s\n",
             PACKAGE_VERSION, (long long)about.st_size, (long long)about.st_mtim.tv_sec,
             about.st_mtim.tv_nsec, hash);
    return STATUS_DONE;
}

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
    if (asked && (!colon || (size_t)(colon - asked) >= INSIDE_WORD || strlen(colon) >= INSIDE_WORD))
        return status_fail(STATUS_BAD_SCENE, "--reference %.60s: METHOD:TOL is expected, like "
                           "bs54:1e-6", asked);
    if (asked) {
        snprintf(s->reference_method, INSIDE_WORD, "%.*s", (int)(colon - asked), asked);
        snprintf(s->reference_tol, INSIDE_WORD, "%s", colon + 1);
        return STATUS_DONE;
    }
    snprintf(s->reference_method, INSIDE_WORD, "%s", s->point[0].beam ? "imex4" : "bs54");
    snprintf(s->reference_tol, INSIDE_WORD, "%g", fmin(1e-6, least / 100));
    return STATUS_DONE;
}

static int prepare(struct study *s)
{
    TRY(choose_directory(s));
    TRY(words_split(&s->methods, s->order->methods, "--methods"));
    TRY(words_split(&s->tols, s->order->tols, "--tols"));
    TRY(point_sweeps(s));
    TRY(point_all(s));
    TRY(find_program(s));
    TRY(choose_reference(s));
    return trials_make(s);
}

/* A list of runs at work. */
struct work {
    struct study *study;
    struct trial **trial; /* [n] those that are not there yet */
    struct child *child;  /* [n] */
    int n;
    struct tell tell;
};

/* A repeat of what did not come to its end would tell nothing. */
static bool is_wanted(const struct study *s, const struct trial *t)
{
    return t->repeat == 0
           || s->trial[(t - s->trial) % (s->points * s->cases)].code == STATUS_DONE;
}

static bool begin(void *self, int i)
{
    struct work *w = self;
    char path[INSIDE_PATH];

    if (!is_wanted(w->study, w->trial[i])) {
        w->tell.all--;
        return false;
    }
    trial_path(w->study, w->trial[i], "run.json", path);
    remove(path);
    trial_path(w->study, w->trial[i], "order", path);
    remove(path);
    w->tell.now = w->trial[i]->name;
    return true;
}

static int end(void *self, int i)
{
    struct work *w = self;
    struct trial *t = w->trial[i];

    t->code = w->child[i].code;
    t->late = w->child[i].late && t->code != STATUS_DONE;
    if (t->code != STATUS_DONE && !t->late && (t->code == STATUS_STOPPED || stop_asked()))
        return STATUS_DONE; /* by whoever stops us: it is to be done again */
    TRY(trial_end(w->study, t));
    w->tell.ended++;
    w->tell.bad += t->code != STATUS_DONE;
    return tabulate_csv(w->study);
}

static void look(void *self, int running)
{
    struct work *w = self;

    tell_look(&w->tell, running);
}

/* Directory, words and place for what is said. */
static int make_child(struct work *w, int i)
{
    char directory[INSIDE_PATH], said[INSIDE_PATH];

    trial_path(w->study, w->trial[i], "", directory);
    TRY(aside_directory(directory));
    trial_path(w->study, w->trial[i], "said", said);
    w->child[i].said = strdup(said);
    w->child[i].words = trial_words(w->study, w->trial[i]);
    if (!w->child[i].said || !w->child[i].words)
        return status_fail(STATUS_FAILED, "out of memory");
    return STATUS_DONE;
}

static int make_children(struct work *w, struct trial *trial, int n, double budget)
{
    for (int i = 0; i < n; i++) {
        if (!*trial[i].name)
            continue;
        if (trial_reuse(w->study, &trial[i])) {
            w->tell.ended++;
            w->tell.reused++;
            w->tell.bad += trial[i].code != STATUS_DONE;
            continue;
        }
        w->trial[w->n] = &trial[i];
        w->child[w->n].budget = budget;
        TRY(make_child(w, w->n++));
    }
    return STATUS_DONE;
}

static int carry_out(struct study *s, const char *what, struct trial *trial, int n, double budget)
{
    struct work w = { .study = s };
    const struct children_watch watch = { begin, end, look, stop_asked, &w };
    int status = STATUS_FAILED;

    w.trial = status_alloc(n, sizeof *w.trial);
    w.child = status_alloc(n, sizeof *w.child);
    tell_start(&w.tell, what, 0, s->order->quiet);
    if (w.trial && w.child)
        status = make_children(&w, trial, n, budget);
    w.tell.all = w.tell.ended + w.n;
    if (status == STATUS_DONE)
        status = tabulate_csv(s);
    if (status == STATUS_DONE)
        status = children_run(w.child, w.n, s->order->jobs > 1 ? s->order->jobs : 1, &watch);
    tell_end(&w.tell);
    for (int i = 0; i < w.n; i++) {
        free((char *)w.child[i].said);
        free((char **)w.child[i].words);
    }
    free(w.trial);
    free(w.child);
    return status;
}

/* What refuses the reference refuses all: a wrong key, a wrong method. */
static int check_references(struct study *s)
{
    for (int i = 0; i < s->points; i++) {
        const struct trial *t = &s->reference[i];
        if (t->code == STATUS_BAD_SCENE || t->code == STATUS_IO)
            return status_fail(t->code, "%s%s%s", s->point[i].label, *s->point[i].label ? ": " : "",
                               t->message);
        if (t->code != STATUS_DONE)
            status_warn("the reference%s%s did not come to its end, so there are no errors: %s; "
                        "name another one with --reference METHOD:TOL",
                        *s->point[i].label ? " at " : "", s->point[i].label, t->message);
    }
    return STATUS_DONE;
}

static int all_runs(struct study *s)
{
    TRY(carry_out(s, "references", s->reference, 2 * s->points, 0));
    TRY(check_references(s));
    TRY(tabulate_json(s));
    return carry_out(s, "runs", s->trial, s->trials, s->order->budget);
}

static int draw(const struct study *s)
{
    struct figures_constants c = { .title = s->point[0].title, .dim = s->point[0].dimension,
                                   .until = s->point[0].until, .beam_x = NAN,
                                   .dx = s->point[0].dx };
    char path[INSIDE_PATH];

    trial_path(s, &s->reference[0], "run.json", path);
    c.E0 = result_number(path, "energy_initial");
    TRY(figures_constants(s->directory, &c));
    if (figures_draw(s->directory, s->order->scripts, s->order->scripts) != STATUS_DONE) {
        status_warn("%s", status_message());
        status_clear();
    }
    return STATUS_DONE;
}

/* The tables of what is there, also after a signal. */
static int conclude(struct study *s, int status)
{
    if (status != STATUS_DONE && status != STATUS_STOPPED)
        return status;
    TRY(tabulate_best(s));
    TRY(draw(s));
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
