/* prepare.c -- from a path to a plan with a method; nothing is written. */
#include "run/inside.h"

#include "base/status.h"
#include "run/ranks.h"
#include "scene/scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>
#ifdef _OPENMP
#include <omp.h>
#endif

double run_clock(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec + 1e-9 * now.tv_nsec;
}

double run_cpu(void)
{
    struct rusage u;

    getrusage(RUSAGE_SELF, &u);
    return u.ru_utime.tv_sec + u.ru_stime.tv_sec
         + 1e-6 * (u.ru_utime.tv_usec + u.ru_stime.tv_usec);
}

enum { SERVING = 4 }; /* methods that a refusal offers */

/* "path/dam-break.scene" becomes "dam-break". */
static int choose_directory(struct run *r, const struct run_order *order)
{
    const char *slash = strrchr(order->scene, '/');
    const char *from = order->directory ? order->directory : slash ? slash + 1 : order->scene;
    char *dot;

    if (strlen(from) >= sizeof r->directory - 8)
        return status_fail(STATUS_IO, "%.200s...: this output directory has %zu letters, more than "
                           "%zu; choose one nearer to the root", from, strlen(from),
                           sizeof r->directory - 8);
    snprintf(r->directory, sizeof r->directory, "%s", from);
    if (order->directory)
        return STATUS_DONE;
    dot = strrchr(r->directory, '.');
    if (dot && dot > r->directory && strcmp(dot, ".scene") == 0)
        *dot = '\0';
    else
        strcat(r->directory, ".run");
    return STATUS_DONE;
}

/* The time room knows the names, the scene where one was written. */
static int refuse_method(const struct run *r)
{
    const struct scene_node *node = scene_child(scene_root(r->scene), "method");
    char why[512];

    snprintf(why, sizeof why, "%s", status_message());
    status_clear();
    return status_fail(STATUS_BAD_SCENE, "%s: %s", node ? scene_where(node) : "default", why);
}

/* What the scene takes by itself, when that serves, and the first methods of the table that do. */
static void list_serving(const struct run *r, char *to, size_t room)
{
    const char *usual = method_default(r->plan);
    size_t n = 0;
    int found = 0;

    *to = '\0';
    for (int others = 0; others < 2; others++)
        for (int i = 0; method_table[i] && found < SERVING && n < room; i++)
            if (others == (strcmp(method_table[i]->name, usual) != 0)
                && (!method_table[i]->serves || !method_table[i]->serves(r->plan)))
                n += (size_t)snprintf(to + n, room - n, "%s%s", found++ > 0 ? ", " : "",
                                      method_table[i]->name);
}

static int refuse_scene(const struct run *r, const char *name, const char *reason)
{
    const struct scene_node *node = scene_child(scene_root(r->scene), "method");
    char serving[160];

    list_serving(r, serving, sizeof serving);
    return status_fail(STATUS_BAD_SCENE, "%s: method %s cannot serve this scene: %s; %s%s",
                       node ? scene_where(node) : scene_path(r->scene), name, reason,
                       *serving ? "methods that do: " : "no method does", serving);
}

static int find_method(struct run *r)
{
    const struct settings *s = plan_settings(r->plan);
    const char *name = s->method[0] ? s->method : method_default(r->plan);
    const char *reason;

    r->def = method_def_default();
    r->def.tol = s->tol;
    r->def.norm = vector_norm_of(s->norm);
    r->def.substep = isnan(s->substep) ? 0 : s->substep;
    if (method_find(name, &r->def, &r->method) != STATUS_DONE)
        return refuse_method(r);
    reason = r->method->serves ? r->method->serves(r->plan) : NULL;
    if (reason)
        return refuse_scene(r, name, reason);
    if (!s->method[0])
        scene_computed_word(r->scene, "", "method", name);
    return STATUS_DONE;
}

static void compute_defaults(struct run *r)
{
    const struct settings_output *o = plan_output(r->plan);

    r->until = plan_settings(r->plan)->until;
    if (isnan(o->interval))
        scene_computed(r->scene, "output", "interval", r->until / 500);
    if (isnan(o->fields))
        scene_computed(r->scene, "output", "fields", r->until / 50);
    if (isnan(o->profiles))
        scene_computed(r->scene, "output", "profiles", r->until / 50);
}

static int read_scene(struct run *r, const struct run_order *order)
{
    *r = (struct run){ .clock_start = run_clock(), .cpu_start = run_cpu(),
                       .force = order->force };
#ifdef _OPENMP
    if (order->threads > 0)
        omp_set_num_threads(order->threads);
#endif
    TRY(choose_directory(r, order));
    TRY(scene_read(order->scene, &r->scene));
    snprintf(r->path, sizeof r->path, "%s", scene_path(r->scene));
    for (int i = 0; i < order->overrides; i++)
        TRY(scene_override(r->scene, order->override[i]));
    return STATUS_DONE;
}

/* With the plan that there is. */
static int prepare(struct run *r)
{
    TRY(moment_create(r->plan, &r->moment));
    TRY(find_method(r));
    compute_defaults(r);
    r->past.tally.density[0] = HUGE_VAL;
    r->clock_kept = r->clock_start;
    r->y = status_alloc(plan_size(r->plan), sizeof *r->y);
    return r->y && !status_is_starved() ? STATUS_DONE : STATUS_FAILED;
}

int run_prepare(struct run *r, const struct run_order *order)
{
    TRY(read_scene(r, order));
    TRY(plan_create(r->scene, &r->plan));
    return prepare(r);
}

int run_prepare_together(struct run *r, const struct run_order *order)
{
    TRY(run_ranks_same(r, read_scene(r, order)));
    TRY(plan_create_together(r->scene, &r->plan));
    return prepare(r);
}

int run_prepare_small(struct run *r, const struct run_order *order, struct plan_survey *survey)
{
    *survey = (struct plan_survey){ 0 };
    TRY(run_ranks_same(r, read_scene(r, order)));
    TRY(plan_survey_create(r->scene, survey, &r->plan));
    return survey->large ? STATUS_DONE : prepare(r);
}

int run_prepare_count(struct run *r, const struct run_order *order, struct plan_survey *survey)
{
    *survey = (struct plan_survey){ 0 };
    TRY(read_scene(r, order));
    return plan_survey_count(r->scene, survey);
}

void run_release(struct run *r)
{
    if (r->self)
        r->method->free(&r->self);
    outputs_close(&r->outputs);
    running_free(&r->past.means);
    moment_free(&r->moment);
    plan_free(&r->plan);
    scene_free(&r->scene);
    free(r->y);
    r->y = NULL;
}

int run_carved(const struct run *r, FILE *to)
{
    const struct particles *all = plan_particles(r->plan);
    int sum = 0;

    for (int i = 0; i < all->objects; i++) {
        const struct object *o = &all->object[i];
        sum += o->carved;
        if (o->carved > 0 && to)
            fprintf(to, "fluid.%s makes room: %d of its %d sites are left to solids, most of them "
                    "to %s.%s\n", o->name, o->carved, o->carved + o->n,
                    plan_object_group(r->plan, o->carver), all->object[o->carver].name);
    }
    return sum;
}
