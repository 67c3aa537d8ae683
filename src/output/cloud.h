/* cloud.h -- all particles at one moment, as particle files want it: fluid and
 * solids in one list, order of ids. */
#ifndef OUTPUT_CLOUD_H
#define OUTPUT_CLOUD_H

#include <stdbool.h>

/* Rigid bodies as shapes: in the plane a face is an outline, in space faces are flat and close. */
struct cloud_looks {
    int bodies, corners, faces;
    const char *const *name;   /* [bodies] */
    const double *x, *u;       /* [corners][dim] position [m], velocity [m/s]    */
    const int *of;             /* [faces] body 0, 1, ..., growing                */
    const int *first, *loop;   /* face i: corners loop[first[i]] up to loop[first[i+1]],
                                  anticlockwise, in space seen from outside       */
};

struct cloud_frame {
    double t;                  /* [s]                                            */
    int n, dim;                /* particles, components of x and u: 2 or 3       */
    int from, here;            /* this rank has particles from .. from + here - 1; one rank
                                  has all                                        */
    bool shared;               /* all ranks write what they have                 */
    const double *x;           /* [here][dim] position                  [m]      */
    const double *u;           /* [here][dim] velocity                  [m/s]    */
    const double *rho;         /* [here]   density            [kg/m^3, 2D too]   */
    const double *p;           /* [here]   pressure                     [Pa]     */
    const unsigned char *dye;  /* [n]      colour 0, 1, ...                      */
    const unsigned char *kind; /* [n]      enum kind (space/kinds.h); both on the first rank alone */
    const struct cloud_looks *looks; /* NULL: no rigid bodies                     */
};

/* What the first rank does with particles from .. from + here - 1 of a frame. */
typedef void cloud_see(void *self, const struct cloud_frame *part);

/* Shows the first rank all particles of a frame, part by part in order of ids: where it is shared all ranks
 * call it, and no rank ever has all of them.  STATUS_FAILED, on all: no memory, and nothing was shown. */
int cloud_show(const struct cloud_frame *frame, cloud_see *see, void *self);

#endif
