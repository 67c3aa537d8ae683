/* main_dim.c -- `stiffwater-2d` and `stiffwater-3d`: carry out a command. */
#include "base/status.h"
#include "cli/cli.h"
#include "output/figures.h"
#include "plan/catalogue.h"
#include "run/run.h"
#include "time/method.h"

#include <gsl/gsl_errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef STIFFWATER_DATADIR
#define STIFFWATER_DATADIR "/usr/local/share/stiffwater"
#endif

static int list(const char *what)
{
    if (strcmp(what, "methods") != 0)
        return catalogue_list(what, stdout);
    for (int i = 0; method_table[i]; i++)
        printf("%-22s %s\n", method_table[i]->name, method_table[i]->about);
    puts("ARKODE_...             any explicit table of ARKODE by its own name");
    return STATUS_DONE;
}

/* Scripts and reference data: of the source tree when the environment names
 * one (tests, quickstart), else where they were installed. */
static int plot(const char *directory)
{
    const char *tree = getenv("STIFFWATER_DATA");
    char scripts[4096], data[4096];

    snprintf(scripts, sizeof scripts, "%.4000s/plots", tree ? tree : STIFFWATER_DATADIR);
    snprintf(data, sizeof data, "%.4000s/%s", tree ? tree : STIFFWATER_DATADIR,
             tree ? "data/reference" : "reference");
    return figures_draw(directory, scripts, data);
}

static int carry_out(const struct cli *c)
{
    const struct run_order order = {
        .scene = c->subject, .overrides = c->overrides, .override = c->override,
        .directory = c->directory, .threads = c->threads, .quiet = c->quiet,
    };

    switch (c->command) {
    case CLI_RUN: return run_scene(&order);
    case CLI_CHECK: return run_check(&order);
    case CLI_PLOT: return plot(c->subject);
    case CLI_LIST: return list(c->subject);
    case CLI_EXPLAIN: return catalogue_explain(c->subject, stdout);
    default:
        return status_fail(STATUS_BAD_SCENE, "%s is not there yet",
                           c->command == CLI_RESUME ? "resume" : "compare");
    }
}

int main(int argc, char **argv)
{
    struct cli c;
    int status;

    gsl_set_error_handler_off(); /* its default handler aborts the program */
    cli_parse(argc, argv, &c);
    status = carry_out(&c);
    if (status != STATUS_DONE)
        fprintf(stderr, "stiffwater: %s\n", status_message());
    return status;
}
