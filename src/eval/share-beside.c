/* share-beside.c -- looking at forces on many ranks: each finds those of its own rows, with the run's list
 * where that fits.
 *
 * Else that list is made where it is looked, as one rank makes another, and then again where it was made
 * before: by these places it has the same bits, and no rank needs memory for two. */
#include "eval/share.h"

#include "base/status.h"
#include "space/list.h"

/* The run's list becomes what it was, which had been made so often. */
static int put_back(struct moment *run, bool stood, long builds)
{
    struct moment_share *s = run->share;
    struct cloud cloud;
    int status = STATUS_DONE;

    share_set_aside(s);
    list_forget(run->own);
    if (stood) {
        share_cloud(run, &cloud);
        status = share_make(run, &cloud, s->built);
    }
    run->own->builds = builds;
    wet_forget(run);
    return status;
}

int share_look(struct moment *m, double t, const double *y)
{
    struct moment *run = m->beside;
    struct moment_share *s = run->share;
    struct list *own = m->own;
    const bool stood = run->own->stands;
    const long builds = run->own->builds;
    int status, after = STATUS_DONE;

    m->share = s;
    m->own = m->list = run->own;
    status = rates_eval(m, &ASK_ALL, t, y, m->work->rates, NULL, NULL);
    if (status == STATUS_DONE)
        share_see_near(m, y + layout_at(&m->layout, m->plan->row.x));
    m->share = NULL;
    m->own = m->list = own;
    if (s->near.made_aside)
        after = put_back(run, stood, builds);
    s->near.looked = true;
    return status != STATUS_DONE ? status : after;
}
