/* main.c -- `stiffwater`: reads which dimension a scene has and hands over to
 * the program of that dimension. */
#include "base/status.h"
#include "base/waiting.h"
#include "cli/cli.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

/* A run to go on with has its scene in its directory. */
static int dimension_of_run(const struct cli *c, int *dimension)
{
    char scene[4200];
    struct cli of = { .subject = scene };

    if (snprintf(scene, sizeof scene, "%s/scene.used", c->subject) >= (int)sizeof scene)
        return status_fail(STATUS_BAD_SCENE, "%.200s...: no run in there, this path is too long",
                           c->subject);
    if (access(scene, R_OK) != 0)
        return status_fail(STATUS_BAD_SCENE, "%s: no run in there (%s cannot be read)", c->subject,
                           scene);
    return cli_dimension(&of, dimension);
}

int main(int argc, char **argv)
{
    struct cli c;
    int dimension = 2, status = STATUS_DONE;

    cli_parse(argc, argv, &c);
    if (c.command == CLI_RUN || c.command == CLI_RESUME)
        waiting_choose(c.threads);
    else
        waiting_sleep();
    if (c.command == CLI_RUN || c.command == CLI_CHECK || c.command == CLI_COMPARE
        || c.command == CLI_SPREAD || c.command == CLI_SWEEP) {
        status = cli_keep_pipe(c.subject);
        if (status == STATUS_DONE)
            status = cli_dimension(&c, &dimension);
    }
    if (c.command == CLI_HULL)
        dimension = 3;
    if (c.command == CLI_RESUME)
        status = dimension_of_run(&c, &dimension);
    if (status == STATUS_DONE)
        status = c.ranks > 0 ? cli_exec_ranks(&c, dimension, argv) : cli_exec(dimension, argv);
    fprintf(stderr, "stiffwater: %s\n", status_message());
    return status_is_starved() ? STATUS_FAILED : status;
}
