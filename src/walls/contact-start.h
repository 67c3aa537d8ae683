/* contact-start.h -- what water lacks around solids at t = 0:
 *
 *   lack_w = rho0 s_w - sum_f m_f W_wf(0) - g(o_w(0)),  taken as 0 below a fifth of rho0 s_w
 *
 * and warns where water overfills that room, on both sides of one layer; with g(o_w) what other solids fill (contact-others.h). */
#ifndef WALLS_CONTACT_START_H
#define WALLS_CONTACT_START_H

#include "walls/contact-others.h"

/* share [solids]; around [n of the mean]: o_w(0); to [solids] by id: lack_w + g(o_w(0)) [kg/m^D], which the
 * density of its own falls short of that of the pressure. */
int contact_start_short(const struct part_places *at, const struct contact_mean *mean,
                        const struct contact_others *others, const struct contact_share *share,
                        const double *around, double *to);

#endif
