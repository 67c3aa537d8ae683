/* contact.c -- solids that stop water where its full kernel begins.
 *
 * Points of walls and skins obey (D1) like the fluid, with the velocity of the solid: so their
 * density is a function of positions.  Its constant is such that it reaches that at rest when
 * all the room around that is open to water is full:
 *
 *   rho_w(0) = rho0 (1 + d_w) - lack_w - g(o_w(0)),  pi_w(d_w) = p_start/rho^2   contact-start.h
 *   r_w = rho_w + g(o_w)                                                   contact-others.h
 *   d = sum_w' A_ww' r_w'/rho0 - 1                                         contact-mean.h
 *   d+ = (d + sqrt(d^2 + eps^2))/2,  eps = 1e-3                                contact-side.h
 *   e_w = e(rho0 (1 + d+)),  pi_w = p(rho0 (1 + d+))/(rho0 (1 + d+))^2 d+/sqrt(d^2 + eps^2)
 *   q_w = sum_w' A_w'w pi_w' m_w'/m_w                                            (W6)
 *
 * and q_w stands for p_w/rho_w^2 in (P1).  q_w is the exact derivative of the energy stored,
 * sum m e, so the book closes to rounding; it is never negative, so nothing sucks.  The density
 * that solids show is rho0 (1 + d+). */
#include "walls/contact-press.h"

#include "base/lanes.h"
#include "walls/solid-rows.h"
#include "walls/walls.h"

static const char *const with[] = { "continuity", NULL };

static const struct part_wall wall = {
    .as_fluid = true,
    .with = with,
    .press = &contact_press,
};

const struct part LANE_NAME(walls_contact) = {
    .name = "contact",
    .about = "solids that stop water at their faces, without gap or suction",
    .equation = "(W6) rho_w by (D1), d = sum_w' A_ww' rho_w'/rho0 - 1, d+ = (d + sqrt(d^2 + "
                "1e-6))/2, e_w = e(rho0 (1 + d+)), q_w = sum_w' A_w'w de_w'/drho; (P1) with q_w",
    .source = "Crespo, Gomez-Gesteira, Dalrymple, Comput. Mater. Contin. 5 (2007) 173-184, with "
              "a constant, a mean and one side of its own",
    .size = sizeof(struct contact_press_self),
    .needs = FIELD_DENSITY | FIELD_PRESSURE,
    .prepare = contact_press_prepare,
    .blocks = solid_rows_add,
    .as.wall = &wall,
};
