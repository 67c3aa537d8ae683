/* commands.h -- the commands and their options: what the parser, --help and the man
 * page read. */
#ifndef CLI_COMMANDS_H
#define CLI_COMMANDS_H

#include "cli/cli.h"

#include <argp.h>

struct commands_row {
    const char *name; /* NULL ends the table                                  */
    enum cli_command id;
    const char *args; /* words that it takes                                  */
    const char *doc;  /* what it does; after "\v", what else there is to know */
    const struct argp_option *options;
    bool keys;        /* KEY=VALUE may follow                                 */
};

extern const struct commands_row commands_table[];

#endif
