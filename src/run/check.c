/* check.c -- what a run would be and cost, without running it. */
#include "run/inside.h"

#include "base/status.h"
#include "implicit/release.h"
#include "plan/memory.h"
#include "plan/passes.h"
#include "ranks/ranks.h"
#include "run/check-look.h"
#include "run/check-ranks.h"
#include "run/looks.h"
#include "run/patience.h"
#include "run/ranks.h"
#include "run/tables.h"
#include "state/memory.h"
#include "state/part.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void print_parts(const struct run *r)
{
    const char *path;

    puts("parts:");
    for (int i = 0; i < plan_parts(r->plan); i++) {
        const struct part *part = plan_part(r->plan, i, &path);
        printf("  %-32s %s\n", path, part->about);
    }
    for (int i = 0; i < plan_bodies(r->plan); i++)
        printf("  body %-27s %s\n", plan_body_name(r->plan, i),
               plan_body_stiff(r->plan, i) ? "implicit" : "explicit");
}

static void print_pass(const struct plan_pass_show *p)
{
    const char *more = p->adds[0] ? "adds to " : "", *and = p->provides[0] && more[0] ? ", " : "";

    printf("  %-30s %-7s %s%s%s%s", p->name, p->over, p->provides, and, more, p->adds);
    if (p->neighbours[0])
        printf("; of neighbours: %s", p->neighbours);
    putchar('\n');
}

static void print_passes(const struct run *r)
{
    puts("passes of an evaluation:");
    for (int i = 0; i < plan_passes(r->plan); i++) {
        struct plan_pass_show pass;
        plan_pass_show(r->plan, i, &pass);
        print_pass(&pass);
    }
    puts("fields:");
    for (int i = 0; i < PASS_FIELDS; i++) {
        struct plan_pass_field f;
        if (plan_pass_field(r->plan, i, &f) && f.width > 0)
            printf("  %-32s %8d [%s]\n", f.name, f.width, f.unit);
    }
}

static void print_state(const struct run *r)
{
    const struct layout *l = plan_layout(r->plan);

    printf("state: %ld numbers\n", plan_size(r->plan));
    for (int i = 0; i < l->rows; i++)
        printf("  %-32s %8d x %d  [%s], error scale %g\n", l->row[i].name, l->row[i].n,
               l->row[i].components, l->row[i].unit, l->row[i].scale);
}

/* Density varies by about Mach squared: 1 % at Mach 0.1. */
static void print_mach(double speed, double c0)
{
    printf("speed to expect %.3g m/s, Mach %.2g%s\n", speed, speed / c0,
           speed > 0.15 * c0 ? ": the fluid will be noticeably compressible; take eos.c0 = 10 "
                               "times the largest speed"
                             : "");
}

static void print_particles(const struct run *r)
{
    const struct particles *all = plan_particles(r->plan);
    const struct scales *s = plan_scales(r->plan);

    printf("particles: %d\n", all->n);
    for (int i = 0; i < all->objects; i++)
        printf("  %-32s %8d\n", all->object[i].name, all->object[i].n);
    run_carved(r, stdout);
    if (s->fluid)
        printf("spacing %g m, support %g m, mass %g kg%s\n"
               "sound %g m/s, reference speed %g m/s\n", s->dx, s->support, s->mass,
               DIM == 2 ? " per metre" : "", s->c0, s->speed);
    if (s->fluid)
        print_mach(plan_speed_expected(r->plan), s->c0);
}

static void print_cost(const struct run *r, double seconds, const struct limit limit[2])
{
    for (int i = 0; i < 2; i++)
        if (limit[i].rate > 0)
            printf("fastest %s %g 1/s (%s)\n", i ? "decay" : "wave", limit[i].rate, limit[i].part);
    printf("method %s, tolerance %g\n", r->method->name, r->def.tol);
    if (limit[0].rate > 0) {
        run_cost_print(r->until, limit[0].rate, seconds);
        putchar('\n');
    }
}

/* What writing files takes in any case: code of HDF5, and the blocks it works in; and what large
 * pages of small arrays do, which ranks have not [bytes]. */
static const double later = 7.5e6, pages = 3e6, without_particles = 3.5e6, later_of_ranks = 4.5e6;

static void print_bytes(const char *what, double bytes)
{
    printf("  %-32s %8.1f MB\n", what, bytes / 1e6);
}

/* `program`: bytes that it holds before there is a scene. */
static void print_memory(const struct run *r, double program)
{
    const int n = plan_particles(r->plan)->n, vectors = r->method->room.vectors(r->method, r->plan);
    struct plan_memory m;
    char state[40];

    program += n > 0 ? later + pages : without_particles;
    plan_memory(r->plan, moment_pairs(r->moment), vectors, &m);
    printf("memory: about %.3g MB at its peak", (program + plan_memory_sum(&m)) / 1e6);
    if (n > 0)
        printf(", %.0f bytes a particle and %.3g MB of the program",
               plan_memory_sum(&m) / n, program / 1e6);
    putchar('\n');
    if (n == 0)
        return;
    snprintf(state, sizeof state, "state and %d vectors like it", vectors);
    print_bytes(state, m.state);
    print_bytes("pair lists", m.lists);
    print_bytes("sums over pairs", m.sums);
    print_bytes("particles as they were placed", m.particles);
    print_bytes("outputs", m.outputs);
    print_bytes("large pages that are not full",
                plan_memory_sum(&m) - m.state - m.lists - m.sums - m.particles - m.outputs);
}

static void say_title(const char *title)
{
    char plain[400];

    snprintf(plain, sizeof plain, "%s", title);
    printf("%s\n", status_plain(plain));
}

/* The pressure of a start that is released is a solve of hundreds of sums: no more than so
 * many particles wait for it, as the cost of a right-hand side does not depend on it. */
enum { RELEASED = 20000 };

static int start(struct run *r)
{
    if (plan_particles(r->plan)->n <= RELEASED)
        return run_let_go(r);
    plan_start(r->plan, r->y);
    return STATUS_DONE;
}

/* What can be said of a scene that is too large to be made for a look at it. */
static void print_survey(const struct run_order *order, const struct plan_survey *s, double program)
{
    say_title(s->title);
    printf("particles: about %.3g, counted by their shapes\n", s->fluid + s->solid);
    for (int i = 0; i < s->objects; i++)
        printf("  %-32s %8.3g\n", s->object[i].name, s->object[i].n);
    printf("spacing %g m, support %g m, mass %g kg%s\nsound %g m/s, reference speed %g m/s\n",
           s->dx, s->support, s->mass, DIM == 2 ? " per metre" : "", s->c0, s->speed);
    printf("memory: about %.3g MB at its peak\n", (program + later + pages + s->bytes) / 1e6);
    run_sample_print(order, s);
    puts("This scene is too large for a look at all its particles, which a check makes of up to 1.5 "
         "million\nin a few seconds and 1 GB: whether they overlap, and what a right-hand side refuses, is "
         "not known.\nCheck it with a larger spacing, too.");
}

/* A scene whose particles can be made.  Limits are found by a list of their own, which may take as much as
 * all else. */
static int check(struct run *r, const struct run_order *order, double program)
{
    struct limit limit[2];
    double seconds = 0;
    int status = run_doubt_scene(r);

    if (status == STATUS_DONE)
        status = run_disk_agree(r);
    if (status == STATUS_DONE)
        status = tables_agree(r->plan);
    status = ranks_agree(status);
    if (status == STATUS_DONE)
        status = start(r);
    if (status == STATUS_DONE)
        status = moment_share(r->moment, r->y, run_ranks_rows(r));
    run_ranks_begin(r);
    if (status == STATUS_DONE)
        status = run_time_rhs(r, &seconds);
    if (status == STATUS_DONE)
        moment_limit(r->moment, 0, r->y, false, limit);
    patience_done();
    if (status != STATUS_DONE)
        return status;
    say_title(plan_settings(r->plan)->title);
    print_particles(r);
    print_parts(r);
    print_passes(r);
    print_state(r);
    print_cost(r, seconds, limit);
    if (ranks_count() > 1)
        TRY(check_ranks_print(r, program, later_of_ranks));
    else
        print_memory(r, program);
    TRY(run_disk_print(r, plan_particles(r->plan)->n, looks_grain(r->plan)));
    if (ranks_count() == 1)
        run_shares_print(r, order, seconds);
    return status;
}

/* The look has given all warnings there are. */
int check_count(const struct run_order *order, double program)
{
    struct run r;
    struct plan_survey survey;
    int status;

    status_hush(true);
    status = run_prepare_count(&r, order, &survey);
    status_hush(false);
    patience_done();
    if (status == STATUS_DONE)
        print_survey(order, &survey, program);
    plan_survey_free(&survey);
    run_release(&r);
    return status;
}

int check_look(const struct run_order *order, double program)
{
    struct run r;
    struct plan_survey survey;
    int status = run_prepare_small(&r, order, &survey);

    if (survey.large || status != STATUS_DONE)
        patience_done();
    if (survey.large)
        print_survey(order, &survey, program);
    else if (status == STATUS_DONE)
        status = check(&r, order, program);
    plan_survey_free(&survey);
    run_release(&r);
    return status;
}
