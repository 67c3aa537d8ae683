/* tabulate-json.c -- compare.json: against what, and when, errors were taken. */
#include "study/tabulate.h"

#include "base/status.h"
#include "output/json.h"
#include "study/error.h"
#include "study/growth.h"
#include "study/trial.h"

#include <math.h>

#ifndef PACKAGE_VERSION
#define PACKAGE_VERSION "unknown"
#endif

/* RMS distance of particles in picture i of both runs [m]. */
static double apart(const struct study *s, const struct point *p, int i)
{
    char name[64], path[MEMBER_PATH];
    struct table a, b;
    double d = NAN;

    snprintf(name, sizeof name, "snapshots/%04d.csv", i);
    trial_path(s, p->reference, name, path);
    table_read(&a, path);
    trial_path(s, p->disturbed, name, path);
    table_read(&b, path);
    if (a.name && b.name)
        d = error_positions(&a, &b);
    table_free(&a);
    table_free(&b);
    return d;
}

static void write_growth(struct json *j, const struct study *s, const struct point *p)
{
    const int n = p->pieces * p->fine;
    double t[1024], d[1024];
    struct growth growth;

    for (int i = 0; i < n; i++) {
        t[i] = p->facts.until * (i + 1) / n;
        d[i] = apart(s, p, i + 1);
    }
    growth_fit(&growth, n, t, d, TRIAL_DISTURBANCE, facts_gravity(&p->facts), p->facts.dx);
    json_number(j, "growth_rate", growth.rate);
    json_number(j, "positions_until", growth.until);
}

static void write_reference(struct json *j, const struct study *s, const struct point *p)
{
    const struct trial *t = p->reference;

    json_text(j, "reference_status", t->run.ended ? member_status(&t->run) : "missing");
    json_text(j, "reference_message", t->run.message);
    json_number(j, "reference_cpu_s", t->run.ended ? t->result.cpu : NAN);
    json_number(j, "reference_steps", t->run.ended ? t->result.steps : NAN);
    if (p->disturbed && p->disturbed->run.ended)
        write_growth(j, s, p);
}

static void write_point(struct json *j, const struct study *s, const struct point *p)
{
    json_object(j, *p->label ? p->label : "scene");
    json_number(j, "until", p->facts.until);
    json_number(j, "early", p->facts.until / p->pieces);
    json_number(j, "spacing", p->facts.dx);
    if (p->reference)
        write_reference(j, s, p);
    json_end(j);
}

int tabulate_json(const struct study *s)
{
    char path[MEMBER_PATH];
    struct json *j;

    TRY(aside_join(path, s->home.directory, "compare.json"));
    TRY(json_open(&j, path));
    json_text(j, "scene", s->order->scene);
    json_text(j, "version", PACKAGE_VERSION);
    json_text(j, "reference_method", s->finest ? "finest" : s->reference_method);
    if (!s->finest)
        json_text(j, "reference_tol", s->reference[0].tol);
    json_integer(j, "repeat", s->order->repeat > 1 ? s->order->repeat : 1);
    json_number(j, "budget_s", s->order->budget > 0 ? s->order->budget : NAN);
    json_object(j, "points");
    for (int i = 0; i < s->points; i++)
        write_point(j, s, &s->point[i]);
    json_end(j);
    return json_close(&j);
}
