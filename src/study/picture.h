/* picture.h -- draws the figures of a study. */
#ifndef STUDY_PICTURE_H
#define STUDY_PICTURE_H

#include "study/facts.h"
#include "study/member.h"

/* Writes DIR/figures/constants.gp and draws what applies; of_run is one whose energy at the
 * start is the scene's.  What gnuplot refuses is a warning. */
int picture_draw(const struct member_home *h, const struct facts *f, const struct member *of_run,
                 const char *scripts);

#endif
