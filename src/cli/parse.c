/* parse.c -- commands and options, by argp. */
#include "cli/cli.h"

#include "base/status.h"

#include <argp.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct command {
    const char *name;
    enum cli_command id;
    const char *args, *doc;
    const struct argp_option *options;
    int subjects; /* words it needs */
    bool keys;    /* KEY=VALUE may follow */
};

static const struct argp_option run_options[] = {
    { "output", 'o', "DIR", 0, "Directory for the results (default: the scene's name)", 0 },
    { "method", 'm', "NAME", 0, "Time integration, see `stiffwater list methods`", 0 },
    { "tol", 't', "X", 0, "Error allowed in a step", 0 },
    { "until", 'u', "T", 0, "Time at which the run ends [s]", 0 },
    { "threads", 'n', "N", 0, "OpenMP threads; the results do not depend on it", 0 },
    { "quiet", 'q', NULL, 0, "No progress line", 0 },
    { 0 },
};

static const struct argp_option no_options[] = { { 0 } };

static const struct command commands[] = {
    { "run", CLI_RUN, "SCENE [KEY=VALUE ...]",
      "Simulates a scene and leaves tables, particle fields and figures' data in a directory.\v"
      "Any key of the scene can be set: beam.E=5e9 sets E of every beam, beam.plate.E=5e9 of "
      "one.  Exit status: 0 done, 1 the run failed, 2 the scene or the command line is wrong, "
      "3 stopped by SIGINT or SIGTERM (files are complete), 4 input or output failed.",
      run_options, 1, true },
    { "check", CLI_CHECK, "SCENE [KEY=VALUE ...]",
      "Prints the plan of a scene: parts, sizes, Mach number, expected steps, time and memory. "
      "Simulates nothing, writes nothing.", run_options, 1, true },
    { "plot", CLI_PLOT, "DIR", "Draws the figures of a run again, by gnuplot.", no_options, 1,
      false },
    { "list", CLI_LIST, "TABLE",
      "Lists what there is: effects, kernels, eos, pressure, walls, bodies or methods.", no_options, 1, false },
    { "explain", CLI_EXPLAIN, "NAME",
      "Explains an effect, kernel, equation of state, wall model, body or group of keys: "
      "equation, source, parameters with units and defaults.", no_options, 1, false },
    { "resume", CLI_RESUME, "DIR", "Goes on from the last checkpoint (not there yet).",
      no_options, 1, false },
    { "compare", CLI_COMPARE, "SCENE [KEY=VALUE ...]",
      "Runs a scene with many methods (not there yet).", no_options, 1, true },
};

enum { COMMANDS = sizeof commands / sizeof commands[0], TEXT = 128 };

struct state {
    const struct command *command;
    struct cli *cli;
    char text[CLI_OVERRIDES][TEXT]; /* overrides made of options live as long as the program */
};

static void add_override(struct argp_state *argp, const char *key, const char *value)
{
    struct state *s = argp->input;
    char *text;

    if (s->cli->overrides == CLI_OVERRIDES)
        argp_error(argp, "more than %d settings", CLI_OVERRIDES);
    text = s->text[s->cli->overrides];
    if (value && snprintf(text, TEXT, "%s=%s", key, value) >= TEXT)
        argp_error(argp, "%.32s...: a %s this long cannot be right", value, key);
    s->cli->override[s->cli->overrides++] = value ? text : key;
}

static int positive(struct argp_state *argp, const char *arg)
{
    char *end;
    const long n = strtol(arg, &end, 10);

    if (*end || n < 1 || n > 4096)
        argp_error(argp, "--threads %s: a number from 1 to 4096 is expected", arg);
    return (int)n;
}

static void take_word(struct argp_state *argp, const char *word)
{
    struct state *s = argp->input;

    if (!s->cli->subject)
        s->cli->subject = word;
    else if (s->command->keys && strchr(word, '='))
        add_override(argp, word, NULL);
    else if (s->command->keys)
        argp_error(argp, "%s: not of the form KEY=VALUE", word);
    else
        argp_error(argp, "%s: one word too many", word);
}

static error_t take(int key, char *arg, struct argp_state *argp)
{
    struct state *s = argp->input;

    switch (key) {
    case 'o': s->cli->directory = arg; break;
    case 'm': add_override(argp, "method", arg); break;
    case 't': add_override(argp, "tol", arg); break;
    case 'u': add_override(argp, "until", arg); break;
    case 'n': s->cli->threads = positive(argp, arg); break;
    case 'q': s->cli->quiet = true; break;
    case ARGP_KEY_ARG: take_word(argp, arg); break;
    case ARGP_KEY_END:
        if (!s->cli->subject)
            argp_error(argp, "%s what? Usage: %s %s", s->command->name, s->command->name,
                       s->command->args);
        break;
    default: return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

static void help(FILE *to)
{
    fputs("Usage: stiffwater COMMAND ...\n\n"
          "Particle hydrodynamics and the structures it hits, as one ordinary differential\n"
          "equation that SUNDIALS integrates with error control.\n\n", to);
    for (int i = 0; i < COMMANDS; i++)
        fprintf(to, "  %-8s %-22.22s %.*s\n", commands[i].name, commands[i].args,
                (int)strcspn(commands[i].doc, ".\v") + 1, commands[i].doc);
    fputs("\n  COMMAND --help      options of a command\n"
          "  --version           versions of the program and its libraries\n", to);
}

static const struct command *find(const char *name)
{
    for (int i = 0; i < COMMANDS; i++)
        if (strcmp(commands[i].name, name) == 0)
            return &commands[i];
    fprintf(stderr, "stiffwater: %s: no such command; there are", name);
    for (int i = 0; i < COMMANDS; i++)
        fprintf(stderr, " %s", commands[i].name);
    fputs("; see stiffwater --help\n", stderr);
    exit(STATUS_BAD_SCENE);
}

/* A stream that is closed would lend its number to the first file that is opened,
 * and messages would go there. */
static void hold_streams(void)
{
    int file = 0;

    while (file >= 0 && file <= 2)
        file = open("/dev/null", O_RDWR);
    if (file > 2)
        close(file);
}

void cli_parse(int argc, char **argv, struct cli *c)
{
    static struct state s;
    static char name[64];
    struct argp argp = { .parser = take };

    hold_streams();
    *c = (struct cli){0};
    argp_err_exit_status = STATUS_BAD_SCENE;
    if (argc < 2) {
        help(stderr);
        exit(STATUS_BAD_SCENE);
    }
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0
        || strcmp(argv[1], "help") == 0) {
        help(stdout);
        exit(STATUS_DONE);
    }
    if (strcmp(argv[1], "--version") == 0 || strcmp(argv[1], "-V") == 0) {
        cli_version();
        exit(STATUS_DONE);
    }
    s = (struct state){ .command = find(argv[1]), .cli = c };
    c->command = s.command->id;
    snprintf(name, sizeof name, "stiffwater %s", argv[1]);
    argp.options = s.command->options;
    argp.args_doc = s.command->args;
    argp.doc = s.command->doc;
    argv[1] = name;
    argp_parse(&argp, argc - 1, argv + 1, 0, NULL, &s);
    argv[1] = (char *)s.command->name;
}
