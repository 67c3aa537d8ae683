/* contacts-table.h -- which pairs of solids may touch, and where each of them remembers: in places
 * of its own or, where that is too much, in seats that bodies share. */
#ifndef BODIES_CONTACTS_TABLE_H
#define BODIES_CONTACTS_TABLE_H

#include "bodies/contacts-list.h"

/* Pairs, their places, and how many seats there are; of contacts that know their solids. */
int contacts_table_make(struct contacts *c, const struct contacts_scene *s);

/* BAD_SCENE: all have more places than y may have. */
int contacts_table_check(const struct contacts *c);

/* Friction and restitution of a part, a body or a wall, with a solid. */
struct contacts_rub contacts_table_rub(const struct contacts *c, const struct contacts_scene *s,
                                       int part, int solid);

#endif
