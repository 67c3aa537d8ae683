/* canvas.h -- which of many discs are seen, when nearer ones are drawn over farther ones.
 *
 * A grid of points, about the pixels of a picture: a disc is seen if it is the nearest on at least
 * one of them. */
#ifndef OUTPUT_CANVAS_H
#define OUTPUT_CANVAS_H

struct canvas {
    double left, bottom, fine; /* corner of the picture, and between points [m] */
    int across, up;            /* points                                        */
    float *depth;              /* [up][across] of the nearest disc so far       */
    int *id;                   /* [up][across] which it is; -1: none            */
};

/* Of a picture from left to right and bottom to above, with points `fine` apart [m]; canvas_free() it,
 * also when there is no memory for it. */
int canvas_make(struct canvas *c, double left, double right, double bottom, double above,
                double fine);

/* A disc at (x, y) with radius r [m], 0 <= id.  Of equally near ones the later one is seen. */
void canvas_disc(struct canvas *c, double x, double y, double r, double depth, int id);

/* mark[id] = 1 for those that are seen; others are left as they are. */
void canvas_mark(const struct canvas *c, unsigned char *mark);

void canvas_free(struct canvas *c);

#endif
