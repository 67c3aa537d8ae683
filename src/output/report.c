/* report.c -- what a run left as one page. */
#include "output/report.h"

#include "base/status.h"
#include "output/json-find.h"
#include "output/numbers.h"
#include "output/page.h"

#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { TEXT = 8192 };

struct source {
    const char *run;
    char json[ASIDE_PATH]; /* path of run.json */
    bool ran;              /* it is a run      */
};

static const char *const studies[] = { "compare.md", "sweep.md", "spread.md" };

static void write_status(struct page *p, const struct source *s)
{
    char status[40], message[TEXT], words[TEXT + 200];

    json_find_text(s->json, "status", status, sizeof status);
    json_find_text(s->json, "message", message, sizeof message);
    snprintf(words, sizeof words, "%s%s%s", status, message[0] ? ": " : "", message);
    page_paragraph(p, strcmp(status, "done") == 0 ? NULL : "bad", words);
    snprintf(words, sizeof words, "%.4g s simulated in %.0f steps, %.4g s by the clock.",
             json_find_number(s->json, "t_end"), json_find_number(s->json, "steps"),
             json_find_number(s->json, "wall_s"));
    page_paragraph(p, NULL, words);
}

static void write_numbers(struct page *p, const struct source *s)
{
    static const char *const names[] = { "quantity", "value", "held against" };
    struct numbers n;

    numbers_read(&n, s->run);
    page_heading(p, "Numbers");
    page_table(p, names, 3);
    for (int i = 0; i < n.n; i++) {
        const char *const cells[] = { n.row[i].what, n.row[i].value, n.row[i].against };
        page_row(p, n.row[i].wrong ? "wrong" : NULL, cells, 3);
    }
    page_table_end(p);
}

static void write_warnings(struct page *p, const struct source *s)
{
    char text[TEXT];
    int n = 0;

    page_heading(p, "Warnings");
    for (; json_find_item(s->json, "warnings", n, text, sizeof text); n++)
        page_paragraph(p, "wrong", text);
    if (n == 0)
        page_paragraph(p, NULL, "None.");
}

/* What a script says of itself in the lines at its top: "# front.gp -- how far ...", up to the
 * first full stop or line that tells of something else. */
static void find_words(const char *directory, const char *picture, char *to, size_t size)
{
    char path[ASIDE_PATH], line[400], *at;
    FILE *from;

    snprintf(to, size, "%s", picture);
    if (snprintf(path, sizeof path, "%s/%.*s.gp", directory, (int)(strlen(picture) - 4), picture)
        >= ASIDE_PATH)
        return;
    from = fopen(path, "r");
    while (from && fgets(line, sizeof line, from) && line[0] == '#' && line[1] == ' ') {
        const size_t n = strlen(to);
        at = strstr(line, ".gp -- ");
        line[strcspn(line, "\n")] = '\0';
        if ((at == NULL) == (n == strlen(picture)) || strstr(line, "needs: "))
            break;
        snprintf(to + n, size - n, "%s%s", at ? ": " : " ", at ? at + 7 : line + 2);
    }
    if (from)
        fclose(from);
}

static int is_picture(const struct dirent *entry)
{
    const char *end = strrchr(entry->d_name, '.');

    return entry->d_name[0] != '.' && end && strcmp(end, ".png") == 0;
}

static int write_figures(struct page *p, const struct source *s)
{
    char directory[ASIDE_PATH], path[ASIDE_PATH], words[2000];
    struct dirent **entry = NULL;
    int n, shown = 0;

    TRY(aside_join(directory, s->run, "figures"));
    n = scandir(directory, &entry, is_picture, alphasort);
    page_heading(p, "Figures");
    for (int i = 0; i < n; i++) {
        find_words(directory, entry[i]->d_name, words, sizeof words);
        if (aside_join(path, directory, entry[i]->d_name) == STATUS_DONE)
            shown += page_picture(p, path, words);
        free(entry[i]);
    }
    free(entry);
    if (shown == 0)
        page_paragraph(p, NULL, "None are drawn: gnuplot is missing, or there is nothing to show.");
    return STATUS_DONE;
}

static void write_files(struct page *p, const struct source *s)
{
    static const char *const names[] = { "scene.used", "run.json", "compare.json", "spread.json" };
    static const char *const words[] = {
        "The scene as it was used, every default in it: running it again gives the same bits",
        "run.json: what the run took", "compare.json: the reference", "spread.json"
    };
    char path[ASIDE_PATH];

    page_heading(p, s->ran ? "Scene and work" : "Words and records");
    for (size_t i = 0; i < sizeof studies / sizeof studies[0]; i++)
        if (aside_join(path, s->run, studies[i]) == STATUS_DONE)
            page_text_file(p, studies[i], path);
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        if (aside_join(path, s->run, names[i]) == STATUS_DONE)
            page_text_file(p, words[i], path);
}

static void write_versions(struct page *p, const struct source *s, const char *versions)
{
    char version[80], words[TEXT];

    page_heading(p, "Versions");
    if (s->ran && json_find_text(s->json, "version", version, sizeof version)) {
        snprintf(words, sizeof words, "The run: stiffwater %s.", version);
        page_paragraph(p, NULL, words);
    }
    snprintf(words, sizeof words, "This page: %s", versions);
    page_paragraph(p, NULL, words);
}

int report_write(const char *run, const char *versions)
{
    struct source s = { .run = run };
    char title[400], path[ASIDE_PATH];
    struct page p;
    int status;

    TRY(aside_join(s.json, run, "run.json"));
    TRY(aside_join(path, run, "report.html"));
    s.ran = access(s.json, R_OK) == 0;
    if (!s.ran || !json_find_text(s.json, "title", title, sizeof title) || !title[0])
        snprintf(title, sizeof title, "%.300s", run);
    TRY(page_open(&p, path, title));
    if (s.ran) {
        write_status(&p, &s);
        write_numbers(&p, &s);
        write_warnings(&p, &s);
    }
    status = write_figures(&p, &s);
    write_files(&p, &s);
    write_versions(&p, &s, versions);
    if (status != STATUS_DONE) {
        aside_drop(&p.file);
        return status;
    }
    TRY(page_close(&p));
    printf("%s\n", path);
    return STATUS_DONE;
}
