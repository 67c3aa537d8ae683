/* plan.c -- what a plan says of itself. */
#include "plan/inside.h"
#include "plan/solver.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

const char *plan_drifts(const struct plan *p)
{
    static char why[160];

    if (!p->drifter)
        return NULL;
    snprintf(why, sizeof why, "%.100s moves positions beside their velocities", p->drifter->path);
    return why;
}

const char *plan_halves(const struct plan *p)
{
    if (p->drifter)
        return plan_drifts(p);
    if (p->stiff)
        return "its viscosity is implicit (side = \"implicit\")";
    if (plan_ahead(p) > 0)
        return "its pressure looks ahead, by velocities and densities at once";
    return p->table.mixed ? "an effect of this scene adds to forces and to densities in one law"
                          : NULL;
}

long plan_size(const struct plan *p)
{
    return layout_size(&p->layout);
}

const struct layout *plan_layout(const struct plan *p)
{
    return &p->layout;
}

double plan_length(const struct plan *p)
{
    return p->scales.support;
}

bool plan_stiff(const struct plan *p)
{
    for (int i = 0; i < p->bodies; i++)
        if (plan_body_stiff(p, i))
            return true;
    return p->stiff != NULL;
}

const char *plan_viscous(const struct plan *p)
{
    return p->stiff ? p->stiff->path : NULL;
}

/* Of a body with an implicit side, whose rows are those that start with its path? */
static bool of_stiff_body(const struct plan *p, const struct layout_row *r)
{
    for (int i = 0; i < p->bodies; i++) {
        const size_t n = strlen(p->body[i].path);
        if (plan_body_stiff(p, i) && strncmp(r->name, p->body[i].path, n) == 0
            && r->name[n] == '.')
            return true;
    }
    return false;
}

static bool is_stiff(const struct plan *p, const struct layout *l, int row)
{
    return of_stiff_body(p, &l->row[row])
           || (p->stiff && (row == p->row.u || row == p->book.row));
}

int plan_stiff_ranges(const struct plan *p, const struct layout *l, int most, long (*range)[2])
{
    int n = 0;

    for (int i = 0; i < l->rows && n < most; i++) {
        const struct layout_row *r = &l->row[i];
        if (is_stiff(p, l, i)) {
            range[n][0] = r->offset;
            range[n++][1] = r->offset + (long)r->n * r->components;
        }
    }
    return n;
}

double plan_event(const struct plan *p, double t)
{
    double next = HUGE_VAL;

    for (int i = 0; i < p->bodies; i++)
        if (p->body[i].kind->watch && p->body[i].kind->watch->event)
            next = fmin(next, p->body[i].kind->watch->event(p->body[i].body, t));
    for (int i = 0; i < p->walls; i++)
        next = fmin(next, motion_event(&p->wall[i].motion, t));
    for (int i = 0; i < p->parts; i++)
        if (p->part[i].part->as.filter)
            next = fmin(next, p->part[i].part->as.filter->event(p->part[i].self, t));
    return next;
}

int plan_bodies(const struct plan *p)
{
    return p->bodies;
}

bool plan_body_rigid(const struct plan *p, int body)
{
    const struct body_watch *watch = p->body[body].kind->watch;

    return watch && watch->pose;
}

double plan_body_mass(const struct plan *p, int body)
{
    return p->body[body].kind->weight(p->body[body].body);
}

bool plan_body_tied(const struct plan *p, int body)
{
    return p->body[body].kind->watch->tied(p->body[body].body);
}

int plan_body_look(const struct plan *p, int body, struct surface *to)
{
    return p->body[body].kind->watch->look(p->body[body].body, to);
}

double plan_body_foresee(const struct plan *p, int body, const char **path)
{
    const struct body_watch *watch = p->body[body].kind->watch;

    *path = p->body[body].path;
    return watch && watch->foresee ? watch->foresee(p->body[body].body, &p->scales) : 0;
}

const char *plan_body_name(const struct plan *p, int body)
{
    return p->body[body].name;
}

const char *plan_object_group(const struct plan *p, int object)
{
    for (int i = 0; i < p->bodies; i++)
        if (p->body[i].object == object)
            return p->body[i].kind->identity.group;
    return p->particles->object[object].kind == KIND_FLUID ? "fluid" : "wall";
}

bool plan_body_stiff(const struct plan *p, int body)
{
    return p->body[body].kind->implicit != NULL;
}

const double *plan_impulse(const struct plan *p, const double *y, int object)
{
    return y + layout_at(&p->layout, p->book.row) + p->book.impulse + object * DIM;
}

void plan_pressures(const struct plan *p, int n, const double *rho, double *press)
{
    memset(press, 0, n * sizeof *press);
    if (p->pressure)
        p->pressure->part->as.pressure->pressures(p->pressure->self, n, rho, press);
}

const struct particles *plan_particles(const struct plan *p)
{
    return p->particles;
}

const struct scales *plan_scales(const struct plan *p)
{
    return &p->scales;
}

const struct settings *plan_settings(const struct plan *p)
{
    return &p->in.set;
}

const struct settings_output *plan_output(const struct plan *p)
{
    return &p->in.output;
}

int plan_probes(const struct plan *p)
{
    return p->in.probes;
}

const struct settings_probe *plan_probe(const struct plan *p, int i, const char **name)
{
    *name = p->in.probe[i].name;
    return &p->in.probe[i].set;
}

bool plan_profiles(const struct plan *p)
{
    for (int i = 0; i < p->in.probes; i++)
        if (p->in.probe[i].set.profile)
            return true;
    return false;
}

const char *plan_precision(const struct plan *p)
{
    return p->in.set.precision;
}

int plan_lanes(const struct plan *p)
{
    return p->engine->lanes;
}

int plan_parts(const struct plan *p)
{
    return p->parts;
}

const struct part *plan_part(const struct plan *p, int i, const char **path)
{
    *path = p->part[i].path;
    return p->part[i].part;
}

/* Methods that solve for a pressure once a step. */
static const struct plan_solved *const solved[] = { &solved_pcisph, &solved_mps, NULL };

const struct plan_solved *plan_solved(const char *method)
{
    for (int i = 0; solved[i]; i++) {
        const size_t n = strlen(solved[i]->name);
        if (strncmp(method, solved[i]->name, n) == 0 && (method[n] == '\0' || method[n] == '@'))
            return solved[i];
    }
    return NULL;
}
