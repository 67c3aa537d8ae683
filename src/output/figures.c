/* figures.c -- finds the scripts that apply, brings them to a room, lets gnuplot draw. */
#include "output/figures.h"

#include "base/status.h"
#include "output/figures-room.h"
#include "output/gnuplot.h"
#include "output/shots.h"
#include <dirent.h>
#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { LINE = 4096, WORDS = 16 };

/* Is there such a file, and, for a .csv, a row below its names? */
static bool has_data(const char *run, const char *name)
{
    const char *end = strrchr(name, '.');
    const int wanted = end && !strcmp(end, ".csv") ? 2 : 0;
    char path[ASIDE_PATH];
    int rows = 0, c, before = '\n';
    FILE *in;

    if (snprintf(path, sizeof path, "%s/%s", run, name) >= ASIDE_PATH)
        return false;
    in = fopen(path, "r");
    if (!in)
        return false;
    while (rows < wanted && (c = fgetc(in)) != EOF) {
        rows += before == '\n' && c != '#' && c != '\n';
        before = c;
    }
    fclose(in);
    return rows >= wanted;
}

/* What stands after "# KEY:" in the comment lines at the top of a script. */
struct wish {
    char line[LINE];
    int words;
    char *word[WORDS];
};

static void read_wish(const char *script, const char *key, struct wish *w)
{
    FILE *in = fopen(script, "r");
    const size_t n = strlen(key);
    char *rest = NULL, *word = NULL;

    w->words = 0;
    while (in && !word && fgets(w->line, sizeof w->line, in) && w->line[0] == '#')
        if (!strncmp(w->line, "# ", 2) && !strncmp(w->line + 2, key, n) && w->line[2 + n] == ':')
            word = strtok_r(w->line + 3 + n, " \t\n", &rest);
    for (; word && w->words < WORDS; word = strtok_r(NULL, " \t\n", &rest))
        w->word[w->words++] = word;
    if (in)
        fclose(in);
}

struct places {
    const char *run, *scripts, *reference;
    struct figures_room room;
};

static bool has_needs(const struct places *at, const struct wish *needs)
{
    for (int i = 0; i < needs->words; i++)
        if (!has_data(at->run, needs->word[i]))
            return false;
    return true;
}

static int bring_references(const struct places *at, const char *script)
{
    struct wish reference;

    read_wish(script, "reference", &reference);
    for (int i = 0; i < reference.words; i++)
        TRY(figures_room_bring(&at->room, at->reference, reference.word[i]));
    return STATUS_DONE;
}

/* Needs in figures/ are data for scripts to load. */
static int bring_data(const struct places *at, const struct wish *needs)
{
    static const char figures[] = "figures/";

    for (int i = 0; i < needs->words; i++)
        if (strncmp(needs->word[i], figures, strlen(figures)) == 0)
            TRY(figures_room_bring_data(&at->room, needs->word[i] + strlen(figures)));
    return STATUS_DONE;
}

static int draw(const struct places *at, const char *script, const char *name,
                const struct wish *needs)
{
    TRY(bring_references(at, script));
    TRY(bring_data(at, needs));
    TRY(figures_room_bring(&at->room, at->scripts, name));
    return gnuplot_run(at->room.at, name, at->room.figures);
}

/* Scripts without needs are for others to load: they are brought, not drawn. */
static int serve(const struct places *at, const char *name, bool helpers)
{
    char script[ASIDE_PATH];
    struct wish needs;

    TRY(aside_join(script, at->scripts, name));
    read_wish(script, "needs", &needs);
    if (helpers)
        return needs.words == 0 ? figures_room_bring(&at->room, at->scripts, name) : STATUS_DONE;
    return needs.words > 0 && has_needs(at, &needs) ? draw(at, script, name, &needs)
                                                    : STATUS_DONE;
}

static int is_script(const struct dirent *entry)
{
    const char *end = strrchr(entry->d_name, '.');

    return end && end != entry->d_name && !strcmp(end, ".gp");
}

/* Pictures of particles are of what is seen of them. */
static int prepare_shots(const struct places *at)
{
    if (!has_data(at->run, "snapshots.csv") || !has_data(at->run, "figures/constants.gp"))
        return STATUS_DONE;
    TRY(figures_room_bring_data(&at->room, "constants.gp"));
    return shots_prepare(at->run, at->room.at);
}

/* What others load is brought first. */
static int serve_all(const struct places *at, struct dirent **entry, int n)
{
    int code = STATUS_DONE;

    TRY(prepare_shots(at));
    for (int i = 0; i < n; i++)
        TRY(serve(at, entry[i]->d_name, true));
    for (int i = 0; i < n; i++)
        if (serve(at, entry[i]->d_name, false) != STATUS_DONE)
            code = STATUS_IO;
    return code;
}

/* What was drawn is kept also when something could not be. */
static int serve_and_hang(const struct places *at, struct dirent **entry, int n)
{
    const int served = serve_all(at, entry, n), hung = figures_room_hang(&at->room);

    return served != STATUS_DONE ? served : hung;
}

int figures_draw(const char *run, const char *scripts, const char *reference)
{
    struct places at = { .run = run, .scripts = scripts, .reference = reference };
    struct dirent **entry;
    int n, code;

    n = scandir(scripts, &entry, is_script, alphasort);
    if (n < 0)
        return status_fail(STATUS_IO, "%s: the scripts for gnuplot cannot be read: %s", scripts,
                           strerror(errno));
    code = figures_room_make(&at.room, run);
    if (code == STATUS_DONE)
        code = serve_and_hang(&at, entry, n);
    while (n > 0)
        free(entry[--n]);
    free(entry);
    return code;
}
