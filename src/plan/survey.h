/* survey.h -- how large a plan would be, before anything is placed. */
#ifndef PLAN_SURVEY_H
#define PLAN_SURVEY_H

#include <stdbool.h>

struct plan;
struct scene;

struct plan_survey_object {
    char name[64];
    const char *group; /* "fluid", "wall", "beam" */
    double n;          /* particles, about        */
};

struct plan_survey {
    bool large;                        /* too large: no plan was made                        */
    char title[400];
    struct plan_survey_object *object; /* [objects] */
    int objects;
    double fluid, solid;               /* particles of all                       */
    double pairs;                      /* looks at pairs until a plan is ready   */
    double bytes;                      /* at the peak of a run                   */
    double dx, support, mass, c0, speed; /* as struct scales has them            */
};

/* As plan_create(), but a plan that would take longer than some seconds to make is not made: then
 * *out is NULL and survey->large.  What memory has no room for is refused, and counted too.
 * Free the survey, whatever comes back. */
int plan_survey_create(struct scene *scene, struct plan_survey *survey, const struct plan **out);
/* Makes none whatever the size. */
int plan_survey_count(struct scene *scene, struct plan_survey *survey);
void plan_survey_free(struct plan_survey *survey);

#endif
