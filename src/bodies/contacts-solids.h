/* contacts-solids.h -- which solids a scene has, for contacts. */
#ifndef BODIES_CONTACTS_SOLIDS_H
#define BODIES_CONTACTS_SOLIDS_H

#include "bodies/contacts-list.h"

/* Takes the memory of solids and lists them, with what is known of bodies and walls; the first
 * *bodies are of rigid bodies.  The caller frees them, also after a failure. */
int contacts_solids_list(struct contacts *c, const struct contacts_scene *s, int *bodies);
void contacts_solids_free(struct contacts *c);

/* The skin by which a body touches; NULL: it touches nothing with it. */
const struct body_surface *contacts_solids_surface(const struct contacts_body *b);

#endif
