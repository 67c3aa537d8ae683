/* contacts-list.h -- which solids of a scene there are, and which of them may touch. */
#ifndef BODIES_CONTACTS_LIST_H
#define BODIES_CONTACTS_LIST_H

#include "bodies/contacts-pair.h"
#include "bodies/contacts-skin.h"
#include "bodies/contacts-uplift.h"
#include "bodies/contacts.h"
#include "bodies/solid-wall.h"
#include "state/scales.h"

struct contacts {
    struct scales scales;
    int bodies, walls, solids;
    struct solid *solid;         /* [solids] rigid bodies, walls, sides of the domain */
    int *part_of;                /* [solids] of which body, or wall from `bodies` on; a side that
                                    is no wall's: bodies + walls                   */
    struct solid_wall *of_wall;  /* [walls] their cores, those of frames without   */
    bool *known, *skinned;       /* [bodies + walls] does it touch; as a skin only? */
    int pairs, skins;
    struct contacts_pair *pair;  /* [pairs] of solids                              */
    struct contacts_skin *skin;  /* [skins] of a skin and a solid                  */
    int lifts;
    struct contacts_lift {       /* of boxes with uplift                           */
        int solid, body;
        struct contacts_uplift *of;
    } *lift;                     /* [lifts]                                        */
    long places;
    int row;
};

/* As in struct body_contacts. */
int contacts_list_create(const struct contacts_scene *scene, struct contacts **out);
void contacts_list_free(struct contacts **contacts);

/* Two places, and the way between them by the nearest image. */
struct contacts_stand contacts_list_stand(const struct contacts *c, const struct solid_place *a,
                                          const struct solid_place *b);

#endif
