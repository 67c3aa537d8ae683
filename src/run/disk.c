/* disk.c -- what the files of a run will take, against what the disk has. */
#include "run/inside.h"

#include "base/status.h"
#include "run/looks.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/statvfs.h>

/* Bytes of a value in a CSV, of a particle in each file of it, and of a file of fields beside them,
 * as the runs of data/scenes left them. */
static const double value = 14, row = 13 * 14.0, picture = 7.5 * (2 * DIM + 4), field = 64,
                    frame = 22e3;

/* Of a point on the surface of a rigid body, or a particle beside it, in a file for pictures with
 * depth; of a corner of a face, in files for pictures and for viewers. */
static const double point = 46, corner = 11.0 * DIM * (DIM - 1), corner_field = 100;

/* How much is written: of tables; files of all particles for viewers, for pictures. */
struct amount {
    double rows, fields, pictures;
    double files, bytes; /* but for steps.csv and figures */
};

static double times(double until, double every)
{
    return every > 0 ? floor(until / every) + 1 : 1;
}

/* What rigid bodies add to each moment, if there are any: NUMBER-bodies.vtkhdf; NUMBER-bodies.csv
 * and, in 3D, NUMBER-surface.csv with all particles and NUMBER-cut.csv.  Points on surfaces stand
 * 0.3 dx apart on triangles, 1.5 for each square of that side. */
static void add_bodies(struct amount *to, const struct looks *looks, double n, double dx)
{
    const struct cloud_looks *l = looks_known(looks);
    const double corners = l->first[l->faces];

    to->files += to->fields + to->pictures * (DIM == 2 ? 1 : 3);
    to->bytes += to->fields * (frame + corners * corner_field) + to->pictures * corners * corner;
    if (DIM == 3)
        to->bytes += to->pictures * point * (n + 1.5 * looks_area(looks) / pow(0.3 * dx, 2));
}

/* Of the run with n particles in a lattice of spacing dx [m]. */
static int estimate(const struct run *r, double n, double dx, struct amount *to)
{
    const struct settings_output *o = plan_output(r->plan);
    const struct particles *all = plan_particles(r->plan);
    const double rows = times(r->until, isnan(o->interval) ? r->until / 500 : o->interval);
    const double state = all->n > 0 ? plan_size(r->plan) * n / all->n : plan_size(r->plan);
    struct looks *looks;
    bool shown;

    TRY(looks_open(&looks, r->plan));
    shown = n > 0 || looks;
    *to = (struct amount){
        .rows = rows,
        .fields = shown ? times(r->until, isnan(o->fields) ? r->until / 50 : o->fields) : 0,
        .pictures = shown ? o->snapshots : 0,
        .bytes = rows * (2 * row + value * (2 * DIM * all->objects + 2 * plan_probes(r->plan)))
               + (o->checkpoint > 0 || o->checkpoint_minutes > 0 ? 16 * state : 0),
    };
    to->files = to->fields + to->pictures + 20;
    to->bytes += n * (to->fields * field + to->pictures * picture) + to->fields * frame;
    if (looks)
        add_bodies(to, looks, n, dx);
    looks_close(&looks);
    return STATUS_DONE;
}

/* Bytes that we may still write where the directory is or will be, NAN: it cannot be told. */
static double free_bytes(const char *directory)
{
    char path[RUN_PATH];
    struct statvfs disk;

    snprintf(path, sizeof path, "%s", directory);
    while (statvfs(path, &disk) != 0) {
        char *slash = strrchr(path, '/');
        if (strcmp(path, ".") == 0)
            return NAN;
        if (!slash)
            strcpy(path, ".");
        else if (slash == path)
            strcpy(path, "/.");
        else
            *slash = '\0';
    }
    return disk.f_blocks > 0 ? (double)disk.f_bavail * (double)disk.f_frsize : NAN; /* /proc */
}

static int agree(const struct run *r, const struct amount *d, double there)
{
    if (!(d->bytes > there))
        return STATUS_DONE;
    return status_fail(STATUS_BAD_SCENE, "%s: the files of this run would take about %.3g MB (%.0f "
                       "rows in tables, %.0f files of all particles, %.0f pictures), and the disk "
                       "has %.3g MB: take a larger output.interval or output.fields, fewer "
                       "output.snapshots, or another disk by -o", r->directory, d->bytes / 1e6,
                       d->rows, d->fields, d->pictures, there / 1e6);
}

int run_disk_agree(const struct run *r)
{
    struct amount d;

    TRY(estimate(r, plan_particles(r->plan)->n, looks_grain(r->plan), &d));
    return agree(r, &d, free_bytes(r->directory));
}

int run_disk_print(const struct run *r, double n, double dx)
{
    const double there = free_bytes(r->directory);
    struct amount d;

    TRY(estimate(r, n, dx, &d));
    printf("output: about %.3g MB in %.0f files, steps.csv and figures aside; the disk has %.3g "
           "MB\n", d.bytes / 1e6, d.files, there / 1e6);
    return STATUS_DONE;
}
