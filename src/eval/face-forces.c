/* face-forces.c -- the fluid sticks at the faces of solids.
 *
 * With the velocity of their particles the fluid would stick where those are, dx/2 behind
 * the face and more.  So a solid's particle w counts with the velocity that is as far
 * beyond that of the face as the fluid before it stays behind,
 *
 *   v_w = 2 (u_w + b_w) - sum_f c_wf v_f / sum_f c_wf                               (W2)
 *
 * b_w the velocity of a face that slides, c the coefficients of the law itself, F_ab =
 * -c_ab (v_a - v_b).  Adami, Hu, Adams, J. Comput. Phys. 231 (2012) 7057-7075, eq. 22, 23,
 * weigh with W; weighed with c the forces are symmetric in velocities and take out
 *
 *   sum_w [ sum_f c_wf e_f^2 + (sum_f c_wf e_f)^2 / sum_f c_wf ],  e_f = v_f - u_w - b_w
 *
 * so that they never drive the fluid and the implicit solve stays one with a symmetric
 * matrix.  What is added here to the law: -c_wf s_w on f and the opposite on w, with the
 * slip s_w = u_w - v_w.  Of a wall that turns omega x sum_f c_wf (x_f - x_w) / sum_f c_wf
 * is added to v_w: fluid that turns with it does not slip.  Checked in tests/physics/face.c. */
#include "eval/face.h"

#include "base/status.h"
#include "base/threads.h"
#include "space/record.h"

#include <string.h>

static const int sticky[] = { KIND_WALL, KIND_SKIN };
#if DIM == 2
static const int place_at[DIM] = { RECORD_X, RECORD_X + 1 };
static const int velocity_at[DIM] = { RECORD_V, RECORD_V + 1 };
#else
static const int place_at[DIM] = { RECORD_X, RECORD_X + 1, RECORD_Z };
static const int velocity_at[DIM] = { RECORD_V, RECORD_V + 1, RECORD_VZ };
#endif

/* --- slip and forces ----------------------------------------------------------- */

/* Of this thread's places. */
static void read_part(const struct moment *m, const int at[DIM], double *to)
{
    const struct threads_part part = threads_part(m->list->listed + 1);
    const double *record = m->work->record;

    for (int s = part.from; s < part.to; s++)
        for (int d = 0; d < DIM; d++)
            to[(size_t)s * COUPLE_STRIDE + (size_t)d] = record[(size_t)s * RECORD + (size_t)at[d]];
}

/* Vectors of all particles that stand at these positions of the records. */
static void read_records(const struct moment *m, const int at[DIM], double *to)
{
    THREADS(m->list->listed >= 4096, read_part(m, at, to));
}

/* How far the fluid before solids is from them; places stand in o->slip for a while. */
static void find_arms(const struct moment *m, const struct couple_job *job)
{
    const struct face *o = m->face;

    if (!o->arm)
        return;
    read_records(m, place_at, o->slip);
    m->plan->engine->couple->multiply(job, KIND_STICKY, o->slip, o->arm);
}

/* Fluid that turns with the solid in place s does not slip: C_w times the slip that its
 * velocity seems to be. */
static void turning(const struct moment *m, const struct list *l, int s, double *to)
{
    const double omega = m->particles->object[m->particles->object_of[l->order[s]]].omega;
    const double *arm = m->face->arm + (size_t)s * DIM;

    memset(to, 0, DIM * sizeof *to);
    to[0] = -omega * arm[DIM - 1];
    to[DIM - 1] = omega * arm[0];
}

static const double *slide_of(const struct moment *m, const struct list *l, int slot)
{
    return m->particles->object[m->particles->object_of[l->order[slot]]].slide;
}

/* Slip of solids by the law's forces on them, and their part C_w s_w of o->f.  A solid
 * without fluid near has none. */
static void find_slip(const struct moment *m, const struct couple_job *job, bool walls,
                      const double *law)
{
    const struct face *o = m->face;
    const struct list *l = job->list;

    for (int i = 0; i < 2; i++)
        for (int s = l->start[sticky[i]]; s < l->start[sticky[i] + 1]; s++) {
            const double *b = slide_of(m, l, s), all = job->diagonal[s];
            double turn[DIM] = { 0 };
            if (walls && o->arm)
                turning(m, l, s, turn);
            for (int d = 0; d < DIM; d++) {
                const size_t k = (size_t)s * DIM + (size_t)d;
                double *slip = &o->slip[(size_t)s * COUPLE_STRIDE + (size_t)d];
                *slip = o->of->mirrored && all > 0 ? (law[k] - turn[d]) / all : 0;
                *slip -= walls ? (o->of->mirrored ? 2 : 1) * b[d] : 0;
                o->f[k] = all * *slip;
            }
        }
    for (int i = 0; i < 2; i++)
        for (int s = l->image[sticky[i]]; s < l->image[sticky[i] + 1]; s++)
            memcpy(o->slip + (size_t)s * COUPLE_STRIDE,
                   o->slip + (size_t)l->slot[l->order[s]] * COUPLE_STRIDE, DIM * sizeof(double));
}

/* Forces on the fluid, with the sign turned: the sum of c_wf s_w. */
static void hold(const struct moment *m, const struct couple_job *job)
{
    struct face *o = m->face;
    const struct list *l = job->list;

    memset(o->slip, 0, (size_t)l->start[KIND_FLUID + 1] * COUPLE_STRIDE * sizeof *o->slip);
    memset(o->slip + (size_t)l->listed * COUPLE_STRIDE, 0, COUPLE_STRIDE * sizeof *o->slip);
    m->plan->engine->couple->multiply(job, KIND_BIT(KIND_FLUID), o->slip, o->f);
}

static int fit(struct face *o, const struct list *l)
{
    TRY(face_fit_slots(o, l));
    return face_fit_pairs(o, l);
}

int face_find(struct moment *m)
{
    struct face *o = m->face;
    const struct couple_engine *couple = m->plan->engine->couple;

    o->job.list = m->list;
    TRY(moment_agree(m, fit(o, m->list)));
    read_records(m, velocity_at, o->velocity);
    couple->assemble(&o->job, m->work->record, o->velocity, o->law);
    find_arms(m, &o->job);
    find_slip(m, &o->job, true, o->law);
    hold(m, &o->job);
    return STATUS_DONE;
}

void face_push(const struct moment *m, double (*push)[DIM])
{
    for (int s = 0; s < m->list->start[KIND_FLUID + 1]; s++) {
        const int c = m->list->order[s];
        for (int d = 0; d < DIM; d++)
            push[c][d] -= m->face->f[(size_t)s * DIM + (size_t)d] / m->particles->m[c];
    }
}

/* --- books --------------------------------------------------------------------- */

/* Where forces of the viscosity are summed. */
static double *forces_of(const struct moment *m, const struct rates_job *job)
{
    return job->apart && m->plan->face->part == m->plan->stiff ? job->apart : m->work->f;
}

/* v . f of the fluid in place s, velocities as struct sum_job's look ahead has them;
 * adds the forces. */
static double add_to_fluid(const struct moment *m, const struct rates_job *job, int s)
{
    const struct face *o = m->face;
    const int c = m->list->order[s];
    double power = 0;

    for (int d = 0; d < DIM; d++) {
        double *f = &forces_of(m, job)[(size_t)s * DIM + (size_t)d];
        const double more = -o->f[(size_t)s * DIM + (size_t)d];
        double v = o->velocity[(size_t)s * COUPLE_STRIDE + (size_t)d];
        if (job->push)
            v += job->ahead * (*f / m->particles->m[c] + job->push[c][d]);
        power += v * more;
        *f += more;
    }
    return power;
}

/* Of this thread's blocks. */
static void add_to_part(const struct moment *m, const struct rates_job *job, int blocks)
{
    const struct threads_part part = threads_part(blocks);
    const int n = m->list->start[KIND_FLUID + 1];
    const struct face *o = m->face;

    for (int k = part.from; k < part.to; k++) {
        const int to = (k + 1) * FACE_BLOCK < n ? (k + 1) * FACE_BLOCK : n;
        o->partial[k] = 0;
        for (int s = k * FACE_BLOCK; s < to; s++)
            if (o->job.firm[s] > 0)
                o->partial[k] += add_to_fluid(m, job, s);
    }
}

/* The same bits on any number of threads. */
static double add_to_fluids(const struct moment *m, const struct rates_job *job)
{
    const int n = m->list->start[KIND_FLUID + 1], blocks = (n + FACE_BLOCK - 1) / FACE_BLOCK;
    const struct face *o = m->face;
    double sum = 0;

    THREADS(blocks > 8, add_to_part(m, job, blocks));
    for (int k = 0; k < blocks; k++)
        sum += o->partial[k];
    return sum;
}

/* u . f of solids; what pulls at a face that slides is the law's force and this. */
static double add_to_solids(const struct moment *m, const struct rates_job *job)
{
    const struct list *l = m->list;
    struct face *o = m->face;
    double *f = forces_of(m, job), sum = 0;

    for (int i = 0; i < 2; i++)
        for (int s = l->start[sticky[i]]; s < l->start[sticky[i] + 1]; s++) {
            const double *b = slide_of(m, l, s), *u = o->velocity + (size_t)s * COUPLE_STRIDE;
            for (int d = 0; d < DIM; d++) {
                const size_t k = (size_t)s * DIM + (size_t)d;
                f[k] += o->f[k];
                sum += u[d] * o->f[k];
                o->power += b[d] * (o->law[k] + o->f[k]);
            }
        }
    return sum + o->power;
}

void face_add(struct moment *m, const struct rates_job *job)
{
    double power = add_to_fluids(m, job);

    power += add_to_solids(m, job);
    m->work->power[m->face->of->part->slot] += power;
}

/* --- in a solve ---------------------------------------------------------------- */

/* "All fluid alike" meets twice the law's coefficients with solids at rest. */
int face_ready(struct moment *m, const struct couple_job *law)
{
    struct couple_job job = *law;

    TRY(moment_agree(m, face_fit_slots(m->face, law->list)));
    job.acts = m->face->of->acts;
    find_arms(m, &job);
    for (int s = 0; s < law->list->start[KINDS] && m->face->of->mirrored; s++)
        law->firm[s] *= 2;
    return STATUS_DONE;
}

void face_complete(struct moment *m, const struct couple_job *law, unsigned kinds, bool walls,
                   double *f)
{
    const struct list *l = law->list;
    struct face *o = m->face;
    struct couple_job job = *law;

    job.acts = o->of->acts;
    find_slip(m, &job, walls, f);
    for (int i = 0; i < 2; i++)
        for (int k = l->start[sticky[i]] * DIM; k < l->start[sticky[i] + 1] * DIM; k++)
            f[k] += o->f[k];
    if (!(kinds & KIND_BIT(KIND_FLUID)))
        return;
    hold(m, &job);
    for (int k = 0; k < l->start[KIND_FLUID + 1] * DIM; k++)
        f[k] -= o->f[k];
}

double face_power(struct moment *m)
{
    const struct list *l = m->list;

    m->face->power = 0;
    for (int i = 0; i < 2; i++)
        for (int s = l->start[sticky[i]]; s < l->start[sticky[i] + 1]; s++) {
            const double *b = slide_of(m, l, s);
            for (int d = 0; d < DIM; d++)
                m->face->power += b[d] * m->work->f[(size_t)s * DIM + (size_t)d];
        }
    return m->face->power;
}
