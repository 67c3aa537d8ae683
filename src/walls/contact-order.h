/* contact-order.h -- an order in which particles that follow each other stand near each other.
 *
 * Fluid meets a part of the solids, and one of many ranks has a part: what is worked on in slices of
 * some particles in turn then takes few that are not asked for. */
#ifndef WALLS_CONTACT_ORDER_H
#define WALLS_CONTACT_ORDER_H

#include "state/part.h"

/* Sorts solids, counted from the first: by groups, in these along Morton's curve through cells of a
 * spacing (G. M. Morton, A computer oriented geodetic data base, IBM, 1966), then by id.
 * STATUS_FAILED: no memory. */
int contact_order_sort(const struct part_places *at, int n, int *solid);

#endif
