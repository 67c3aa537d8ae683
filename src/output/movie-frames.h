/* movie-frames.h -- particle files of a run as tables that gnuplot reads. */
#ifndef OUTPUT_MOVIE_FRAMES_H
#define OUTPUT_MOVIE_FRAMES_H

/* Writes TO/frame-0000.csv and on, rows x,y,z,speed,pressure,kind of each particle (SI), for each of
 * the files that RUN/fields.xdmf names, and TO/frames.csv with times and names.  *n: how many. */
int movie_frames(const char *run, const char *to, int *n);

#endif
