/* contact-start.h -- what water lacks around solids at t = 0:
 *
 *   lack_w = rho0 s_w - sum_f m_f W_wf(0),  taken as 0 below a fifth of rho0 s_w */
#ifndef WALLS_CONTACT_START_H
#define WALLS_CONTACT_START_H

#include "walls/contact-room.h"

/* share and lack [solids]; lack in kg/m^D. */
int contact_start_lack(const struct part_places *at, const struct contact_cells *solids,
                       const struct contact_share *share, double *lack);

#endif
