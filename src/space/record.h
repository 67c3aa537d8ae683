/* record.h -- what the pair loop gathers of a neighbour: pairs of numbers that
 * one 16-byte load fetches, one cache line in 2D.
 *
 *   2D  {x,y} {vx,vy} {rho,p2} {m,irho}
 *   3D  {x,y} {z,rho} {vx,vy} {vz,p2} {m,irho}       p2 = p/rho^2, irho = 1/rho
 *
 * Record number `listed` is the dummy that padding points at: far away, all
 * values finite, mass 1, so that its kernel is exactly 0. */
#ifndef SPACE_RECORD_H
#define SPACE_RECORD_H

#include "space/kinds.h"

#if DIM == 2
enum { RECORD = 8, RECORD_X = 0, RECORD_V = 2, RECORD_RHO = 4, RECORD_P2 = 5,
       RECORD_M = 6, RECORD_IRHO = 7 };
#else
enum { RECORD = 10, RECORD_X = 0, RECORD_Z = 2, RECORD_RHO = 3, RECORD_V = 4,
       RECORD_VZ = 6, RECORD_P2 = 7, RECORD_M = 8, RECORD_IRHO = 9 };
#endif

#endif
