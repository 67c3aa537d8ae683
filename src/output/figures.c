/* figures.c -- finds the scripts that apply, brings them to the run, lets gnuplot draw. */
#include "output/figures.h"

#include "base/status.h"
#include "output/aside.h"
#include "output/gnuplot.h"
#include <dirent.h>
#include <errno.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { LINE = 4096, WORDS = 16 };

static int copy(const char *from, const char *path)
{
    FILE *in = fopen(from, "r");
    struct aside a;
    char bytes[LINE];
    size_t n;

    if (!in)
        return status_fail(STATUS_IO, "%s: cannot be read: %s", from, strerror(errno));
    if (aside_open(&a, path) != STATUS_DONE) {
        fclose(in);
        return STATUS_IO;
    }
    while ((n = fread(bytes, 1, sizeof bytes, in)) > 0)
        fwrite(bytes, 1, n, a.to);
    fclose(in);
    return aside_close(&a);
}

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
    char figures[ASIDE_PATH];
};

static bool has_needs(const struct places *at, const struct wish *needs)
{
    for (int i = 0; i < needs->words; i++)
        if (!has_data(at->run, needs->word[i]))
            return false;
    return true;
}

static int bring(const struct places *at, const char *dir, const char *name)
{
    char from[ASIDE_PATH], to[ASIDE_PATH];

    TRY(aside_join(from, dir, name));
    TRY(aside_join(to, at->figures, name));
    return copy(from, to);
}

static int bring_references(const struct places *at, const char *script)
{
    struct wish reference;

    read_wish(script, "reference", &reference);
    for (int i = 0; i < reference.words; i++)
        TRY(bring(at, at->reference, reference.word[i]));
    return STATUS_DONE;
}

/* NAME.gp draws NAME.png, NAME-*.png or, when there is nothing to show, none. */
static bool is_drawn_by(const char *png, const char *script)
{
    const size_t n = strlen(script) - strlen(".gp");
    const char *end = strrchr(png, '.');

    return end && !strncmp(png, script, n) && (png[n] == '-' || png[n] == '.')
           && !strcmp(end, ".png");
}

static void each_png(const struct places *at, const char *script, void (*what)(const char *path))
{
    struct dirent **entry;
    const int n = scandir(at->figures, &entry, NULL, alphasort);
    char path[ASIDE_PATH];

    for (int i = 0; i < n; i++) {
        if (is_drawn_by(entry[i]->d_name, script)
            && aside_join(path, at->figures, entry[i]->d_name) == STATUS_DONE)
            what(path);
        free(entry[i]);
    }
    if (n >= 0)
        free(entry);
}

static void take_away(const char *path)
{
    remove(path);
}

static void say(const char *path)
{
    printf("%s\n", path);
}

static int draw(const struct places *at, const char *script, const char *name)
{
    TRY(bring_references(at, script));
    TRY(bring(at, at->scripts, name));
    each_png(at, name, take_away);
    TRY(gnuplot_run(at->figures, name));
    each_png(at, name, say);
    return STATUS_DONE;
}

/* Scripts without needs are for others to load: they are brought, not drawn. */
static int serve(const struct places *at, const char *name, bool helpers)
{
    char script[ASIDE_PATH];
    struct wish needs;

    TRY(aside_join(script, at->scripts, name));
    read_wish(script, "needs", &needs);
    if (helpers)
        return needs.words == 0 ? bring(at, at->scripts, name) : STATUS_DONE;
    return needs.words > 0 && has_needs(at, &needs) ? draw(at, script, name) : STATUS_DONE;
}

static int is_script(const struct dirent *entry)
{
    const char *end = strrchr(entry->d_name, '.');

    return end && end != entry->d_name && !strcmp(end, ".gp");
}

/* What others load is brought first. */
static int serve_all(const struct places *at, struct dirent **entry, int n)
{
    int code = STATUS_DONE;

    for (int i = 0; i < n; i++)
        TRY(serve(at, entry[i]->d_name, true));
    for (int i = 0; i < n; i++)
        if (serve(at, entry[i]->d_name, false) != STATUS_DONE)
            code = STATUS_IO;
    return code;
}

int figures_draw(const char *run, const char *scripts, const char *reference)
{
    struct places at = { .run = run, .scripts = scripts, .reference = reference };
    struct dirent **entry;
    int n, code;

    TRY(aside_join(at.figures, run, "figures"));
    TRY(aside_directory(at.figures));
    n = scandir(scripts, &entry, is_script, alphasort);
    if (n < 0)
        return status_fail(STATUS_IO, "%s: the scripts for gnuplot cannot be read: %s", scripts,
                           strerror(errno));
    code = serve_all(&at, entry, n);
    while (n > 0)
        free(entry[--n]);
    free(entry);
    return code;
}
