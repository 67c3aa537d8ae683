/* member.c -- one run of a study: its command line, whether it is there, how it ended. */
#include "study/member.h"

#include "base/status.h"
#include "output/json-find.h"
#include "study/facts.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#ifndef PACKAGE_VERSION
#define PACKAGE_VERSION "unknown"
#endif

/* "path/dam-break.scene" becomes "dam-break" and the suffix. */
static int choose_directory(struct member_home *h, const char *asked, const char *suffix)
{
    const char *slash = strrchr(h->scene, '/');
    const char *from = asked ? asked : slash ? slash + 1 : h->scene;
    const char *dot = strrchr(from, '.');
    const bool ends = !asked && dot && strcmp(dot, ".scene") == 0;

    if (strlen(from) >= sizeof h->directory - 300)
        return status_fail(STATUS_IO, "%.200s...: this output directory is too far from the root",
                           from);
    snprintf(h->directory, sizeof h->directory, "%.*s%s",
             (int)(ends ? (size_t)(dot - from) : strlen(from)), from, asked ? "" : suffix);
    return STATUS_DONE;
}

/* The program is part of a run's identity: what was measured with another is another run. */
static int find_program(struct member_home *h)
{
    const ssize_t n = readlink("/proc/self/exe", h->program, sizeof h->program - 1);
    struct stat about = {0};
    char hash[32];

    if (n <= 0)
        return status_fail(STATUS_IO, "/proc/self/exe cannot be read: where is this program?");
    h->program[n] = '\0';
    stat(h->program, &about);
    TRY(facts_hash(h->scene, hash, sizeof hash));
    snprintf(h->identity, sizeof h->identity, "program %s, %lld bytes, %lld.%09ld\nscene %s\n",
             PACKAGE_VERSION, (long long)about.st_size, (long long)about.st_mtim.tv_sec,
             about.st_mtim.tv_nsec, hash);
    return STATUS_DONE;
}

int member_home_make(struct member_home *h, const char *asked, const char *suffix)
{
    TRY(choose_directory(h, asked, suffix));
    return find_program(h);
}

int member_home_claim(const struct member_home *h)
{
    TRY(aside_directory(h->directory));
    return mark_claim(h->owner, h->directory, h->scene, h->force);
}

int member_directory(const struct member_home *h, const struct member *m)
{
    char path[MEMBER_PATH];

    TRY(aside_join(path, "runs", m->name));
    TRY(mark_refuse_link(h->owner, h->directory, path));
    member_path(h, m, "", path);
    return aside_directory(path);
}

void member_name_add(struct member *m, const char *text)
{
    size_t n = strlen(m->name);

    for (; *text && n + 40 < sizeof m->name; text++) /* room for the number of a repeat */
        m->name[n++] = strchr(",/ \"'\\*?<>|&;()[]{}", *text) ? '_' : *text;
    m->name[n] = '\0';
}

void member_path(const struct member_home *h, const struct member *m, const char *file, char *to)
{
    snprintf(to, MEMBER_PATH, "%s/runs/%s%s%s", h->directory, m->name, *file ? "/" : "", file);
}

static void write_settings(FILE *to, const struct member_home *h, const char *settings)
{
    for (int i = 0; i < h->overrides; i++)
        fprintf(to, "%s\n", h->override[i]);
    fputs(settings, to);
}

static int threads(const struct member_home *h)
{
    return h->threads > 1 ? h->threads : 1;
}

/* The lines of text [size] as words, in one piece of memory. */
static char **cut(const char *text, size_t size)
{
    size_t lines = 0, n = 0;
    char **words, *rest;

    for (size_t i = 0; i < size; i++)
        lines += text[i] == '\n';
    words = malloc((lines + 1) * sizeof *words + size + 1);
    if (!words)
        return NULL;
    rest = memcpy(words + lines + 1, text, size + 1);
    while (n < lines)
        words[n++] = strsep(&rest, "\n");
    words[n] = NULL;
    return words;
}

char **member_words(const struct member_home *h, const struct member *m, const char *settings)
{
    char directory[MEMBER_PATH], *text = NULL, **words;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);

    if (!to)
        return NULL;
    member_path(h, m, "", directory);
    fprintf(to, "%s\n%s\n%s\n", h->program, h->command ? h->command : "run", h->scene);
    write_settings(to, h, settings);
    fprintf(to, "-q\n-n\n%d\n-o\n%s\n", threads(h), directory);
    fclose(to);
    words = cut(text, size);
    free(text);
    return words;
}

/* What makes a run the same run: program, scene, settings, threads. */
static char *describe(const struct member_home *h, const char *settings)
{
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);

    if (!to)
        return NULL;
    fprintf(to, "%s", h->identity);
    write_settings(to, h, settings);
    fprintf(to, "threads %d\n", threads(h));
    fclose(to);
    return text;
}

/* A run that was cut short counts only for the budget that did it. */
static bool same_end(const struct member_home *h, const char *end, struct member *m)
{
    double budget;
    int late;

    if (sscanf(end, "ended %d %d %lf", &m->code, &late, &budget) != 3)
        return false;
    m->late = late != 0;
    return m->late ? budget == h->budget : m->code >= 0;
}

/* The last thing that the program said, without its name. */
static void read_said(const struct member_home *h, struct member *m)
{
    static const char name[] = "stiffwater: ", warning[] = "stiffwater: warning: ";
    char path[MEMBER_PATH], line[MEMBER_MESSAGE];
    FILE *from;

    member_path(h, m, "said", path);
    from = m->code != STATUS_DONE ? fopen(path, "r") : NULL;
    while (from && fgets(line, sizeof line, from)) {
        line[strcspn(line, "\n")] = '\0';
        if (strncmp(line, name, strlen(name)) == 0
            && strncmp(line, warning, strlen(warning)) != 0)
            snprintf(m->message, sizeof m->message, "%s", line + strlen(name));
    }
    if (from)
        fclose(from);
}

/* Why it ended, in a sentence. */
static void read_end(const struct member_home *h, struct member *m)
{
    char report[MEMBER_PATH];

    m->message[0] = '\0';
    read_said(h, m);
    member_path(h, m, "run.json", report);
    if (m->late)
        snprintf(m->message, sizeof m->message, "stopped by the budget of %g s at t = %g s of %g s",
                 h->budget, json_find_number(report, "t_end"), m->until);
    else if (!m->message[0] && m->code < 0)
        snprintf(m->message, sizeof m->message, "ended by signal %d", -m->code);
    m->ended = true;
}

bool member_reuse(const struct member_home *h, struct member *m, const char *settings)
{
    char path[MEMBER_PATH], *wanted = describe(h, settings), *found;
    const size_t n = wanted ? strlen(wanted) : 0;
    FILE *from;

    member_path(h, m, "order", path);
    from = wanted ? fopen(path, "r") : NULL;
    found = from ? calloc(n + 256, 1) : NULL;
    if (found && fread(found, 1, n + 255, from) > n && strncmp(found, wanted, n) == 0)
        m->reused = same_end(h, found + n, m);
    if (from)
        fclose(from);
    free(found);
    free(wanted);
    if (m->reused)
        read_end(h, m);
    return m->reused;
}

int member_end(const struct member_home *h, struct member *m, const char *settings)
{
    char path[MEMBER_PATH], *text = describe(h, settings);
    struct aside a;

    if (!text)
        return status_starved("the order of a run cannot be kept");
    member_path(h, m, "order", path);
    if (aside_open(&a, path) != STATUS_DONE) {
        free(text);
        return STATUS_IO;
    }
    fprintf(a.to, "%sended %d %d %.17g\n", text, m->code, m->late, h->budget);
    free(text);
    TRY(aside_close(&a));
    read_end(h, m);
    return STATUS_DONE;
}

const char *member_status(const struct member *m)
{
    if (m->code == STATUS_DONE)
        return "done";
    if (m->code == STATUS_BAD_SCENE)
        return "refused";
    return m->late || m->code == STATUS_STOPPED ? "stopped" : "failed";
}
