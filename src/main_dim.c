/* main_dim.c -- `stiffwater-2d` and `stiffwater-3d`, and `stiffwater-2d-mpi` and
 * `stiffwater-3d-mpi`: carry out a command. */
#include "base/status.h"
#include "cli/cli.h"
#include "output/figures.h"
#include "output/movie.h"
#include "output/report.h"
#include "plan/catalogue-keys.h"
#include "plan/catalogue.h"
#include "ranks/ranks.h"
#include "run/run.h"
#include "study/compare.h"
#include "study/spread.h"
#include "study/sweep.h"
#include "time/method.h"

#include <errno.h>
#include <gsl/gsl_errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int list(const char *what)
{
    if (strcmp(what, "methods") != 0)
        return catalogue_list(what, stdout);
    for (int i = 0; method_table[i]; i++)
        printf("%-22s %s\n", method_table[i]->name, method_table[i]->told.about);
    return STATUS_DONE;
}

static void explain_method(const struct method *m)
{
    char order[64] = "changes from step to step";

    if (m->order > 0)
        snprintf(order, sizeof order, "%d", m->order);
    printf("%s -- %s\n  source: %s\n  order: %s\n  %s%s%s%s\n", m->name, m->told.about, m->told.source,
           order,
           m->adaptive ? "its step follows an error estimate: tol, norm"
                       : "its step is a CFL number: NAME@0.25",
           m->varies ? "" : "; or is constant, in seconds: ", m->varies ? "" : m->name,
           m->varies ? "" : "@1e-4s");
}

/* What only scenes in 3D have, the other program knows. */
static int explain_thing(const char *name)
{
    char *const there[] = { "stiffwater", "explain", (char *)name, NULL };
    const int status = catalogue_explain(name, stdout);
    const char *near;

    if (status != STATUS_BAD_SCENE)
        return status;
    if (catalogue_explain_key(name, stdout) || catalogue_explain_named(name, stdout, &near)) {
        status_clear();
        return STATUS_DONE;
    }
    if (near) {
        status_clear();
        return status_fail(STATUS_BAD_SCENE, "explain %s: no such key; did you mean %.*s.%s?", name,
                           (int)strcspn(name, "."), name, near);
    }
    return DIM == 2 ? cli_exec(3, (char **)there) : status;
}

/* Methods first: the catalogue knows what a scene is made of, not how it is run, but a
 * method may have a group of keys that bears its name. */
static int explain(const char *name)
{
    for (int i = 0; method_table[i]; i++)
        if (strcmp(method_table[i]->name, name) == 0) {
            explain_method(method_table[i]);
            catalogue_explain_group(name, stdout);
            return STATUS_DONE;
        }
    return explain_thing(name);
}

/* What a directory has that can be drawn. */
static bool has_results(const char *directory)
{
    static const char *const files[] = { "run.json", "compare.csv", "sweep.csv", "spread.csv" };
    char path[4200];

    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        snprintf(path, sizeof path, "%.4096s/%s", directory, files[i]);
        if (access(path, R_OK) == 0)
            return true;
    }
    return false;
}

static int refuse_directory(const char *directory)
{
    return status_fail(STATUS_BAD_SCENE, "%s: no run in there (%s/run.json cannot be read)",
                       directory, directory);
}

static int plot(const char *directory)
{
    char scripts[4200], reference[4200];

    if (!has_results(directory))
        return refuse_directory(directory);
    snprintf(scripts, sizeof scripts, "%.4096s/plots", cli_data());
    snprintf(reference, sizeof reference, "%.4096s/data/reference", cli_data());
    return figures_draw(directory, scripts, reference);
}

static int movie(const char *directory)
{
    char scripts[4200];

    snprintf(scripts, sizeof scripts, "%.4096s/plots", cli_data());
    return has_results(directory) ? movie_write(directory, scripts) : refuse_directory(directory);
}

/* Without gnuplot there is a page, too: that has been said where it was missed. */
static int report(const char *directory)
{
    char *versions = NULL;
    size_t size = 0;
    FILE *to;
    int drawn, status;

    if (!has_results(directory))
        return refuse_directory(directory);
    drawn = plot(directory);
    to = open_memstream(&versions, &size);
    if (!to)
        return status_fail(STATUS_FAILED, "out of memory for a report");
    cli_version(to);
    fclose(to);
    status = report_write(directory, versions);
    free(versions);
    return status != STATUS_DONE ? status : drawn;
}

static int compare(const struct cli *c)
{
    char scripts[4200];
    const struct compare_order order = {
        .scene = c->subject, .overrides = c->overrides, .override = c->override,
        .directory = c->directory, .methods = c->methods,
        .tols = c->tols ? c->tols : "1e-2,1e-3,1e-4", .sweeps = c->sweeps, .sweep = c->sweep,
        .reference = c->reference, .early = c->early, .growth = c->growth, .repeat = c->repeat,
        .jobs = c->jobs, .threads = c->threads, .budget = c->budget, .quiet = c->quiet,
        .force = c->force, .scripts = scripts, .unit = catalogue_unit,
    };

    snprintf(scripts, sizeof scripts, "%.4096s/plots", cli_data());
    return compare_scene(&order);
}

static int spread(const struct cli *c)
{
    char scripts[4200];
    const struct spread_order order = {
        .scene = c->subject, .overrides = c->overrides, .override = c->override,
        .directory = c->directory, .runs = c->spread.runs, .seed = c->spread.seed,
        .size = c->spread.size, .share = c->spread.share,
        .window = { c->spread.window[0], c->spread.window[1] }, .jobs = c->jobs,
        .threads = c->threads, .budget = c->budget, .quiet = c->quiet, .force = c->force,
        .scripts = scripts,
    };

    snprintf(scripts, sizeof scripts, "%.4096s/plots", cli_data());
    return spread_scene(&order);
}

static int sweep(const struct cli *c)
{
    char scripts[4200];
    const struct sweep_order order = {
        .scene = c->subject, .words = c->overrides, .word = c->override,
        .directory = c->directory, .jobs = c->jobs, .threads = c->threads, .budget = c->budget,
        .quiet = c->quiet, .force = c->force, .scripts = scripts, .unit = catalogue_unit,
    };

    snprintf(scripts, sizeof scripts, "%.4096s/plots", cli_data());
    return sweep_scene(&order);
}

static int resume(const struct cli *c)
{
    const struct run_order order = {
        .overrides = c->overrides, .override = c->override, .directory = c->subject,
        .threads = c->threads, .quiet = c->quiet,
    };

    return run_resume(&order);
}

static int carry_out(const struct cli *c)
{
    const struct run_order order = {
        .scene = c->subject, .overrides = c->overrides, .override = c->override,
        .directory = c->directory, .threads = c->threads, .quiet = c->quiet, .force = c->force,
    };

    switch (c->command) {
    case CLI_RUN: return run_scene(&order);
    case CLI_RESUME: return resume(c);
    case CLI_CHECK: return run_check(&order);
    case CLI_PLOT: return plot(c->subject);
    case CLI_REPORT: return report(c->subject);
    case CLI_MOVIE: return movie(c->subject);
    case CLI_HULL: return cli_hull(c);
    case CLI_LIST: return list(c->subject);
    case CLI_EXPLAIN: return explain(c->subject);
    case CLI_COMPARE: return compare(c);
    case CLI_SWEEP: return sweep(c);
    case CLI_SPREAD: break;
    }
    return spread(c);
}

/* What was printed has to reach its reader: a full disk is told when the last of it is
 * written. */
static int check_printed(void)
{
    if (fflush(stdout) == 0 && !ferror(stdout))
        return STATUS_DONE;
    return status_fail(STATUS_IO, "standard output cannot be written: %s", strerror(errno));
}

/* What can be carried out on so many ranks: what makes many runs has them by child processes. */
static int agree_ranks(const struct cli *c)
{
    const bool many = c->command == CLI_COMPARE || c->command == CLI_SWEEP || c->command == CLI_SPREAD;

    if (ranks_count() == 1 || c->command == CLI_RUN || c->command == CLI_RESUME
        || c->command == CLI_CHECK)
        return STATUS_DONE;
    return status_fail_with(STATUS_BAD_SCENE, (struct status_advice){
        .remedy = many ? "start the program without mpirun; --jobs N has N runs at a time. For runs that "
                         "are to be shared, start each by `run SCENE KEY=VALUE --ranks N'"
                       : "start the program without mpirun" },
        "%d ranks share `run', `resume' and `check', and no other command", ranks_count());
}

/* All ranks have the same status; the first of them says why. */
static int finish(int status)
{
    status = ranks_agree(status);
    if (status != STATUS_DONE && ranks_me() == 0)
        fprintf(stderr, "stiffwater: %s\n", status_message());
    ranks_end();
    return status;
}

enum { STACK = 1 << 19 }; /* bytes: more than a run uses */

__attribute__((noinline)) static void touch_stack(void)
{
    volatile char room[STACK];

    for (int i = 0; i < STACK; i += 1024)
        room[i] = 0;
    (void)room[0];
}

/* A stack grows when it is used, and where there is no memory for that a signal ends the program:
 * so it grows here, before anything else. */
static int take_stack(void)
{
    TRY(status_reserve(STACK + (1 << 16), "the stack"));
    touch_stack();
    return STATUS_DONE;
}

int main(int argc, char **argv)
{
    struct cli c;
    int status;

    if (take_stack() != STATUS_DONE) {
        fprintf(stderr, "stiffwater: %s\n", status_message());
        return STATUS_FAILED;
    }
    gsl_set_error_handler_off(); /* its default handler aborts the program */
    status = ranks_begin(&argc, &argv);
    cli_parse(argc, argv, &c);
    if (status == STATUS_DONE)
        status = agree_ranks(&c);
    if (status == STATUS_DONE)
        status = carry_out(&c);
    if (status == STATUS_DONE)
        status = check_printed();
    if (status_is_starved())
        status = STATUS_FAILED; /* whatever went wrong for want of memory, or was left out */
    return finish(status);
}
