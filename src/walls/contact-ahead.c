/* contact-ahead.c -- means of numbers of solids and their transpose, for a pressure of walls that
 * is solved for: A and A^T of contact-mean.h. */
#include "walls/contact-press.h"

#include <string.h>

static int end_of(const struct contact_mean *m, int slice)
{
    return (slice + 1) * CONTACT_ROWS < m->n ? (slice + 1) * CONTACT_ROWS : m->n;
}

/* to_w = sum_w' A_ww' from_w'; what is in no slice that is asked for does not count. */
void contact_press_mean(const void *self, struct part_press_work *w, const double *from,
                        double *to)
{
    const struct contact_press_self *c = self;
    const struct contact_slices *l = w->last;

    memset(to, 0, (size_t)c->solids * sizeof *to);
    for (int k = 0; k < l->n[CONTACT_R]; k++)
        for (int s = l->slice[CONTACT_R][k], i = s * CONTACT_ROWS; i < end_of(&c->mean, s); i++)
            w->rho[i] = from[w->row[i]];
    for (int k = 0; k < l->n[CONTACT_PI]; k++) {
        const int s = l->slice[CONTACT_PI][k];
        double sum[CONTACT_ROWS];
        contact_mean_sums(&c->mean, s, w->rho, sum);
        for (int i = s * CONTACT_ROWS; i < end_of(&c->mean, s); i++)
            to[w->row[i]] = sum[i - s * CONTACT_ROWS] * c->mean.inverse[i];
    }
}

/* to_w = sum_w' A_w'w from_w'. */
void contact_press_spread(const void *self, struct part_press_work *w, const double *from,
                          double *to)
{
    const struct contact_press_self *c = self;
    const struct contact_slices *l = w->last;

    memset(to, 0, (size_t)c->solids * sizeof *to);
    for (int k = 0; k < l->n[CONTACT_PI]; k++)
        for (int s = l->slice[CONTACT_PI][k], i = s * CONTACT_ROWS; i < end_of(&c->mean, s); i++)
            w->pi[i] = from[w->row[i]] * c->mean.inverse[i];
    for (int k = 0; k < l->n[CONTACT_Q]; k++) {
        const int s = l->slice[CONTACT_Q][k];
        double sum[CONTACT_ROWS];
        contact_mean_sums(&c->mean, s, w->pi, sum);
        for (int i = s * CONTACT_ROWS; i < end_of(&c->mean, s); i++)
            to[w->row[i]] = sum[i - s * CONTACT_ROWS];
    }
}
