/* tank.c -- a small tank of water for tests. */
#include "tank.h"

#include "base/status.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#if DIM == 2
#define BARE                                                                             \
    "dimension = 2; until = 1.0; spacing = 5e-3; gravity = [0.0, -9.81];"                \
    "domain = { from = [0.0, 0.0]; to = [0.1, 0.08]; };"                                 \
    "fluid = { water = { type = \"box\"; from = [0.0, 0.0]; to = [0.1, 0.06]; }; };"
const char *const tank_water = BARE;
#else
#define BARE                                                                             \
    "dimension = 3; until = 1.0; spacing = 2e-2; gravity = [0.0, 0.0, -9.81];"           \
    "domain = { from = [0.0, 0.0, 0.0]; to = [0.1, 0.1, 0.16]; };"                       \
    "fluid = { water = { type = \"box\"; from = [0.0, 0.0, 0.0]; to = [0.1, 0.1, 0.12]; }; };"
const char *const tank_water = BARE "kernel = { support = 2.5; };";
#endif
const char *const tank_bare_water = BARE;
const char *const tank_frame = "wall = { tank = { type = \"frame\"; }; };";
const char *const tank_parted_water =
    "dimension = 2; until = 1.0; spacing = 5e-3; gravity = [0.0, -9.81];"
    "domain = { from = [0.0, 0.0]; to = [0.1, 0.08]; };"
    "fluid = { left = { type = \"box\"; from = [0.0, 0.0]; to = [0.06, 0.06]; };"
    "          right = { type = \"box\"; from = [0.075, 0.0]; to = [0.1, 0.03]; }; };";
const char *const tank_beam =
    "beam = { plate = { at = [0.0675, 0.0]; length = 0.05; thickness = 4e-3; E = 1e7;"
    "  density = 1200.0; elements = 4; layers = 3; alpha = 3.0; beta = 1e-4;"
    "  tip_force = 2.0; }; };";

static int make(struct tank *t, const char *path)
{
    TRY(scene_read(path, &t->scene));
    TRY(plan_create(t->scene, &t->plan));
    TRY(moment_create(t->plan, &t->moment));
    t->n = plan_size(t->plan);
    t->y = test_calloc(t->n + 1, sizeof *t->y);
    t->ydot = test_calloc(t->n + 1, sizeof *t->ydot);
    plan_start(t->plan, t->y);
    return STATUS_DONE;
}

int tank_try(struct tank *t, const char *text)
{
    char path[] = P_tmpdir "/tank-XXXXXX";
    const int file = mkstemp(path);
    int status;

    *t = (struct tank){0};
    assert_true(file >= 0);
    assert_int_equal(write(file, text, strlen(text)), strlen(text));
    close(file);
    status_clear();
    status = make(t, path);
    unlink(path);
    return status;
}

void tank_make(struct tank *t, const char *first, ...)
{
    char text[65536] = "";
    va_list args;

    va_start(args, first);
    for (const char *s = first; s; s = va_arg(args, const char *))
        strncat(text, s, sizeof text - strlen(text) - 1);
    va_end(args);
    if (tank_try(t, text) != STATUS_DONE)
        fail_msg("no plan: %s", status_message());
}

void tank_free(struct tank *t)
{
    test_free(t->y);
    test_free(t->ydot);
    moment_free(&t->moment);
    plan_free(&t->plan);
    scene_free(&t->scene);
}

double tank_random(unsigned *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (*seed >> 8) / 8388608.0 - 1;
}

long tank_at(const struct tank *t, const char *name, const struct layout_row **row)
{
    const struct layout *l = plan_layout(t->plan);

    for (int i = 0; i < l->rows; i++)
        if (strcmp(l->row[i].name, name) == 0) {
            if (row)
                *row = &l->row[i];
            return l->row[i].offset;
        }
    fail_msg("the layout has no row \"%s\"", name);
    return -1;
}

/* By how much a row is shaken. */
static double reach(const struct layout_row *r, double far, double fast, double dense,
                    const struct scales *s)
{
    if (strncmp(r->name, "density", 7) == 0)
        return dense * s->rho0;
    if (strncmp(r->name, "position", 8) == 0)
        return far * s->dx;
    if (strncmp(r->name, "velocity", 8) == 0)
        return fast;
    if (strstr(r->name, "theta_rate"))
        return fast / 0.05;
    if (strstr(r->name, "w_rate"))
        return fast;
    if (strstr(r->name, "theta"))
        return far * s->dx / 0.05;
    return strcmp(r->name, "book") == 0 ? 0 : far * s->dx; /* w */
}

void tank_shake(struct tank *t, unsigned seed, double far, double fast, double dense)
{
    const struct layout *l = plan_layout(t->plan);

    for (int i = 0; i < l->rows; i++) {
        const struct layout_row *r = &l->row[i];
        const double most = reach(r, far, fast, dense, plan_scales(t->plan));
        const bool held = strstr(r->name, "beam."); /* the root stays where it is */
        for (long k = held ? r->components : 0; k < (long)r->n * r->components; k++)
            t->y[r->offset + k] += most * tank_random(&seed);
    }
}

void tank_rates(struct tank *t, double time, const double *y, double *ydot)
{
    for (long i = 0; i < t->n; i++)
        ydot[i] = NAN; /* all of it has to be written */
    if (moment_eval(t->moment, ASK_ALL, time, y, ydot) != STATUS_DONE)
        fail_msg("refused: %s", moment_refusal(t->moment));
}

double *tank_copy(const struct tank *t, const double *y)
{
    double *copy = test_malloc(t->n * sizeof *copy);

    memcpy(copy, y, t->n * sizeof *copy);
    return copy;
}
