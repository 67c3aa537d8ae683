/* movie-frames.c -- particle files of a run as tables. */
#include "output/movie-frames.h"

#include "base/status.h"
#include "output/aside.h"
#include "output/movie-bodies.h"
#include "output/movie-set.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

/* What is drawn of the particles in a file. */
struct frame {
    hsize_t n;
    double (*x)[3], (*u)[3], *p; /* [n] position, velocity, pressure */
    unsigned char *kind;         /* [n] */
};

static void free_frame(struct frame *f)
{
    free(f->x);
    free(f->u);
    free(f->p);
    free(f->kind);
}

static bool read_frame(const char *path, struct frame *f)
{
    hid_t file;
    long long *count;

    *f = (struct frame){ 0 };
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file < 0)
        return false;
    count = movie_set(file, "/VTKHDF/NumberOfPoints", H5T_NATIVE_LLONG, 1, sizeof *count);
    f->n = count && *count > 0 ? (hsize_t)*count : 0;
    free(count);
    f->x = movie_set(file, "/VTKHDF/Points", H5T_NATIVE_DOUBLE, 3 * f->n, sizeof **f->x);
    f->u = movie_set(file, "/VTKHDF/PointData/velocity", H5T_NATIVE_DOUBLE, 3 * f->n,
                    sizeof **f->u);
    f->p = movie_set(file, "/VTKHDF/PointData/pressure", H5T_NATIVE_DOUBLE, f->n, sizeof *f->p);
    f->kind = movie_set(file, "/VTKHDF/PointData/kind", H5T_NATIVE_UCHAR, f->n, 1);
    H5Fclose(file);
    return f->x && f->u && f->p && f->kind;
}

static double speed_of(const double u[3])
{
    return sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
}

/* And to the list how many particles there are, and the largest speed of the fluid. */
static int write_frame(const char *from, const char *to, FILE *list)
{
    struct frame f;
    struct aside a;
    double fastest = 0;
    int status;

    if (!read_frame(from, &f)) {
        free_frame(&f);
        return status_fail(STATUS_IO, "%s: no particles can be read from this file", from);
    }
    status = aside_open(&a, to);
    for (hsize_t i = 0; status == STATUS_DONE && i < f.n; i++) {
        fprintf(a.to, "%.6g,%.6g,%.6g,%.4g,%.4g,%d\n", f.x[i][0], f.x[i][1], f.x[i][2],
                speed_of(f.u[i]), f.p[i], f.kind[i]);
        fastest = fmax(fastest, f.kind[i] == 0 ? speed_of(f.u[i]) : 0);
    }
    fprintf(list, ",%llu,%.6g\n", (unsigned long long)f.n, fastest);
    if (status == STATUS_DONE)
        status = aside_close(&a);
    free_frame(&f);
    return status;
}

/* Number i, of which the file is fields/FILE.vtkhdf and the time t. */
static int add(const struct movie_shot *shot, const char *run, const char *to, int i, double t,
               int file, FILE *list)
{
    char name[60], from[ASIDE_PATH], frame[ASIDE_PATH];

    if (shot->bodies) {
        snprintf(name, sizeof name, "fields/%06d-bodies.vtkhdf", file);
        TRY(aside_join(from, run, name));
        snprintf(name, sizeof name, "bodies-%04d.csv", i);
        TRY(aside_join(frame, to, name));
        TRY(movie_bodies(from, frame, shot->dim, shot->middle));
    }
    snprintf(name, sizeof name, "fields/%06d.vtkhdf", file);
    TRY(aside_join(from, run, name));
    snprintf(name, sizeof name, "frame-%04d.csv", i);
    TRY(aside_join(frame, to, name));
    fprintf(list, "%.9g,%s", t, name);
    return write_frame(from, frame, list);
}

/* Each file is named by many lines, and once behind its time. */
static int add_all(const struct movie_shot *shot, const char *run, const char *to, FILE *from,
                   FILE *list, int *n)
{
    char line[1000];
    double t = NAN;
    int file;

    while (fgets(line, sizeof line, from)) {
        const char *at = line;
        while (*at == ' ')
            at++;
        if (sscanf(at, "<Time Value=\"%lf\"", &t) == 1)
            continue;
        for (; *at && *at != '>'; at++)
            ;
        if (isnan(t) || sscanf(at, ">fields/%6d.vtkhdf", &file) != 1)
            continue;
        TRY(add(shot, run, to, (*n)++, t, file, list));
        t = NAN;
    }
    return STATUS_DONE;
}

int movie_frames(const struct movie_shot *shot, const char *run, const char *to, int *n)
{
    char path[ASIDE_PATH];
    struct aside list;
    FILE *from;
    int status;

    *n = 0;
    TRY(aside_join(path, run, "fields.xdmf"));
    from = fopen(path, "r");
    if (!from)
        return status_fail(STATUS_BAD_SCENE, "%s: no particle files of a run in there (%s cannot be "
                           "read)", run, path);
    status = aside_join(path, to, "frames.csv");
    if (status == STATUS_DONE)
        status = aside_open(&list, path);
    if (status == STATUS_DONE) {
        status = add_all(shot, run, to, from, list.to, n);
        if (status == STATUS_DONE)
            status = aside_close(&list);
        else
            aside_drop(&list);
    }
    fclose(from);
    return status;
}
