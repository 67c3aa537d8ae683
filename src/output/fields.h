/* fields.h -- particles for viewers: a time series that ParaView and VTK open.
 *
 * Each moment is a file of its own, DIR/fields/000012.vtkhdf: HDF5 in the
 * layout of a VTK unstructured grid of vertex cells, with `velocity`,
 * `density`, `pressure`, `dye`, `kind` and `id` for each point and `time`.  The
 * index DIR/fields.xdmf names them all with their times.
 *
 *   ParaView 5.11       opens fields.xdmf: the series with its times
 *   VTK 9.1 of Debian   has no XDMF reader; its vtkHDFReader opens each file
 *   h5py, h5dump ...    /VTKHDF/Points, /VTKHDF/PointData/pressure, ...
 *
 * With rigid bodies there is DIR/fields/000012-bodies.vtkhdf beside it: their surfaces as polygons, with
 * `velocity` at corners and `body`, a number from 0, on faces.  In fields.xdmf each moment is then a
 * collection of two grids, `particles` and `bodies`.
 *
 * All files are written aside and renamed, the index last: whatever happens to
 * the run, what the index names is there and whole. */
#ifndef OUTPUT_FIELDS_H
#define OUTPUT_FIELDS_H

#include "base/archive.h"
#include "output/cloud.h"

struct fields;

/* Makes DIR/fields.  All moments have these bodies (names and faces are lent), NULL: none.  A run that goes on with the files that are there calls fields_keep(). */
int fields_open(struct fields **out, const char *dir, const struct cloud_looks *looks);

/* Which moments there are; loading cuts the index back to them.  NULL is welcome. */
int fields_keep(struct fields *f, struct archive *a);

/* Adds a moment; times must grow. In 2D z and the third velocity are 0.  Where the frame is shared all ranks
 * call it, others than the first with f NULL. */
int fields_write(struct fields *f, const struct cloud_frame *frame);

void fields_close(struct fields **fields); /* frees; NULL is welcome */

#endif
