/* figures-constants.c -- the scene as gnuplot variables. */
#include "output/figures.h"

#include "base/status.h"
#include "output/aside.h"
#include <math.h>

static void constant(FILE *to, const char *name, double value)
{
    if (isfinite(value))
        fprintf(to, "%s = %.17g\n", name, value + 0.0);
    else
        fprintf(to, "%s = NaN\n", name);
}

static void constant_text(FILE *to, const char *name, const char *text)
{
    fprintf(to, "%s = '", name);
    for (; text && *text; text++)
        if (*text == '\'')
            fputs("''", to);
        else
            fputc((unsigned char)*text < 0x20 ? ' ' : *text, to);
    fputs("'\n", to);
}

static void constant_points(FILE *to, const char *side, const double *x, int dim)
{
    for (int d = 0; d < dim; d++) {
        char name[16];
        snprintf(name, sizeof name, "%s_%c", side, "xyz"[d]);
        constant(to, name, x[d]);
    }
}

int figures_constants(const char *run, const struct figures_constants *c)
{
    char path[ASIDE_PATH];
    struct aside a;

    TRY(aside_join(path, run, "figures"));
    TRY(aside_directory(path));
    TRY(aside_join(path, run, "figures/constants.gp"));
    TRY(aside_open(&a, path));
    fputs("# constants.gp -- the scene, for the scripts beside this file (SI units)\n", a.to);
    constant_text(a.to, "title", c->title);
    fprintf(a.to, "dim = %d\n", c->dim);
    constant(a.to, "a", c->a);
    constant(a.to, "n2", c->n2);
    constant(a.to, "g", c->g);
    constant(a.to, "until", c->until);
    constant_points(a.to, "low", c->low, c->dim);
    constant_points(a.to, "high", c->high, c->dim);
    constant(a.to, "beam_x", c->beam_x);
    constant(a.to, "dx", c->dx);
    constant(a.to, "rho0", c->rho0);
    constant(a.to, "c0", c->c0);
    constant(a.to, "E0", c->E0);
    constant_text(a.to, "beams", c->beams);
    constant_text(a.to, "sections", c->sections);
    return aside_close(&a);
}
