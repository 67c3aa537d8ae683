/* cloud.h -- all particles at one moment, as particle files want it: fluid and
 * solids in one list, order of ids. */
#ifndef OUTPUT_CLOUD_H
#define OUTPUT_CLOUD_H

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
    const double *x;           /* [n][dim] position                     [m]      */
    const double *u;           /* [n][dim] velocity                     [m/s]    */
    const double *rho;         /* [n]      density            [kg/m^3, 2D too]   */
    const double *p;           /* [n]      pressure                     [Pa]     */
    const unsigned char *dye;  /* [n]      colour 0, 1, ...                      */
    const unsigned char *kind; /* [n]      enum kind (space/kinds.h)             */
    const int *id;             /* [n]      creation index; NULL: 0, 1, ...       */
    const struct cloud_looks *looks; /* NULL: no rigid bodies                     */
};

#endif
