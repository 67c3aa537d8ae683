/* disk.c -- what the files of a run will take, against what the disk has. */
#include "run/inside.h"

#include "base/status.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/statvfs.h>

/* Bytes of a value in a CSV, of a particle in each file of it, and of a file of fields beside them,
 * as the runs of data/scenes left them. */
static const double value = 14, row = 13 * 14.0, picture = 7.5 * (2 * DIM + 4), field = 64,
                    frame = 22e3;

static double times(double until, double every)
{
    return every > 0 ? floor(until / every) + 1 : 1;
}

/* Those are shown also where there are no particles. */
static bool any_rigid(const struct plan *plan)
{
    for (int i = 0; i < plan_bodies(plan); i++)
        if (plan_body_rigid(plan, i))
            return true;
    return false;
}

void run_disk(const struct run *r, struct run_disk *to)
{
    const struct settings_output *o = plan_output(r->plan);
    const double n = plan_particles(r->plan)->n, objects = plan_particles(r->plan)->objects;
    const double rows = times(r->until, isnan(o->interval) ? r->until / 500 : o->interval);
    const bool shown = n > 0 || any_rigid(r->plan);
    const double fields = shown ? times(r->until, isnan(o->fields) ? r->until / 50 : o->fields) : 0;
    const double pictures = shown ? o->snapshots : 0;

    *to = (struct run_disk){
        .rows = rows, .fields = fields, .pictures = pictures,
        .files = fields + pictures + 20,
        .bytes = rows * (2 * row + value * (2 * DIM * objects + 2 * plan_probes(r->plan)))
               + fields * (n * field + frame) + pictures * n * picture
               + (o->checkpoint > 0 || o->checkpoint_minutes > 0 ? 16.0 * plan_size(r->plan) : 0),
    };
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

int run_disk_agree(const struct run *r)
{
    const double there = free_bytes(r->directory);
    struct run_disk d;

    run_disk(r, &d);
    if (!(d.bytes > there))
        return STATUS_DONE;
    return status_fail(STATUS_BAD_SCENE, "%s: the files of this run would take about %.3g MB (%.0f "
                       "rows in tables, %.0f files of all particles, %.0f pictures), and the disk "
                       "has %.3g MB: take a larger output.interval or output.fields, fewer "
                       "output.snapshots, or another disk by -o", r->directory, d.bytes / 1e6,
                       d.rows, d.fields, d.pictures, there / 1e6);
}

void run_disk_print(const struct run *r)
{
    struct run_disk d;

    run_disk(r, &d);
    printf("output: about %.3g MB in %.0f files, steps.csv and figures aside; the disk has %.3g "
           "MB\n", d.bytes / 1e6, d.files, free_bytes(r->directory) / 1e6);
}
