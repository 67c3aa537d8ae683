/* trial.c -- one run of a comparison: its command line, whether it is there, how it ended. */
#include "study/trial.h"

#include "base/status.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void trial_path(const struct study *s, const struct trial *t, const char *file, char *to)
{
    snprintf(to, INSIDE_PATH, "%s/runs/%s%s%s", s->directory, t->name, *file ? "/" : "", file);
}

/* Pictures until the time at which positions are compared. */
static int pictures(const struct trial *t)
{
    return t->disturbed || t == t->point->reference ? t->point->fine : 1;
}

/* Gravity tilted towards the axis along which it is least.  More of it would not do: with a
 * sound speed of sqrt(gH) that only makes the same flow faster. */
static void write_tilt(FILE *to, const struct point *p)
{
    const double *g = p->gravity;
    int least = 0;

    for (int d = 1; d < p->dimension; d++)
        if (fabs(g[d]) < fabs(g[least]))
            least = d;
    fprintf(to, "gravity=[");
    for (int d = 0; d < p->dimension; d++)
        fprintf(to, "%s%.17g", d ? "," : "",
                g[d] + (d == least ? TRIAL_DISTURBANCE * sqrt(g[0] * g[0] + g[1] * g[1]
                                                              + g[2] * g[2]) : 0));
    fprintf(to, "]\n");
}

/* A setting of the scene, one a line; what a reference is must be the same in each of them. */
static void write_settings(FILE *to, const struct study *s, const struct trial *t)
{
    const struct point *p = t->point;

    for (int i = 0; i < s->order->overrides; i++)
        fprintf(to, "%s\n", s->order->override[i]);
    for (int k = 0; k < s->sweeps; k++)
        fprintf(to, "%s=%s\n", s->key[k], p->value[k]);
    fprintf(to, "method=%s\n", t->method);
    if (*t->tol)
        fprintf(to, "tol=%s\n", t->tol);
    fprintf(to, "output.snapshots=%d\n", p->pieces * pictures(t) + 1);
    fprintf(to, "output.fields=%.17g\n", p->until);
    if (t->disturbed)
        write_tilt(to, p);
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

char **trial_words(const struct study *s, const struct trial *t)
{
    char directory[INSIDE_PATH], *text = NULL, **words;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);

    if (!to)
        return NULL;
    trial_path(s, t, "", directory);
    fprintf(to, "%s\nrun\n%s\n", s->program, s->order->scene);
    write_settings(to, s, t);
    fprintf(to, "-q\n-n\n%d\n-o\n%s\n", s->order->threads > 1 ? s->order->threads : 1, directory);
    fclose(to);
    words = cut(text, size);
    free(text);
    return words;
}

/* What makes a run the same run: program, scene, settings, threads. */
static char *describe(const struct study *s, const struct trial *t)
{
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);

    if (!to)
        return NULL;
    fprintf(to, "%s", s->identity);
    write_settings(to, s, t);
    fprintf(to, "threads %d\n", s->order->threads > 1 ? s->order->threads : 1);
    fclose(to);
    return text;
}

/* A run that was cut short counts only for the budget that did it. */
static bool same_end(const struct study *s, const char *end, struct trial *t)
{
    double budget;
    int late;

    if (sscanf(end, "ended %d %d %lf", &t->code, &late, &budget) != 3)
        return false;
    t->late = late != 0;
    return !t->late || budget == s->order->budget;
}

/* The last thing that the program said, without its name. */
static void read_message(const struct study *s, struct trial *t)
{
    static const char name[] = "stiffwater: ", warning[] = "stiffwater: warning: ";
    char path[INSIDE_PATH], line[INSIDE_MESSAGE];
    FILE *from;

    t->message[0] = '\0';
    trial_path(s, t, "said", path);
    from = t->code != STATUS_DONE ? fopen(path, "r") : NULL;
    while (from && fgets(line, sizeof line, from)) {
        line[strcspn(line, "\n")] = '\0';
        if (strncmp(line, name, strlen(name)) == 0
            && strncmp(line, warning, strlen(warning)) != 0)
            snprintf(t->message, sizeof t->message, "%s", line + strlen(name));
    }
    if (from)
        fclose(from);
    if (t->late)
        snprintf(t->message, sizeof t->message, "stopped by the budget of %g s at t = %g s of %g s",
                 s->order->budget, t->result.t_end, t->point->until);
    else if (!t->message[0] && t->code < 0)
        snprintf(t->message, sizeof t->message, "ended by signal %d", -t->code);
}

static void read_all(const struct study *s, struct trial *t)
{
    char dir[INSIDE_PATH], reference[INSIDE_PATH];

    trial_path(s, t, "", dir);
    result_read(&t->result, dir);
    read_message(s, t);
    t->ended = true;
    if (!t->point->reference->ended || t->point->reference->code != STATUS_DONE)
        return;
    trial_path(s, t->point->reference, "", reference);
    result_compare(&t->result, dir, pictures(t), reference, t->point->fine, t->point->dx);
}

bool trial_reuse(const struct study *s, struct trial *t)
{
    char path[INSIDE_PATH], *wanted = describe(s, t), *found;
    const size_t n = wanted ? strlen(wanted) : 0;
    FILE *from;

    trial_path(s, t, "order", path);
    from = wanted ? fopen(path, "r") : NULL;
    found = from ? calloc(n + 256, 1) : NULL;
    if (found && fread(found, 1, n + 255, from) > n && strncmp(found, wanted, n) == 0)
        t->reused = same_end(s, found + n, t);
    if (from)
        fclose(from);
    free(found);
    free(wanted);
    if (t->reused)
        read_all(s, t);
    return t->reused;
}

int trial_end(const struct study *s, struct trial *t)
{
    char path[INSIDE_PATH], *text = describe(s, t);
    struct aside a;

    if (!text)
        return status_fail(STATUS_FAILED, "out of memory");
    trial_path(s, t, "order", path);
    if (aside_open(&a, path) != STATUS_DONE) {
        free(text);
        return STATUS_IO;
    }
    fprintf(a.to, "%sended %d %d %.17g\n", text, t->code, t->late, s->order->budget);
    free(text);
    TRY(aside_close(&a));
    read_all(s, t);
    return STATUS_DONE;
}

const char *trial_status(const struct trial *t)
{
    if (t->code == STATUS_DONE)
        return "done";
    if (t->code == STATUS_BAD_SCENE)
        return "refused";
    return t->late || t->code == STATUS_STOPPED ? "stopped" : "failed";
}
