/* facts.h -- the little of a scene that a study of its runs has to know. */
#ifndef STUDY_FACTS_H
#define STUDY_FACTS_H

#include <stdbool.h>

struct scene;

struct facts {
    char title[128];
    double until, dx;     /* [s], [m]; dx 0 without particles                        */
    double gravity[3];    /* [m/s^2]                                                 */
    double period[3];     /* length after which it repeats along an axis [m]; 0: never */
    int dimension;
    bool beam, fluid;
};

/* Reads them; all else is the run's to read and to refuse. */
int facts_read(struct scene *scene, struct facts *f);

/* Size of gravity [m/s^2]. */
double facts_gravity(const struct facts *f);

/* Files of the scene, includes too, as one number. */
int facts_hash(const char *scene, char *to, unsigned long size);

#endif
