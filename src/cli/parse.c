/* parse.c -- commands and options, by argp. */
#include "cli/commands.h"

#include "base/status.h"

#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { TEXT = 128 };

struct state {
    const struct commands_row *command;
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

static int whole(struct argp_state *argp, const char *option, const char *arg, int low, int high)
{
    char *end;
    const long n = strtol(arg, &end, 10);

    if (*end || end == arg || n < low || n > high)
        argp_error(argp, "--%s %s: a number from %d to %d is expected", option, arg, low, high);
    return (int)n;
}

static int positive(struct argp_state *argp, const char *option, const char *arg)
{
    return whole(argp, option, arg, 1, 4096);
}

static double seconds(struct argp_state *argp, const char *option, const char *arg)
{
    char *end;
    const double s = strtod(arg, &end);

    if (*end || !(s > 0 && s <= 1e9))
        argp_error(argp, "--%s %s: a number of seconds above 0 is expected", option, arg);
    return s;
}

static void add_sweep(struct argp_state *argp, const char *arg)
{
    struct state *s = argp->input;

    if (s->cli->sweeps == COMPARE_SWEEPS)
        argp_error(argp, "more than %d keys to sweep", COMPARE_SWEEPS);
    s->cli->sweep[s->cli->sweeps++] = arg;
}

static void take_word(struct argp_state *argp, const char *word)
{
    struct state *s = argp->input;

    if (!s->cli->subject)
        s->cli->subject = s->command->keys && strcmp(word, "-") == 0 ? "/dev/stdin" : word;
    else if (s->command->keys && strchr(word, '='))
        add_override(argp, word, NULL);
    else if (s->command->keys)
        argp_error(argp, "%s: not of the form KEY=VALUE", word);
    else
        argp_error(argp, "%s: one word too many", word);
}

/* Numbers between commas, `n' of them, from low to high. */
static void numbers(struct argp_state *argp, const char *option, const char *arg, int n,
                    const double between[2], double *to)
{
    const char *at = arg;

    for (int i = 0; i < n; i++) {
        char *end;
        to[i] = strtod(at, &end);
        if (end == at || *end != (i < n - 1 ? ',' : '\0')
            || !(to[i] >= between[0] && to[i] <= between[1]))
            argp_error(argp, "--%s %s: %s from %g to %g %s expected", option, arg,
                       n > 1 ? "two numbers, FROM,TO," : "a number", between[0], between[1],
                       n > 1 ? "are" : "is");
        at = end + 1;
    }
}

static error_t take_spread(int key, char *arg, struct argp_state *argp)
{
    static const double sizes[] = { 0, 0.01 }, shares[] = { 1e-9, 10 }, times[] = { 0, 1e6 };
    struct cli_spread *s = &((struct state *)argp->input)->cli->spread;

    switch (key) {
    case 'N': s->runs = whole(argp, "runs", arg, 2, 999); break;
    case 'S': s->seed = whole(argp, "seed", arg, 0, 999999000); break;
    case 'd': numbers(argp, "size", arg, 1, sizes, &s->size); break;
    case 'p': numbers(argp, "share", arg, 1, shares, &s->share); break;
    case 'w': numbers(argp, "window", arg, 2, times, s->window); break;
    default: return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

static error_t take_hull(int key, char *arg, struct argp_state *argp)
{
    static const double scales[] = { 1e-12, 1e12 }, lengths[] = { 0, 1e6 };
    struct cli_stl *s = &((struct state *)argp->input)->cli->hull;

    switch (key) {
    case 'x': numbers(argp, "scale", arg, 1, scales, &s->scale); break;
    case 'G': numbers(argp, "merge", arg, 1, lengths, &s->merge); break;
    default: return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

static error_t take_comparison(int key, char *arg, struct argp_state *argp)
{
    struct cli *c = ((struct state *)argp->input)->cli;

    switch (key) {
    case 'M': c->methods = arg; break;
    case 'T': c->tols = arg; break;
    case 'R': c->reference = arg; break;
    case 's': add_sweep(argp, arg); break;
    case 'r': c->repeat = positive(argp, "repeat", arg); break;
    case 'j': c->jobs = positive(argp, "jobs", arg); break;
    case 'b': c->budget = seconds(argp, "budget", arg); break;
    case 'e': c->early = seconds(argp, "early", arg); break;
    case 'g': c->growth = true; break;
    default: return take_spread(key, arg, argp) == 0 ? 0 : take_hull(key, arg, argp);
    }
    return 0;
}

/* An option is one way to set a key, KEY=VALUE another: with both, one of them was forgotten.  Of
 * KEY=VALUE twice the last counts, as scripts want it. */
static void check_twice(struct argp_state *argp)
{
    static const char *const keys[] = { "method=", "tol=", "until=" };
    const struct state *s = argp->input;

    for (size_t k = 0; k < sizeof keys / sizeof keys[0]; k++) {
        const char *option = NULL, *word = NULL;
        for (int i = 0; i < s->cli->overrides; i++)
            if (strncmp(s->cli->override[i], keys[k], strlen(keys[k])) == 0)
                *(s->cli->override[i] == s->text[i] ? &option : &word) = s->cli->override[i];
        if (option && word)
            argp_error(argp, "%.*s is set twice, by an option to %s and by a word to %s: leave one "
                       "of them out", (int)strlen(keys[k]) - 1, keys[k],
                       option + strlen(keys[k]), word + strlen(keys[k]));
    }
}

static void check_whole(struct argp_state *argp)
{
    struct state *s = argp->input;

    check_twice(argp);
    if (!s->cli->subject)
        argp_error(argp, "%s what? Usage: %s %s", s->command->name, s->command->name,
                   s->command->args);
    if (s->command->id == CLI_COMPARE && !s->cli->methods)
        argp_error(argp, "--methods is missing: which methods are to be compared? For example "
                   "--methods cks43,leapfrog@0.25; `stiffwater list methods` shows all");
}

static error_t take(int key, char *arg, struct argp_state *argp)
{
    struct state *s = argp->input;

    switch (key) {
    case 'o': s->cli->directory = arg; break;
    case 'm': add_override(argp, "method", arg); break;
    case 't': add_override(argp, "tol", arg); break;
    case 'u': add_override(argp, "until", arg); break;
    case 'n': s->cli->threads = positive(argp, "threads", arg); break;
    case 'P': s->cli->ranks = positive(argp, "ranks", arg); break;
    case 'q': s->cli->quiet = true; break;
    case 'f': s->cli->force = true; break;
    case ARGP_KEY_ARG: take_word(argp, arg); break;
    case ARGP_KEY_END: check_whole(argp); break;
    default: return take_comparison(key, arg, argp);
    }
    return 0;
}

/* The first sentence of a command's words, in lines below its name.  A point inside a word ends
 * none. */
static void sentence(FILE *to, const char *doc)
{
    const int indent = 11, width = 80;
    int column = width;

    for (const char *end = NULL; doc; doc = end) {
        int length = (int)strcspn(doc, " \v");

        if (column + 1 + length > width) {
            fprintf(to, "%s%*s%.*s", end ? "\n" : "", indent, "", length, doc);
            column = indent + length;
        } else {
            fprintf(to, " %.*s", length, doc);
            column += 1 + length;
        }
        end = doc[length] == ' ' && doc[length - 1] != '.' ? doc + length + 1 : NULL;
    }
    fputc('\n', to);
}

static void help(FILE *to)
{
    fputs("Usage: stiffwater COMMAND ...\n\n"
          "Particle hydrodynamics and the structures it hits, as one ordinary differential\n"
          "equation that SUNDIALS integrates with error control.\n\n", to);
    for (int i = 0; commands_table[i].name; i++) {
        fprintf(to, "  %-8s %s\n", commands_table[i].name, commands_table[i].args);
        sentence(to, commands_table[i].doc);
    }
    fputs("\n  COMMAND --help      options of a command\n"
          "  --version           versions of the program and its libraries\n", to);
}

static const struct commands_row *find(const char *name)
{
    for (int i = 0; commands_table[i].name; i++)
        if (strcmp(commands_table[i].name, name) == 0)
            return &commands_table[i];
    fprintf(stderr, "stiffwater: %s: no such command; there are", name);
    for (int i = 0; commands_table[i].name; i++)
        fprintf(stderr, " %s", commands_table[i].name);
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
    *c = (struct cli){ .hull.scale = 1,
                       .spread = { .runs = 8, .seed = 1, .size = 1e-6, .share = 0.1,
                                   .window = { NAN, NAN } } };
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
        cli_version(stdout);
        exit(STATUS_DONE);
    }
    s = (struct state){ .command = find(argv[1]), .cli = c };
    c->command = s.command->id;
    snprintf(name, sizeof name, "stiffwater %s", argv[1]);
    argp.options = s.command->options;
    argp.args_doc = s.command->args;
    argp.doc = s.command->doc;
    argv[1] = name;
    if (argp_parse(&argp, argc - 1, argv + 1, 0, NULL, &s) != 0) {
        fputs("stiffwater: out of memory: the command line cannot be read\n", stderr);
        exit(STATUS_FAILED);
    }
    argv[1] = (char *)s.command->name;
}
