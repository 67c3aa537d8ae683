/* movie.h -- a movie of a run's particle files. */
#ifndef OUTPUT_MOVIE_H
#define OUTPUT_MOVIE_H

/* Writes RUN/movie.webm, drawn by gnuplot with scripts/movie.gp and joined by ffmpeg, or, without
 * ffmpeg, RUN/movie.gif, by gnuplot alone, and prints its name. */
int movie_write(const char *run, const char *scripts);

#endif
