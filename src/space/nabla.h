/* nabla.h -- divergence and gradient over pairs, made for operators that are applied many
 * times at the same positions: from values by slot to values by slot, with the weights of
 * pairs worked out anew, nothing stored.
 *
 *     (D a)_i = sum over j of m_i m_j (a_i - a_j) . gradW_ij
 *     (G p)_i = sum over j of m_i m_j (p_i + p_j) gradW_ij
 *     (T q)_i = sum over j of q_j |m_i m_j gradW_ij|^2
 *     (W q)_i = sum over j of q_j m_i m_j W_ij
 *     (C v)_i = sum over j of m_i m_j (v_i - v_j) . (grad grad W_ij) (v_i - v_j)
 *
 * C v is the rate of D v where positions move with v and v does not change.
 *
 * When `meets` is symmetric, G is the transpose of D: the sum of p . D a over all owners is
 * that of a . G p.  Where neighbours are on all sides, at density rho0, D a / m tends to
 * -rho0 div a, and G p / m to rho0 grad p.
 *
 * The diagonal of D Q G, Q a diagonal matrix with q (1/m of particles that move, 0 of others),
 * is q_i |S_i|^2 + (T q)_i with S = G 1 / 2, the gradient of ones by two.
 *
 * No bit depends on the number of threads nor on the lane width. */
#ifndef SPACE_NABLA_H
#define SPACE_NABLA_H

#include "space/list.h"

struct kernel_use;

/* Numbers of one vector: pairs of them are loaded at once. */
enum { NABLA_STRIDE = DIM == 2 ? 2 : 4 };

struct nabla_job {
    const struct list *list;
    const double *record;            /* [listed+1][RECORD] (space/record.h), 64-byte aligned;
                                        only places and m [kg] are looked at    */
    const unsigned *meets;           /* [KINDS] partner kinds by owner kind, each of
                                        them among `acts` of the list           */
    const struct kernel_use *kernel; /* H not above the support of the list     */
};

/* Scalars are [listed + 1], vectors [listed + 1][NABLA_STRIDE] and 16-byte aligned: by slot,
 * those of images and of the dummy, which must be finite, too.  Results are [particles] and
 * [particles][DIM], of owners of some kinds (KIND_BITs): others are not touched. */
struct nabla_engine {
    void (*divergence)(const struct nabla_job *job, unsigned kinds, const double *a,
                       double *to);
    void (*bend)(const struct nabla_job *job, unsigned kinds, const double *v, double *to);
    void (*gradient)(const struct nabla_job *job, unsigned kinds, const double *p, double *to);
    void (*squares)(const struct nabla_job *job, unsigned kinds, const double *q, double *to);
    void (*weights)(const struct nabla_job *job, unsigned kinds, const double *q, double *to);
};
extern const struct nabla_engine nabla_engine_lanes2, nabla_engine_lanes4, nabla_engine_lanes8;

#endif
