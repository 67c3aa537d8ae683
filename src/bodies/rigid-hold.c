/* rigid-hold.c -- forces of joints, motions and springs on a rigid body, and their books. */
#include "bodies/rigid-hold.h"

void rigid_hold_pull(const struct body *b, struct body_work *w, double *sum, double *moment,
                     struct body_load *out)
{
    for (int i = 0; i < b->def.ties.springs; i++) {
        struct rigid_pull pull;
        rigid_spring_pull(&b->rope[i], w->R, w->x, w->v, w->spin, &pull);
        out->damping += pull.damping;
        for (int d = 0; d < DIM; d++) {
            sum[d] += pull.force[d];
            out->support[d] += pull.force[d];
        }
        for (int k = 0; k < TURNING_SPINS; k++)
            moment[k] += pull.moment[k];
    }
}

double rigid_hold_answer(const struct body *b, struct body_work *w, const double *sum,
                         const double *moment, struct body_load *out)
{
    struct rigid_answer answer;
    double all[DIM];

    for (int d = 0; d < DIM; d++)
        all[d] = sum[d] + b->mass * b->g[d];
    rigid_joint_answer(&b->joint, &w->place, &w->link, all, moment, &answer);
    out->driven += answer.driven;
    out->damping += answer.damping;
    for (int d = 0; d < DIM; d++)
        out->support[d] += answer.force[d];
    return answer.second;
}

double rigid_hold_elastic(const struct body *b, struct body_work *w)
{
    double sum = b->joint.kind == RIGID_FREE ? 0 : rigid_joint_elastic(&b->joint, w->link.q);

    for (int i = 0; i < b->def.ties.springs; i++) {
        struct rigid_pull pull;
        rigid_spring_pull(&b->rope[i], w->R, w->x, w->v, w->spin, &pull);
        sum += pull.elastic;
    }
    return sum;
}
