/* past.c -- what a run knows of its past, on its way to a checkpoint and back. */
#include "run/past.h"

#include "base/status.h"

#include <stdio.h>
#include <string.h>

static int keep_tally(struct run_tally *t, struct archive *a)
{
    TRY(archive_integers(a, "tally.steps", &t->steps, 1));
    TRY(archive_integers(a, "tally.limited", t->limited, 3));
    TRY(archive_integers(a, "tally.rejected", &t->rejected, 1));
    TRY(archive_integers(a, "tally.doubted", t->doubted, INPUT_BODIES));
    TRY(archive_numbers(a, "tally.density", t->density, 2));
    TRY(archive_numbers(a, "tally.speed", &t->speed, 1));
    return archive_numbers(a, "tally.t", &t->t, 1);
}

/* Entries of a sheet have names of their own: `of' is the first letter. */
static int keep_sheet(struct book_sheet *s, char of, struct archive *a)
{
    const struct {
        const char *name;
        double *value;
        long n;
    } part[] = {
        { "t", &s->t, 1 },
        { "energy", (double *)&s->energy, sizeof s->energy / sizeof(double) },
        { "total", &s->total, 1 },
        { "work", s->work, BOOK_WORKS },
        { "pressure_defect", &s->pressure_defect, 1 },
        { "mass", &s->mass, 1 },
        { "momentum", s->momentum, DIM },
        { "momentum_given", s->momentum_given, DIM },
        { "defect", &s->defect, 1 },
    };
    char name[ARCHIVE_NAME];

    for (size_t i = 0; i < sizeof part / sizeof part[0]; i++) {
        snprintf(name, sizeof name, "sheet-%c.%s", of, part[i].name);
        TRY(archive_numbers(a, name, part[i].value, part[i].n));
    }
    snprintf(name, sizeof name, "sheet-%c.works", of);
    return archive_integer(a, name, &s->works);
}

/* The name of a solid is the plan's. */
static int keep_sunk(struct observe_sunk *s, const struct plan *plan, struct archive *a)
{
    const struct particles *all = plan_particles(plan);
    char solid[128] = "";

    if (!archive_fills(a) && s->solid)
        snprintf(solid, sizeof solid, "%s", s->solid);
    TRY(archive_integer(a, "sunk.n", &s->n));
    TRY(archive_numbers(a, "sunk.t", &s->t, 1));
    TRY(archive_integer(a, "sunk.particle", &s->particle));
    TRY(archive_text(a, "sunk.solid", solid, sizeof solid));
    for (int i = 0; archive_fills(a) && i < all->objects; i++)
        if (strcmp(all->object[i].name, solid) == 0)
            s->solid = all->object[i].name;
    return archive_text(a, "sunk.place", s->place, sizeof s->place);
}

static int keep_balance(struct run_balance *b, const struct plan *plan, struct archive *a)
{
    TRY(keep_sheet(&b->first, 'a', a));
    TRY(keep_sheet(&b->last, 'z', a));
    TRY(archive_flag(a, "balance.begun", &b->begun));
    TRY(archive_numbers(a, "balance.defect_max", &b->defect_max, 1));
    TRY(archive_numbers(a, "balance.made", &b->made, 1));
    TRY(archive_numbers(a, "balance.most", &b->most, 1));
    return keep_sunk(&b->sunk, plan, a);
}

/* They are the program's, for run.json: those of before an interruption, too. */
static int keep_warnings(struct archive *a)
{
    char name[ARCHIVE_NAME], text[STATUS_LINE];
    long n = 0;

    while (!archive_fills(a) && n < STATUS_WARNINGS && status_warning((int)n))
        n++;
    TRY(archive_integers(a, "warnings", &n, 1));
    for (int i = 0; i < n; i++) {
        snprintf(name, sizeof name, "warning-%d", i);
        snprintf(text, sizeof text, "%s", archive_fills(a) ? "" : status_warning(i));
        TRY(archive_text(a, name, text, sizeof text));
        if (archive_fills(a) && !archive_tries(a))
            status_recall(text);
    }
    return STATUS_DONE;
}

int run_past_keep(struct run_past *p, const struct plan *plan, struct archive *a)
{
    TRY(keep_tally(&p->tally, a));
    TRY(keep_warnings(a));
    TRY(keep_balance(&p->balance, plan, a));
    TRY(archive_numbers(a, "outputs.every", p->every, RUN_DUES));
    TRY(archive_integers(a, "outputs.due", p->due, RUN_DUES));
    TRY(archive_numbers(a, "outputs.slack", &p->slack, 1));
    TRY(archive_integers(a, "checkpoints.due", &p->checkpoints.due, 1));
    TRY(archive_integers(a, "checkpoints", &p->checkpoints.written, 1));
    TRY(archive_integers(a, "checkpoints.by_clock", &p->checkpoints.by_clock, 1));
    return archive_numbers(a, "spent", p->spent, 2);
}
