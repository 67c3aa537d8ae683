/* movie-bodies.h -- rigid bodies in particle files of a run as tables. */
#ifndef OUTPUT_MOVIE_BODIES_H
#define OUTPUT_MOVIE_BODIES_H

/* From a file fields/000012-bodies.vtkhdf to rows x,y,z,body, outlines with a blank line behind each,
 * below three lines of head (looks-file.h): in the plane of the bodies, in space of where y = `middle`
 * [m] cuts them. */
int movie_bodies(const char *from, const char *to, int dim, double middle);

#endif
