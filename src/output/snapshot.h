/* snapshot.h -- particles at chosen times as plain CSV, for gnuplot and spreadsheets:
 *
 *     DIR/snapshots.csv        t,file
 *     DIR/snapshots/0003.csv   x,y,ux,uy,rho,p,dye,kind (3D: x,y,z,ux,uy,uz,...)
 *     DIR/snapshots/0003-bodies.csv    surfaces of rigid bodies, output/looks-file.h; and in 3D
 *     DIR/snapshots/0003-surface.csv   points on them, for pictures with depth
 *     DIR/snapshots/0003-cut.csv       their outlines where the tank is cut in the middle
 */
#ifndef OUTPUT_SNAPSHOT_H
#define OUTPUT_SNAPSHOT_H

#include "base/archive.h"
#include "output/cloud.h"

struct snapshot;

/* again: goes on with the files that are there, after snapshot_keep(). */
int snapshot_open(struct snapshot **out, const char *dir, bool again);

/* In 3D: points on surfaces are no farther apart than `step`, and bodies are cut at y = `middle` [m]. */
void snapshot_fineness(struct snapshot *s, double step, double middle);
int snapshot_keep(struct snapshot *s, struct archive *a); /* NULL is welcome */
/* Where the frame is shared all ranks call it, others than the first with s NULL. */
int snapshot_write(struct snapshot *s, const struct cloud_frame *frame);
int snapshot_close(struct snapshot **snapshot); /* NULL is welcome */

#endif
