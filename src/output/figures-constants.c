/* figures-constants.c -- the scene as gnuplot variables. */
#include "output/figures.h"

#include "base/status.h"
#include "output/aside.h"
#include "output/figures-data.h"

static void constant_points(FILE *to, const char *side, const double *x, int dim)
{
    for (int d = 0; d < dim; d++) {
        char name[16];
        snprintf(name, sizeof name, "%s_%c", side, "xyz"[d]);
        figures_data_number(to, name, x[d]);
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
    figures_data_text(a.to, "title", c->title);
    fprintf(a.to, "dim = %d\n", c->dim);
    figures_data_number(a.to, "a", c->a);
    figures_data_number(a.to, "n2", c->n2);
    figures_data_number(a.to, "g", c->g);
    figures_data_number(a.to, "until", c->until);
    constant_points(a.to, "low", c->low, c->dim);
    constant_points(a.to, "high", c->high, c->dim);
    fprintf(a.to, "falls = %d\n", c->column);
    fprintf(a.to, "rings = %d\n", c->rings);
    fprintf(a.to, "walls_move = %d\n", c->moves);
    figures_data_number(a.to, "beam_x", c->beam_x);
    figures_data_number(a.to, "dx", c->dx);
    figures_data_number(a.to, "rho0", c->rho0);
    figures_data_number(a.to, "c0", c->c0);
    figures_data_number(a.to, "E0", c->E0);
    figures_data_text(a.to, "beams", c->beams);
    figures_data_text(a.to, "sections", c->sections);
    figures_data_text(a.to, "bodies", c->bodies);
    figures_data_text(a.to, "masses", c->masses);
    return aside_close(&a);
}
