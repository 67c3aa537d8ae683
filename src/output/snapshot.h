/* snapshot.h -- particles at chosen times as plain CSV, for gnuplot and spreadsheets:
 *
 *     DIR/snapshots.csv        t,file
 *     DIR/snapshots/0003.csv   x,y,ux,uy,rho,p,dye,kind (3D: x,y,z,ux,uy,uz,...)
 */
#ifndef OUTPUT_SNAPSHOT_H
#define OUTPUT_SNAPSHOT_H

#include "output/cloud.h"

struct snapshot;

int snapshot_open(struct snapshot **out, const char *dir);
int snapshot_write(struct snapshot *s, const struct cloud_frame *frame);
int snapshot_close(struct snapshot **snapshot); /* NULL is welcome */

#endif
