/* trials.c -- the runs of a comparison: which there are, and their names. */
#include "study/trials.h"

#include "base/status.h"
#include "time/method.h"

#include <stdio.h>
#include <string.h>

static void set(struct trial *t, struct point *p, const char *method, const char *tol, int repeat,
                const char *before)
{
    t->point = p;
    t->repeat = repeat;
    t->run.until = p->facts.until;
    snprintf(t->method, sizeof t->method, "%s", method);
    snprintf(t->tol, sizeof t->tol, "%s", tol);
    member_name_add(&t->run, before);
    member_name_add(&t->run, method);
    if (*tol)
        member_name_add(&t->run, "-");
    member_name_add(&t->run, tol);
    if (*p->label)
        member_name_add(&t->run, "-");
    member_name_add(&t->run, p->label);
    if (repeat > 0)
        snprintf(t->run.name + strlen(t->run.name), 16, "-%d", repeat + 1);
}

/* Methods without error control, and steps of one length (NAME@1e-4s), have one case,
 * whatever the tolerances. */
static int has_tol(const char *method, bool *adaptive)
{
    struct method_def def = method_def_default();
    const struct method *m;

    TRY(method_find(method, &def, &m));
    *adaptive = m->adaptive && def.seconds == 0;
    return STATUS_DONE;
}

static int count_cases(struct study *s)
{
    for (int i = 0; i < s->methods.n; i++) {
        bool adaptive;
        if (strlen(s->methods.word[i]) >= INSIDE_WORD)
            return status_fail(STATUS_BAD_SCENE, "there is no method %.40s...", s->methods.word[i]);
        TRY(has_tol(s->methods.word[i], &adaptive));
        s->cases += adaptive ? s->tols.n : 1;
    }
    return STATUS_DONE;
}

static void add_cases(struct study *s, struct point *p, int repeat)
{
    for (int i = 0; i < s->methods.n; i++) {
        bool adaptive = false;
        has_tol(s->methods.word[i], &adaptive);
        for (int k = 0; k < (adaptive ? s->tols.n : 1); k++)
            set(&s->trial[s->trials++], p, s->methods.word[i], adaptive ? s->tols.word[k] : "",
                repeat, "");
    }
}

/* The first of its repeats. */
static struct trial *in_the_finest(const struct study *s, const struct trial *t)
{
    const long at = t->point->finest - s->point, i = t - s->trial;

    return &s->trial[at * s->cases + i % s->cases];
}

static void set_references(struct study *s)
{
    for (int i = 0; i < s->trials; i++) {
        struct trial *t = &s->trial[i];
        t->reference = s->finest ? in_the_finest(s, t) : t->point->reference;
    }
}

static int add_references(struct study *s)
{
    bool adaptive;

    TRY(has_tol(s->reference_method, &adaptive));
    for (int i = 0; i < s->points; i++) {
        struct point *p = &s->point[i];
        const char *tol = adaptive ? s->reference_tol : "";
        p->reference = &s->reference[i];
        set(p->reference, p, s->reference_method, tol, 0, "reference-");
        if (!s->order->growth)
            continue;
        p->disturbed = &s->reference[s->points + i];
        set(p->disturbed, p, s->reference_method, tol, 0, "disturbed-");
        p->disturbed->disturbed = true;
    }
    return STATUS_DONE;
}

int trials_make(struct study *s)
{
    const int repeat = s->order->repeat > 1 ? s->order->repeat : 1;

    TRY(count_cases(s));
    s->reference = status_alloc(2 * s->points, sizeof *s->reference);
    s->trial = status_alloc((unsigned long)repeat * s->points * s->cases, sizeof *s->trial);
    if (!s->reference || !s->trial)
        return STATUS_FAILED;
    for (int r = 0; r < repeat; r++)
        for (int i = 0; i < s->points; i++)
            add_cases(s, &s->point[i], r);
    if (!s->finest)
        TRY(add_references(s));
    set_references(s);
    return STATUS_DONE;
}
