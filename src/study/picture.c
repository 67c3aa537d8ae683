/* picture.c -- draws the figures of a study. */
#include "study/picture.h"

#include "base/status.h"
#include "output/figures.h"
#include "output/json-find.h"

#include <math.h>

int picture_draw(const struct member_home *h, const struct facts *f, const struct member *of_run,
                 const char *scripts)
{
    struct figures_constants c = { .title = f->title, .dim = f->dimension, .until = f->until,
                                   .beam_x = NAN, .dx = f->dx };
    char path[MEMBER_PATH];

    member_path(h, of_run, "run.json", path);
    c.E0 = json_find_number(path, "energy_initial");
    TRY(figures_constants(h->directory, &c));
    if (figures_draw(h->directory, scripts, scripts) != STATUS_DONE) {
        status_warn("%s", status_message());
        status_clear();
    }
    return STATUS_DONE;
}
