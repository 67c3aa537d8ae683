/* trial.c -- one run of a comparison: what it sets, how far it is from its reference. */
#include "study/trial.h"

#include "base/status.h"
#include "study/point.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

void trial_path(const struct study *s, const struct trial *t, const char *file, char *to)
{
    member_path(&s->home, &t->run, file, to);
}

/* Pictures until the time at which positions are compared. */
static int pictures(const struct trial *t)
{
    return t->disturbed || t == t->point->reference ? t->point->fine : 1;
}

/* Gravity tilted towards the axis along which it is least.  More of it would not do: with a
 * sound speed of sqrt(gH) that only makes the same flow faster. */
static void write_tilt(FILE *to, const struct facts *p)
{
    const double *g = p->gravity;
    int least = 0;

    for (int d = 1; d < p->dimension; d++)
        if (fabs(g[d]) < fabs(g[least]))
            least = d;
    fprintf(to, "gravity=[");
    for (int d = 0; d < p->dimension; d++)
        fprintf(to, "%s%.17g", d ? "," : "",
                g[d] + (d == least ? TRIAL_DISTURBANCE * facts_gravity(p) : 0));
    fprintf(to, "]\n");
}

/* A setting of the scene, one a line; what a reference is must be the same in each of them. */
static void write_settings(FILE *to, const struct study *s, const struct trial *t)
{
    const struct point *p = t->point;

    char *swept = point_settings(s, p);

    fputs(swept ? swept : "", to);
    free(swept);
    fprintf(to, "method=%s\n", t->method);
    if (*t->tol)
        fprintf(to, "tol=%s\n", t->tol);
    fprintf(to, "output.snapshots=%d\n", p->pieces * pictures(t) + 1);
    fprintf(to, "output.fields=%.17g\n", p->facts.until);
    if (t->disturbed)
        write_tilt(to, &p->facts);
}

char *trial_settings(const struct study *s, const struct trial *t)
{
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);

    if (!to)
        return NULL;
    write_settings(to, s, t);
    fclose(to);
    return text;
}

void trial_read(const struct study *s, struct trial *t)
{
    const struct trial *reference = t->reference;
    char dir[MEMBER_PATH], there[MEMBER_PATH];

    trial_path(s, t, "", dir);
    result_read(&t->result, dir);
    if (!reference || reference == t || !reference->run.ended
        || reference->run.code != STATUS_DONE)
        return;
    trial_path(s, reference, "", there);
    result_compare(&t->result, dir, pictures(t), there, pictures(reference), t->point->facts.dx);
}
