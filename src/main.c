/* main.c -- `stiffwater`: reads which dimension a scene has and hands over to
 * the program of that dimension. */
#include "base/status.h"
#include "cli/cli.h"

#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv)
{
    struct cli c;
    int dimension = 2, status = STATUS_DONE;

    setenv("OMP_WAIT_POLICY", "passive", 0); /* read when the next program loads */
    cli_parse(argc, argv, &c);
    if (c.command == CLI_RUN || c.command == CLI_CHECK || c.command == CLI_COMPARE
        || c.command == CLI_SPREAD || c.command == CLI_SWEEP) {
        status = cli_keep_pipe(c.subject);
        if (status == STATUS_DONE)
            status = cli_dimension(&c, &dimension);
    }
    if (status == STATUS_DONE)
        status = cli_exec(dimension, argv);
    fprintf(stderr, "stiffwater: %s\n", status_message());
    return status;
}
