/* track.c -- a smooth curve through pairs. */
#include "state/track.h"

#include "base/status.h"

#include <gsl/gsl_interp.h>
#include <math.h>
#include <stdlib.h>

struct track {
    int n;
    double *t, *value; /* [n] */
    gsl_interp *curve;
};

static int check(const struct param_points *pairs, const char *key, const char *where)
{
    if (pairs->n < 2)
        return status_fail(STATUS_BAD_SCENE, "%s: %s has one pair; a motion needs two at least: "
                           "[[TIME, VALUE], [TIME, VALUE], ...]", where, key);
    for (int i = 1; i < pairs->n; i++)
        if (!(pairs->x[i][0] > pairs->x[i - 1][0]))
            return status_fail(STATUS_BAD_SCENE, "%s: %s: time %g s of pair %d does not lie after "
                               "%g s of the pair before; put them in order", where, key,
                               pairs->x[i][0], i + 1, pairs->x[i - 1][0]);
    return STATUS_DONE;
}

static int fill(struct track *k, const struct param_points *pairs)
{
    const gsl_interp_type *type = pairs->n > 2 ? gsl_interp_steffen : gsl_interp_linear;

    k->n = pairs->n;
    k->t = status_alloc((unsigned long)k->n, sizeof *k->t);
    k->value = status_alloc((unsigned long)k->n, sizeof *k->value);
    k->curve = gsl_interp_alloc(type, (size_t)k->n);
    if (!k->t || !k->value || !k->curve)
        return status_starved("a motion of %d pairs cannot be kept", k->n);
    for (int i = 0; i < k->n; i++) {
        k->t[i] = pairs->x[i][0];
        k->value[i] = pairs->x[i][1];
    }
    gsl_interp_init(k->curve, k->t, k->value, (size_t)k->n);
    return STATUS_DONE;
}

int track_create(const struct param_points *pairs, const char *key, const char *where,
                 struct track **out)
{
    int status;

    *out = NULL;
    if (pairs->n == 0)
        return STATUS_DONE;
    TRY(check(pairs, key, where));
    if (!(*out = status_alloc(1, sizeof **out)))
        return STATUS_FAILED;
    status = fill(*out, pairs);
    if (status != STATUS_DONE)
        track_free(out);
    return status;
}

void track_free(struct track **track)
{
    if (!*track)
        return;
    gsl_interp_free((*track)->curve);
    free((*track)->t);
    free((*track)->value);
    free(*track);
    *track = NULL;
}

void track_at(const struct track *k, double t, double *value, double *rate, double *second)
{
    *value = *rate = *second = 0;
    if (!k)
        return;
    if (t <= k->t[0] || t >= k->t[k->n - 1]) {
        *value = k->value[t <= k->t[0] ? 0 : k->n - 1];
        return;
    }
    gsl_interp_eval_e(k->curve, k->t, k->value, t, NULL, value);
    gsl_interp_eval_deriv_e(k->curve, k->t, k->value, t, NULL, rate);
    gsl_interp_eval_deriv2_e(k->curve, k->t, k->value, t, NULL, second);
}

double track_first(const struct track *k)
{
    return k->t[0];
}

double track_last(const struct track *k)
{
    return k->t[k->n - 1];
}

double track_next(const struct track *k, double start, double t)
{
    for (int i = 0; k && i < k->n; i++)
        if (start + k->t[i] > t)
            return start + k->t[i];
    return HUGE_VAL;
}
