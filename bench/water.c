/* water.c -- a box full of moving water. */
#include "water.h"

#include "base/status.h"
#include "scene/scene.h"
#include "tools.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *const effects =
    "effects = { continuity = { }; pressure = { }; artificial-viscosity = { alpha = 0.02; };"
    " density-diffusion = { delta = 0.1; }; };";

/* Gravity, domain and walls, or none of them. */
static void write_surroundings(FILE *f, const struct water_def *def)
{
    const char *zero = DIM == 2 ? "" : "0.0, ", *one = DIM == 2 ? "" : "1.0, ";
    const char *z = DIM == 2 ? "" : ", \"z\"";

    if (def->endless)
        fprintf(f, "domain = { from = [0.0, %s0.0]; to = [1.0, %s1.0];"
                " periodic = [\"x\", \"y\"%s]; };\n", zero, one, z);
    else if (def->alone)
        fprintf(f, "domain = { from = [-1.0, %s-1.0]; to = [2.0, %s2.0]; };\n", zero, one);
    else
        fprintf(f, "domain = { from = [0.0, %s0.0]; to = [1.0, %s1.0]; };\n"
                "wall = { tank = { type = \"frame\"; }; };\n", zero, one);
    if (def->endless || def->alone)
        fprintf(f, "gravity = [0.0, %s0.0]; eos = { c0 = 10.0; };\n", zero);
    else
        fprintf(f, "gravity = [0.0, %s-9.81];\n", zero);
}

static void write_scene(FILE *f, const struct water_def *def, double dx, double width)
{
    const char *y = DIM == 2 ? "" : "1.0, ";

    fprintf(f, "dimension = %d; until = 1.0; spacing = %.17g;\n"
            "fluid = { water = { type = \"box\"; from = [0.0, %s0.0];"
            " to = [%.17g, %s1.0]; }; };\n"
            "kernel = { support = %g; skin = %g; };\n%s\n%s\nprecision = \"%s\";\n", DIM, dx,
            DIM == 2 ? "" : "0.0, ", width, y, def->support, def->margin, effects,
            def->more ? def->more : "", def->single ? "single" : "double");
    write_surroundings(f, def);
}

static void read_plan(struct water *w, const struct water_def *def, double dx, double width)
{
    char path[] = P_tmpdir "/water-XXXXXX";
    const int file = mkstemp(path);
    FILE *f = file >= 0 ? fdopen(file, "w") : NULL;

    if (!f) {
        fprintf(stderr, "no scene can be written to " P_tmpdir "\n");
        exit(1);
    }
    write_scene(f, def, dx, width);
    fclose(f);
    bench_must(scene_read(path, &w->scene));
    bench_must(plan_create(w->scene, &w->plan));
    bench_must(moment_create(w->plan, &w->moment));
    unlink(path);
}

static uint64_t seed;

/* From -0.5 to 0.5: linear congruence with Knuth's constants. */
static double noise(void)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(seed >> 11) / (double)(UINT64_C(1) << 53) - 0.5;
}

static double *row(const struct water *w, double *y, const char *name)
{
    const struct layout *l = plan_layout(w->plan);

    for (int i = 0; i < l->rows; i++)
        if (strcmp(l->row[i].name, name) == 0)
            return y + l->row[i].offset;
    fprintf(stderr, "the layout has no row \"%s\"\n", name);
    exit(1);
}

/* Positions jittered, densities uneven, vortices of this wave number [1/m]. */
static void stir(struct water *w, double dx, double wave)
{
    double *x = row(w, w->y[0], "position of fluid"), *u = row(w, w->y[0], "velocity of fluid");
    double *rho = row(w, w->y[0], "density of fluid");

    seed = 1; /* the same water every time */
    for (int i = 0; i < w->fluid; i++, x += DIM, u += DIM) {
        for (int d = 0; d < DIM; d++)
            x[d] += 0.3 * dx * noise();
        rho[i] += 4 * noise();
        u[0] = sin(wave * x[0]) * cos(wave * x[DIM - 1]);
        u[DIM - 1] = -cos(wave * x[0]) * sin(wave * x[DIM - 1]);
    }
}

void water_make(struct water *w, const struct water_def *def)
{
    const double width = def->width > 0 ? def->width : 1;
    const double dx = 1 / round(pow(def->n / width, 1.0 / DIM));

    *w = (struct water){ 0 };
    read_plan(w, def, dx, width);
    w->size = plan_size(w->plan);
    w->fluid = particles_count(plan_particles(w->plan), KIND_FLUID);
    w->all = plan_particles(w->plan)->n;
    for (int k = 0; k < 2; k++)
        w->y[k] = bench_room((size_t)w->size * sizeof(double));
    w->ydot = bench_room((size_t)w->size * sizeof(double));
    plan_start(w->plan, w->y[0]);
    stir(w, dx, def->endless ? 2 * M_PI : M_PI);
    memcpy(w->y[1], w->y[0], (size_t)w->size * sizeof(double));
    const double *u = row(w, w->y[0], "velocity of fluid");
    double *x = row(w, w->y[1], "position of fluid");
    for (int i = 0; i < w->fluid * DIM; i++) /* the fastest have passed two margins */
        x[i] += 2.05 * def->margin * def->support * dx * u[i];
    water_rates(w);
}

void water_rates(void *water)
{
    struct water *w = water;

    w->due += w->share;
    if (w->due >= 1) {
        w->due -= 1;
        w->now = !w->now;
    }
    if (moment_eval(w->moment, ASK_EXPLICIT_SIDE, 0, w->y[w->now], w->ydot) != STATUS_DONE) {
        fprintf(stderr, "%s\n", moment_refusal(w->moment));
        exit(1);
    }
}

void water_free(struct water *w)
{
    for (int k = 0; k < 2; k++)
        free(w->y[k]);
    free(w->ydot);
    moment_free(&w->moment);
    plan_free(&w->plan);
    scene_free(&w->scene);
}
