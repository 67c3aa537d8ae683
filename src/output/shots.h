/* shots.h -- what pictures of particles at several moments show: which moments, how large the
 * pictures are, and of the particles those that are seen, so that gnuplot draws a picture of a
 * million particles as fast as it reads what is in front.
 *
 *     TO/shots.gp         moments, and for each picture NAME_left, NAME_right, NAME_bottom,
 *                         NAME_above [m], NAME_across: panels in a row, NAME_pixel [m]
 *     TO/shots.csv        a row a moment: t, what is in RUN, without its end, and what scales are
 *                         made of
 *     TO/cut-1.csv ...    rows of the snapshot: in the plane, or in space of a cut in the middle
 *     TO/floor-1.csv ...  in space: rows of the snapshot, of what runs along the floor
 *     TO/floor-bodies-1.csv ...  in space: faces of bodies as seen from above, what is low first
 *     TO/view-1.csv ...   in space: all that is seen from the side and above, what is far first */
#ifndef OUTPUT_SHOTS_H
#define OUTPUT_SHOTS_H

/* Of RUN/snapshots.csv and TO/constants.gp, which are there. */
int shots_prepare(const char *run, const char *to);

#endif
