/* shots-inside.h -- what the files that prepare pictures share. */
#ifndef OUTPUT_SHOTS_INSIDE_H
#define OUTPUT_SHOTS_INSIDE_H

#include "output/aside.h"
#include "output/canvas.h"
#include "output/shot.h"
#include <stdbool.h>

enum { SHOTS_MOST = 6 };

struct shots_moment {
    double t;
    char name[64]; /* snapshots/0003 */
};

/* The scene, as constants.gp has it. */
struct shots_scene {
    const char *run, *to;
    int dim, moments;
    bool moves;                /* some wall does */
    double dx, low[3], high[3];
    double down[3], up[3];     /* how far the tank itself goes along each axis, and back [m] */
    struct shots_moment moment[SHOTS_MOST];
};

struct shots_picture {
    const char *name;
    double left, right, bottom, above; /* [m] */
    double pixel;                      /* [m] */
    int across;                        /* panels in a row */
};

/* Angles from which the whole is seen: about the vertical, then down [rad]. */
#define SHOTS_TURN (25 * 3.14159265358979323846 / 180)
#define SHOTS_TILT (20 * 3.14159265358979323846 / 180)

/* Reads what is shown of the run in RUN, TO/constants.gp. */
int shots_scene(struct shots_scene *s, const char *run, const char *to);

/* Moment k; shot_free() it, also when it cannot be read. */
int shots_read(const struct shots_scene *s, int k, struct shot *shot);

/* Discs are no smaller than what covers a pixel. */
double shots_radius(const struct shots_scene *scene, const struct shots_picture *picture);

/* Corners, panels and pixels; in the plane and in space. */
void shots_flat(const struct shots_scene *scene, int up, struct shots_picture *p);
void shots_whole(const struct shots_scene *scene, struct shots_picture *p);

/* Points half a pixel apart: with those a pixel apart gaps show white.  canvas_free() it. */
int shots_canvas(const struct shots_picture *p, struct canvas *c);

/* TO/view-K.csv: x, y in the picture, radius [m], what (0: on a face of a body, 1: on its edge, 2:
 * fluid, 3: wall), value (0: light on it, 0 to 1; 2: speed [m/s]). */
int shots_view(const struct shots_scene *scene, const struct shots_picture *p, const struct shot *s,
               int k);

/* TO/floor-bodies-K.csv, where there are bodies: faces that look up, what is low first, rows as in
 * snapshots/0003-bodies.csv, with two blank lines behind each. */
int shots_bodies(const struct shots_scene *scene, int k);

#endif
