/* survey.c -- how large a plan would be, by shapes alone. */
#include "plan/survey.h"

#include "base/status.h"
#include "plan/inside.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Some seconds of one processor, and some hundred MB. */
static const double most_pairs = 1.5e8, most_particles = 1.5e6;

/* Pairs of the list, and looks around particles of solids (walls/contact-room.h). */
static double pairs(const struct plan *p, const struct plan_survey *s)
{
    const double reach = p->in.kernel.support * (1 + p->in.kernel.skin);
    const bool looks = p->in.walls->as.wall && p->in.walls->as.wall->press;
    const double ball = DIM == 2 ? M_PI * reach * reach : 4 * M_PI / 3 * pow(reach, 3);
    const double cube = pow(2 * ceil(p->in.kernel.support) + 1, DIM);

    return s->fluid * ball + s->solid * (looks ? cube : ball);
}

int plan_survey_take(struct plan *p, struct plan_survey *s)
{
    const int status = plan_objects_count(p, s);

    snprintf(s->title, sizeof s->title, "%s", p->in.set.title);
    s->dx = p->scales.dx;
    s->support = p->scales.support;
    s->mass = p->scales.mass;
    s->c0 = p->scales.c0;
    s->speed = p->scales.speed;
    s->bytes = s->fluid * plan_memory_each(p, true) + s->solid * plan_memory_each(p, false);
    s->pairs = pairs(p, s);
    s->large = s->pairs > most_pairs || s->fluid + s->solid > most_particles;
    return status;
}

void plan_survey_free(struct plan_survey *survey)
{
    free(survey->object);
    survey->object = NULL;
}
