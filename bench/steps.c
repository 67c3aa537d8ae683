/* steps.c -- what the time integration costs beside the right-hand side.
 *
 * Some steps of the real methods with the real plan (see water.h; the water
 * fills half of the box and, for an IMEX method, a beam stands in the other).
 * The linker sends all calls of moment_eval() through the clock below, so "outside"
 * is all else that a step does: sums of stages, error norm, stability bound,
 * controller, solves of the beam.  CPU time on one thread, in ns per particle
 * and explicit stage; the aim is what a prototype reached (NUMERICS.md Q5). */
#include "plan/engine.h"

#include "base/status.h"
#include "time/method.h"
#include "tools.h"
#include "water.h"

#include <stdlib.h>

enum { STEPS = 12, WARM = 4 };

static double inside; /* moment_eval() so far [s] */

int __real_moment_eval(struct moment *moment, struct ask ask, double t, const double *y,
                    double *ydot);
int __wrap_moment_eval(struct moment *moment, struct ask ask, double t, const double *y,
                    double *ydot);

int __wrap_moment_eval(struct moment *moment, struct ask ask, double t, const double *y,
                    double *ydot)
{
    const double start = bench_cpu();
    const int status = __real_moment_eval(moment, ask, t, y, ydot);

    inside += bench_cpu() - start;
    return status;
}

/* STEPS steps after WARM; the time in moment_eval(), the time in all, per stage [s]. */
static double time_steps(const struct method *m, void *self, struct moment *moment, double *all)
{
    struct method_step step;
    double start = 0;
    long stages = 0;

    for (int i = 0; i < WARM + STEPS; i++) {
        if (i == WARM) {
            inside = 0;
            stages = moment_counts(moment)->rhs_explicit;
            start = bench_cpu();
        }
        bench_must(m->step(self, 1, &step));
    }
    *all = bench_cpu() - start;
    stages = moment_counts(moment)->rhs_explicit - stages;
    *all /= (double)stages;
    return inside / (double)stages;
}

/* `aim` and `aim_share` [ns, %] stand beside what is measured. */
static void run(FILE *csv, const char *name, const char *beam, double aim, double aim_share)
{
    double outside[BENCH_REPEATS], share[BENCH_REPEATS];
    const struct method *m;
    struct method_def def = method_def_default();
    struct water w;
    void *self;

    def.tol = 1e-2; /* as in a scene that names none */
    water_make(&w, &(struct water_def){ .n = 50000, .support = 2.52, .margin = 0.05, .width = 0.5,
                                        .more = beam });
    bench_must(method_find(name, &def, &m));
    for (int r = 0; r < BENCH_REPEATS; r++) {
        double all = 0;
        bench_must(m->create(m, &def, w.moment, 0, w.y[0], &self));
        const double rates = time_steps(m, self, w.moment, &all);
        m->free(&self);
        outside[r] = 1e9 * (all - rates) / w.all;
        share[r] = 100 * (all - rates) / all;
    }
    const struct bench_times ns = bench_sort(outside, BENCH_REPEATS);
    const struct bench_times part = bench_sort(share, BENCH_REPEATS);
    printf("    %-8s %-16s %d particles: outside %5.1f ns per particle and stage (%.1f-%.1f; "
           "aim %g), %4.1f %% of all (aim %g %%)\n", name, beam ? "IMEX with a beam" : "explicit",
           w.all, ns.median, ns.least, ns.most, aim, part.median,
           aim_share);
    fprintf(csv, "%s,%d,%d,%g,%g,%g,%g,%g,%g\n", name, beam != NULL, w.all, ns.median, ns.least,
            ns.most, part.median, aim, aim_share);
    fflush(stdout);
    water_free(&w);
}

int main(int argc, char **argv)
{
    const char *beam = "beam = { plate = { at = [0.75, 0.0]; length = 0.2; thickness = 0.01;"
                       " E = 1e8; density = 1200.0; elements = 8; }; };";
    FILE *csv;

    (void)argc;
    bench_start(argv);
    bench_head("time integration outside of the right-hand side, 2D", engine_pick()->lanes);
    csv = bench_csv(argv[0], "method,beam,all,outside,least,most,share,aim,aim_share");
    run(csv, "ark436", NULL, 20, 13);
    run(csv, "cks43", NULL, 20, 13);
    run(csv, "imex3", beam, 45, 25);
    fclose(csv);
    return 0;
}
