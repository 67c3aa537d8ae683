/* record-pack.h -- records of places in double precision from what particles have. */
#ifndef SPACE_RECORD_PACK_H
#define SPACE_RECORD_PACK_H

#include "space/list.h"
#include "space/record.h"

/* Of one kind. */
struct record_source {
    const int *order;               /* index of a particle by place                   */
    int first;                      /* index of the first of the kind                 */
    const double *x, *u;            /* [][DIM] by row of the kind        [m], [m/s]   */
    struct rows_beyond beyond;      /* of x, u and rho                                */
    const double *m;                /* by index                                [kg]   */
    double mass;                    /* of all of them [kg, 2D: kg/m], or 0            */
    const double *rho;              /* [] by row of the kind, NULL: all rho0 [kg/m^D] */
    double rho0, bounds[2];         /* of densities                          [kg/m^D] */
    const double (*offset)[DIM];    /* added to x, by place [m]; NULL: nothing        */
    const struct list_def *def;
};

/* Fills record [][RECORD] of the places from..to-1 with what `of` has, and with density
 * rho [kg/m^D] and pressure [Pa], both from place `from` on.  False: some of them stand outside
 * of def's box, and their records are not to be used. */
typedef bool record_packer(const struct record_source *of, int from, int to, const double *rho,
                           const double *pressure, double *record);

record_packer record_pack_lanes2, record_pack_lanes4, record_pack_lanes8;

/* Densities of the places from..to-1, from rho[0] on.  False: some of them are not within bounds.
 * What record_packer will read is scattered, and is asked for here. */
typedef bool record_densities(const struct record_source *of, int from, int to, double *rho);

record_densities record_densities_lanes2, record_densities_lanes4, record_densities_lanes8;

#endif
