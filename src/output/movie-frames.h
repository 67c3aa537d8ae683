/* movie-frames.h -- particle files of a run as tables that gnuplot reads. */
#ifndef OUTPUT_MOVIE_FRAMES_H
#define OUTPUT_MOVIE_FRAMES_H

#include <stdbool.h>

struct movie_shot {
    bool bodies;   /* are there rigid bodies in the files?                         */
    int dim;
    double middle; /* 3D: where the tank is cut, y [m]                             */
};

/* Writes TO/frame-0000.csv and on, rows x,y,z,speed,pressure,kind of each particle (SI), for each of
 * the files that RUN/fields.xdmf names, and TO/frames.csv with times, names, numbers of particles and
 * the largest speed of the fluid [m/s]; with bodies TO/bodies-0000.csv and on, movie-bodies.h.  *n: how many. */
int movie_frames(const struct movie_shot *shot, const char *run, const char *to, int *n);

#endif
