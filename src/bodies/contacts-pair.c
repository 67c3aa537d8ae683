/* contacts-pair.c -- two solids that may touch. */
#include "bodies/contacts-pair.h"

#include "base/status.h"
#include "bodies/contacts-together.h"

#include <math.h>
#include <string.h>

static const double half = 0.5; /* of a corner where corners of both bodies meet (CT1) */

static bool is_wall(const struct solid *s)
{
    return isinf(s->mass);
}

/* (RT7) of a face with four corners that many are more than; 1 without clumps. */
static double hardened(const struct solid *a, const struct solid *b)
{
    const double together = fmax(a->together, b->together);

    return together > 4 ? pow(together / 4, 0.4) : 1;
}

static int corners_of(const struct solid *guest, const struct solid *partner)
{
    return core_point(&partner->core) && !core_point(&guest->core) ? 0 : core_corners(&guest->core);
}

/* Two points meet once. */
static int corners_of_second(const struct contacts_pair *p)
{
    return core_point(&p->a->core) || p->b->flat ? 0 : corners_of(p->b, p->a);
}

static int edges_of_second(const struct contacts_pair *p)
{
    return p->b->flat ? 0 : core_edges(&p->b->core);
}

/* Of a corner at a face its own, of balls the reduced one [m]. */
static double curvature(const struct solid *a, const struct solid *b)
{
    if (core_point(&a->core) && core_point(&b->core))
        return 1 / (1 / a->core.ball + 1 / b->core.ball);
    return core_point(&b->core) ? b->core.ball : a->core.ball;
}

/* By Hertz and Mindlin how deep they get follows. */
static void make_of_materials(struct contacts_pair *p, const struct contacts_rub *rub, double mass,
                              double speed)
{
    p->law = touch_materials_law(rub->material, curvature(p->a, p->b), mass, speed,
                                 touch_mixed(rub->restitution, p->a->restitution, p->b->restitution), p->law.mu,
                                 &p->depth);
    p->rate = touch_rate(speed, p->depth) * hardened(p->a, p->b) * touch_materials_along(rub->material);
}

void contacts_pair_make(struct contacts_pair *p, const struct solid *a, const struct solid *b,
                        const struct contacts_rub *rub, bool alone)
{
    const double mass = 1 / (1 / a->mass + 1 / b->mass), speed = fmax(a->speed, b->speed);
    const double balls = a->core.ball + b->core.ball;
    const bool corners = !core_point(&a->core) && !core_point(&b->core);

    p->a = a;
    p->b = b;
    p->depth = fmin(is_wall(b) ? a->depth : fmin(a->depth, b->depth), 0.25 * balls);
    p->law = touch_law(mass, speed, p->depth, touch_mixed(rub->restitution, a->restitution, b->restitution),
                       touch_mixed(rub->friction, a->friction, b->friction));
    p->rate = touch_rate(speed, p->depth) * hardened(a, b);
    if (rub->made)
        make_of_materials(p, rub, mass, speed);
    p->slow = touch_rate(speed, 0.25 * balls);
    p->always = alone ? p->rate : 0;
    p->share = corners && !is_wall(b) ? half : 1;
    p->places = corners_of(a, b) + corners_of_second(p) + core_edges(&a->core) * edges_of_second(p);
}

/* Beyond the face of half a space. */
static bool above(const struct contacts_pair *p, const struct solid_place *b, const double *way, double reach)
{
    for (int k = 0; k < DIM; k++) {
        double height = 0;
        if (isinf(p->b->core.half[k]))
            continue;
        for (int d = 0; d < DIM; d++)
            height += b->R[d][k] * way[d];
        return fabs(height) >= p->b->core.half[k] + reach;
    }
    return false;
}

void contacts_pair_middle(const struct solid *s, const struct solid_place *at, double *to)
{
    solid_space(at, s->middle, to);
    for (int d = 0; d < DIM; d++)
        to[d] += at->x[d];
}

bool contacts_pair_far(const struct contacts_pair *p, const struct contacts_stand *s, double gap)
{
    const double film = fmax(p->a->film, p->b->film) + gap;
    double a[DIM], b[DIM], way[DIM], square = 0;

    solid_space(s->a, p->a->middle, a);
    solid_space(s->b, p->b->middle, b);
    for (int d = 0; d < DIM; d++) {
        way[d] = s->apart[d] + a[d] - b[d];
        square += way[d] * way[d];
    }
    if (p->b->flat)
        return above(p, s->b, way, p->a->around + p->b->core.ball + film);
    const double reach = p->a->around + p->b->around + film;
    return square >= reach * reach;
}

/* Both ways: a as the guest of b, b as that of a. */
static void make_guests(const struct contacts_pair *p, const struct contacts_stand *s,
                        struct contacts_guest guest[2])
{
    double back[DIM];

    for (int d = 0; d < DIM; d++)
        back[d] = -s->apart[d];
    contacts_guest_make(&guest[0], p->a, s->a, p->b, s->b, s->apart);
    contacts_guest_make(&guest[1], p->b, s->b, p->a, s->a, back);
}

/* Of a box with a ball around: how far it reaches along axis k of a frame, turned by R. */
static double along(const struct core *c, const double (*R)[DIM], int k, bool own)
{
    double sum = own ? c->half[k] : 0;

    for (int d = 0; d < DIM && !own; d++)
        sum += fabs(R[k][d]) * c->half[d];
    return sum;
}

/* Is there a face of either that parts them by more than `gap` [m]?  Of boxes only. */
static bool parted(const struct contacts_pair *p, const struct contacts_guest guest[2], double gap)
{
    if (p->b->flat || p->a->core.hull || p->b->core.hull)
        return false;
    for (int i = 0; i < 2; i++) {
        const struct contacts_guest *g = &guest[i];
        const double (*R)[DIM] = (const double (*)[DIM])g->in.R;
        for (int k = 0; k < DIM; k++)
            if (fabs(g->in.x[k]) > along(&g->partner->core, R, k, true)
                                   + along(&g->guest->core, R, k, false) + g->touching + gap)
                return true;
    }
    return false;
}

/* Place i of the pair: which of both is the guest there, and where it touches. */
static int find_spot(const struct contacts_pair *p, const struct contacts_guest guest[2], int i,
                     int *which, struct contacts_spot *to)
{
    const int first = corners_of(p->a, p->b), second = corners_of_second(p);
    const int edges = edges_of_second(p);
    int status = STATUS_DONE;

    *which = i >= first && i < first + second;
    if (i < first + second) {
        status = contacts_corner(&guest[*which], *which ? i - first : i, to);
        to->share = p->share;
    } else {
        contacts_edges(&guest[0], (i - first - second) / edges, (i - first - second) % edges, to);
    }
    return status;
}

/* Those of all places at which they touch; their bends forget elsewhere. */
static int find_spots(const struct contacts_pair *p, const struct contacts_guest guest[2],
                      struct contacts_spots *to)
{
    to->n = 0;
    for (int i = 0; i < p->places; i++) {
        struct contacts_spot *s = &to->spot[to->n];
        TRY(find_spot(p, guest, i, &to->which[to->n], s));
        to->place[to->n] = i;
        to->n += s->depth > 0 && s->share > 0;
    }
    return STATUS_DONE;
}

int contacts_pair_meet(const struct contacts_pair *p, const struct contacts_stand *s,
                       const double *xi, double *xi_rate, struct contacts_spots *room,
                       struct body_push *on_a, struct body_push *on_b, double power[2],
                       double *deepest)
{
    struct contacts_guest guest[2];

    if (contacts_pair_far(p, s, 0))
        return STATUS_DONE;
    make_guests(p, s, guest);
    if (parted(p, guest, 0))
        return STATUS_DONE;
    TRY(find_spots(p, guest, room));
    contacts_together(guest, room);
    for (int i = 0; i < room->n; i++) {
        const int which = room->which[i];
        const long at = (long)room->place[i] * DIM;
        contacts_spot_push(&guest[which], &p->law, &room->spot[i], xi + at, xi_rate + at,
                           which ? on_b : on_a, which ? on_a : on_b, power);
        *deepest = fmax(*deepest, room->spot[i].depth);
    }
    return STATUS_DONE;
}

/* The fastest that points of them come closer, whatever way they are turned. */
static double closing(const struct contacts_pair *p, const struct contacts_stand *s)
{
    double square = 0, spin_a = 0, spin_b = 0;

    for (int d = 0; d < DIM; d++)
        square += (s->a->v[d] - s->b->v[d]) * (s->a->v[d] - s->b->v[d]);
    for (int i = 0; i < TURNING_SPINS; i++) {
        spin_a += s->a->spin[i] * s->a->spin[i];
        spin_b += s->b->spin[i] * s->b->spin[i];
    }
    return sqrt(square) + sqrt(spin_a) * core_reach(&p->a->core)
         + (spin_b > 0 ? sqrt(spin_b) * core_reach(&p->b->core) : 0);
}

double contacts_pair_rate(const struct contacts_pair *p, const struct contacts_stand *s)
{
    const double gap = touch_window(p->slow, closing(p, s));
    struct contacts_guest guest[2];
    double rate = p->always;

    if (contacts_pair_far(p, s, gap))
        return rate;
    make_guests(p, s, guest);
    if (parted(p, guest, gap))
        return rate;
    for (int i = 0; i < p->places; i++) {
        struct contacts_spot spot;
        int which;
        if (find_spot(p, guest, i, &which, &spot) != STATUS_DONE || !(spot.depth > -gap) || !(spot.share > 0))
            continue;
        rate = fmax(rate, fmax(p->rate, touch_coming(spot.depth, contacts_spot_closing(&guest[which], &spot),
                                                     p->depth)));
    }
    return rate;
}

double contacts_pair_depth(const struct contacts_pair *p, const struct contacts_stand *s)
{
    struct contacts_guest guest[2];
    double most = 0;

    if (contacts_pair_far(p, s, 0))
        return 0;
    make_guests(p, s, guest);
    if (!p->b->flat && core_overlaps(&p->b->core, &p->a->core, guest[0].in.x, guest[0].in.R))
        return HUGE_VAL;
    for (int i = 0; i < p->places; i++) {
        struct contacts_spot spot;
        int which;
        if (find_spot(p, guest, i, &which, &spot) != STATUS_DONE)
            return HUGE_VAL;
        most = spot.share > 0 ? fmax(most, spot.depth) : most;
    }
    return most;
}

double contacts_pair_gap(const struct contacts_pair *p, const struct contacts_stand *s, double most)
{
    struct contacts_guest guest[2];
    double least = HUGE_VAL;

    if (contacts_pair_far(p, s, most))
        return HUGE_VAL;
    make_guests(p, s, guest);
    if (parted(p, guest, most))
        return HUGE_VAL;
    for (int i = 0; i < p->places; i++) {
        struct contacts_spot spot;
        int which;
        if (find_spot(p, guest, i, &which, &spot) != STATUS_DONE)
            return -HUGE_VAL;
        least = spot.share > 0 ? fmin(least, -spot.depth) : least;
    }
    return least > most ? HUGE_VAL : least;
}

int contacts_pair_check(const struct contacts_pair *p)
{
    const double most = 0.25 * (p->a->core.ball + p->b->core.ball);

    if (p->depth <= most)
        return STATUS_DONE;
    return status_fail(STATUS_BAD_SCENE, "%s and %s get %g m into each other at %g m/s by Hertz's law, and "
                       "%g m, a quarter of their radii, is the most; set a larger young, or larger "
                       "radii or margins", p->a->path, p->b->path, p->depth,
                       fmax(p->a->speed, p->b->speed), most);
}
