/* contacts-list.h -- which solids of a scene there are, and which of them may touch. */
#ifndef BODIES_CONTACTS_LIST_H
#define BODIES_CONTACTS_LIST_H

#include "bodies/contacts-beams.h"
#include "bodies/contacts-pair.h"
#include "bodies/contacts-skin.h"
#include "bodies/contacts-uplift.h"
#include "bodies/contacts.h"
#include "bodies/solid-wall.h"
#include "state/scales.h"

/* Where contacts have many places: those of pairs of bodies are in seats, contacts-seats.h. */
struct contacts_seats {
    int n, block;                /* how many; of so many places each; 0: pairs have places of
                                    their own                                      */
    long from;                   /* its first place                                */
    int row;
    double scale;                /* of a bend [m]                                  */
    double *first;               /* [n] pairs that have them at t = 0, from 1       */
};

struct contacts {
    struct scales scales;
    int bodies, walls, solids, movers; /* of solids the first are bodies           */
    struct {
        double around, film;     /* the largest of bodies [m]                      */
    } most;
    double slow;                 /* the least of pairs [1/s]                       */
    struct solid *solid;         /* [solids] rigid bodies, walls, sides of the domain */
    int *part_of;                /* [solids] of which body, or wall from `bodies` on; a side that
                                    is no wall's: bodies + walls                   */
    struct solid_wall *of_wall;  /* [walls] their cores, those of frames without   */
    bool *known;                 /* [bodies + walls] does it touch?               */
    int pairs, skins, beams;
    struct contacts_pair *pair;  /* [pairs] of solids                              */
    int *pair_of;                /* [movers][solids] which pair that is, -1: none  */
    int always;                  /* the pair with the fastest rate without a contact, -1: none */
    struct contacts_skin *skin;  /* [skins] of a skin and a solid                  */
    struct contacts_beams *beam; /* [beams] of two skins, each pair both ways      */
    int lifts;
    struct contacts_lift {       /* of boxes with uplift                           */
        int solid, body;
        struct contacts_uplift *of;
    } *lift;                     /* [lifts]                                        */
    long places;
    int row;
    struct contacts_seats seats;
};

/* All but seats at t = 0, as in struct body_contacts. */
int contacts_list_create(const struct contacts_scene *scene, struct contacts **out);
void contacts_list_free(struct contacts **contacts);

/* The pair of solids i < j, -1: there is none. */
static inline int contacts_list_pair(const struct contacts *c, int i, int j)
{
    return c->pair_of[(long)i * c->solids + j];
}

/* Two places, and the way between them by the nearest image. */
struct contacts_stand contacts_list_stand(const struct contacts *c, const struct solid_place *a,
                                          const struct solid_place *b);

#endif
