/* crew.c -- carries out the runs of a study that are not there yet, side by side.
 *
 * Runs are child processes, so that one that fails takes nothing with it, its CPU time is its
 * own, and a study that is interrupted goes on with what is there. */
#include "study/crew.h"

#include "base/status.h"
#include "run/stop.h"
#include "study/children.h"
#include "study/tell.h"

#include <stdlib.h>
#include <string.h>

/* A crew at work. */
struct work {
    const struct crew *crew;
    int *number;          /* [n] of the members that are not there yet */
    char **settings;      /* [n] */
    struct child *child;  /* [n] */
    int n;
    struct tell tell;
};

static struct member *member(const struct work *w, int i)
{
    return w->crew->member(w->crew->self, w->number[i]);
}

static int changed(const struct work *w)
{
    return w->crew->changed ? w->crew->changed(w->crew->self) : STATUS_DONE;
}

static void came(struct work *w, int number)
{
    w->tell.ended++;
    w->tell.bad += w->crew->member(w->crew->self, number)->code != STATUS_DONE;
    if (w->crew->came)
        w->crew->came(w->crew->self, number);
}

/* Also checkpoints: a run of a study that was interrupted is made from its beginning. */
static bool begin(void *self, int i)
{
    static const char *const old[] = { "run.json", "order", "said", "checkpoint.h5",
                                       "checkpoint-before.h5" };
    struct work *w = self;
    char path[MEMBER_PATH];

    if (w->crew->wanted && !w->crew->wanted(w->crew->self, w->number[i])) {
        w->tell.all--;
        return false;
    }
    for (size_t k = 0; k < sizeof old / sizeof old[0]; k++) {
        member_path(w->crew->home, member(w, i), old[k], path);
        remove(path);
    }
    w->tell.now = member(w, i)->name;
    return true;
}

static int end(void *self, int i)
{
    struct work *w = self;
    struct member *m = member(w, i);

    m->code = w->child[i].code;
    m->late = w->child[i].late && m->code != STATUS_DONE;
    if (m->code != STATUS_DONE && !m->late && (m->code == STATUS_STOPPED || stop_asked()))
        return STATUS_DONE; /* by whoever stops us: it is to be done again */
    TRY(member_end(w->crew->home, m, w->settings[i]));
    came(w, w->number[i]);
    return changed(w);
}

static void look(void *self, int running)
{
    struct work *w = self;

    tell_look(&w->tell, running);
}

/* Directory, words and place for what is said. */
static int make_child(struct work *w, int i)
{
    char said[MEMBER_PATH];

    TRY(member_directory(w->crew->home, member(w, i)));
    member_path(w->crew->home, member(w, i), "said", said);
    w->child[i].budget = w->crew->budget;
    w->child[i].said = strdup(said);
    w->child[i].words = member_words(w->crew->home, member(w, i), w->settings[i]);
    if (!w->child[i].said || !w->child[i].words)
        return status_starved("the order of a run cannot be kept");
    return STATUS_DONE;
}

/* Number `number': there already, or one more child. */
static int take(struct work *w, int number)
{
    struct member *m = w->crew->member(w->crew->self, number);
    const int i = w->n;

    if (!*m->name)
        return STATUS_DONE;
    w->settings[i] = w->crew->settings(w->crew->self, number);
    if (!w->settings[i])
        return status_starved("the order of a run cannot be kept");
    w->number[w->n++] = number;
    if (!member_reuse(w->crew->home, m, w->settings[i]))
        return make_child(w, i);
    free(w->settings[i]);
    w->n--;
    w->tell.reused++;
    came(w, number);
    return STATUS_DONE;
}

static int go(struct work *w)
{
    const struct children_watch watch = { begin, end, look, stop_asked, w };

    w->number = status_alloc(w->crew->n + 1, sizeof *w->number);
    w->settings = status_alloc(w->crew->n + 1, sizeof *w->settings);
    w->child = status_alloc(w->crew->n + 1, sizeof *w->child);
    if (!w->number || !w->settings || !w->child)
        return STATUS_FAILED;
    for (int i = 0; i < w->crew->n; i++)
        TRY(take(w, i));
    w->tell.all = w->tell.ended + w->n;
    TRY(changed(w));
    return children_run(w->child, w->n, w->crew->jobs > 1 ? w->crew->jobs : 1, &watch);
}

int crew_run(const struct crew *crew)
{
    struct work w = { .crew = crew };
    int status;

    tell_start(&w.tell, crew->what, 0, crew->quiet);
    status = go(&w);
    tell_end(&w.tell);
    for (int i = 0; i < w.n; i++) {
        free(w.settings[i]);
        free((char *)w.child[i].said);
        free((char **)w.child[i].words);
    }
    free(w.number);
    free(w.settings);
    free(w.child);
    return status;
}
