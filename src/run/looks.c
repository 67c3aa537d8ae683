/* looks.c -- the surfaces of rigid bodies, carried along with them. */
#include "run/looks.h"

#include "base/status.h"
#include "bodies/solid.h"
#include "shapes/surface.h"
#include "state/period.h"

#include <math.h>
#include <stdlib.h>

struct looks {
    int bodies;
    int *body, *from;    /* [bodies] number of the body; its first corner, [bodies + 1] */
    struct surface own;  /* of all, each in its own frame                           */
    const char **name;   /* [bodies] lent by the plan                               */
    int *of;             /* [faces] its body 0, 1, ...                              */
    double *x, *u;       /* [corners][DIM] */
    struct cloud_looks shown;
};

static int take_body(struct looks *l, const struct plan *plan, int body)
{
    const int i = l->bodies++;

    l->body[i] = body;
    l->name[i] = plan_body_name(plan, body);
    l->from[i] = l->own.corners;
    TRY(plan_body_look(plan, body, &l->own));
    l->from[i + 1] = l->own.corners;
    return STATUS_DONE;
}

static int take_faces(struct looks *l)
{
    const struct surface *s = &l->own;

    l->of = status_alloc((size_t)s->faces, sizeof *l->of);
    l->x = status_alloc((size_t)s->corners, DIM * sizeof *l->x);
    l->u = status_alloc((size_t)s->corners, DIM * sizeof *l->u);
    if (!l->of || !l->x || !l->u)
        return STATUS_FAILED;
    for (int f = 0, i = 0; f < s->faces; f++) {
        while (s->loop[s->first[f]] >= l->from[i + 1])
            i++;
        l->of[f] = i;
    }
    l->shown = (struct cloud_looks){ .bodies = l->bodies, .corners = s->corners, .faces = s->faces,
                                     .name = l->name, .x = l->x, .u = l->u, .of = l->of,
                                     .first = s->first, .loop = s->loop };
    return STATUS_DONE;
}

static int take(struct looks *l, const struct plan *plan)
{
    const int most = plan_bodies(plan);

    l->body = status_alloc((size_t)most, sizeof *l->body);
    l->from = status_alloc((size_t)most + 1, sizeof *l->from);
    l->name = status_alloc((size_t)most, sizeof *l->name);
    if (!l->body || !l->from || !l->name)
        return STATUS_FAILED;
    for (int i = 0; i < most; i++)
        if (plan_body_rigid(plan, i))
            TRY(take_body(l, plan, i));
    return take_faces(l);
}

int looks_open(struct looks **out, const struct plan *plan)
{
    int rigid = 0, code;

    for (int i = 0; i < plan_bodies(plan); i++)
        rigid += plan_body_rigid(plan, i);
    *out = NULL;
    if (rigid == 0)
        return STATUS_DONE;
    *out = status_alloc(1, sizeof **out);
    code = *out ? take(*out, plan) : STATUS_FAILED;
    if (code != STATUS_DONE)
        looks_close(out);
    return code;
}

double looks_grain(const struct plan *plan)
{
    const struct scales *s = plan_scales(plan);
    double longest = 0;

    for (int d = 0; d < DIM; d++)
        longest = fmax(longest, s->high[d] - s->low[d]);
    return plan_particles(plan)->n > 0 ? s->dx : longest / 200;
}

const struct cloud_looks *looks_known(const struct looks *l)
{
    return l ? &l->shown : NULL;
}

double looks_area(const struct looks *l)
{
    return surface_area(&l->own);
}

/* Corner i of a body that stands there. */
static void carry(struct looks *l, int i, const struct solid_place *at, const double *centre)
{
    double own[DIM], arm[DIM], turned[DIM];

    turning_velocity(at->spin, l->own.x[i], own);
    solid_space(at, l->own.x[i], arm);
    solid_space(at, own, turned);
    for (int d = 0; d < DIM; d++) {
        l->x[i * DIM + d] = centre[d] + arm[d];
        l->u[i * DIM + d] = at->v[d] + turned[d];
    }
}

const struct cloud_looks *looks_at(struct looks *l, const struct moment *moment, const double *y)
{
    if (!l)
        return NULL;
    for (int k = 0; k < l->bodies; k++) {
        struct solid_place at;
        double centre[DIM];
        observe_stand(moment, l->body[k], y, &at);
        period_home(plan_scales(moment_plan(moment)), at.x, centre);
        for (int i = l->from[k]; i < l->from[k + 1]; i++)
            carry(l, i, &at, centre);
    }
    return &l->shown;
}

void looks_close(struct looks **looks)
{
    struct looks *l = *looks;

    if (!l)
        return;
    surface_free(&l->own);
    free(l->body);
    free(l->from);
    free(l->name);
    free(l->of);
    free(l->x);
    free(l->u);
    free(l);
    *looks = NULL;
}
