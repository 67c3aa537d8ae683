/* contact-press.h -- what solids of walls = "contact" know of their places, once for all lane
 * widths; the equations, and what presses, are in contact.c. */
#ifndef WALLS_CONTACT_PRESS_H
#define WALLS_CONTACT_PRESS_H

#include "matter/eos.h"
#include "walls/contact-mean.h"
#include "walls/contact-others.h"
#include "walls/contact-reach.h"

struct contact_press_self {
    struct eos eos;
    bool sharp;                      /* eps = 0                                   */
    int solids;
    const struct kernel_use *kernel; /* of densities                              */
    struct contact_mean mean;
    unsigned char *kind;             /* [n of the mean]                           */
    struct contact_others others;
    double *missing;                 /* [solids] by id: lack + g(o) at t = 0 [kg/m^D] */
};

/* All in the order of the mean, as long as its slices. */
struct part_press_work {
    double *rho;     /* r                                     [kg/m^D] */
    double *pi;      /* m pi/N                                         */
    double *around;  /* o                                     [kg/m^D] */
    double *slope;   /* dg/do of the last press()                      */
    bool *touched;   /* other solids are near                          */
    int *row;        /* from the first solid, of the last press(): one of these */
    int *rows[2];    /* of the last that kept rests, which stand in these rows; of the last other */
    const struct contact_slices *last; /* those of the last press()    */
    struct {
        const double *shown, *p2;
        long made;   /* of reach                                   */
        int n, *slice; /* those whose rows are not at rest         */
    } rest;          /* arrays that have what there is without water, but in some slices */
    struct contact_reach reach;
    struct contact_others_work others;
};

/* The row of particle i of the mean, counted over all kinds. */
static inline int contact_press_row(const struct contact_press_self *c, const struct particles *p,
                                    int i)
{
    const int id = p->from[KIND_WALL] + c->mean.solid[i], k = c->kind[i];

    return p->row[k] ? p->from[k] + p->row[k][id - p->from[k]] : id;
}

/* Looks for other solids where those of p are; the slices to evaluate. */
const struct contact_slices *contact_press_look(const struct contact_press_self *c,
                                                struct part_press_work *w,
                                                const struct particles *p, enum part_solids which);

/* Members of the part. */
int contact_press_prepare(void *self, const struct scales *s);
int contact_press_create(void *self, const struct part_places *at);
void contact_press_free(void *self);
void contact_press_start(const void *self, const struct particles *p, enum kind k, double *rho);
int contact_press_work(const void *self, struct part_press_work **out);
void contact_press_work_free(struct part_press_work **work);
void contact_press_choose(const void *self, struct part_press_work *w, enum part_solids which,
                          const bool *solid);
bool contact_press_reads(const void *self, const struct part_press_work *w, bool *read);
int contact_press_meet(const void *self, struct part_press_work *w, const struct particles *p,
                       const double *p2, double (*f)[DIM], int *row);
void contact_press_mean(const void *self, struct part_press_work *w, const double *from,
                        double *to);
void contact_press_spread(const void *self, struct part_press_work *w, const double *from,
                          double *to);
double contact_press_memory(const void *self);
void contact_press_show(const void *self, part_see *see, void *whose);

#endif
