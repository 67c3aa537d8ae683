/* record-pack.c -- records of places, four at a time where the machine has room for that. */
#include "space/record-pack.h"

#include "base/lanes.h"

#include <math.h>
#include <string.h>

/* Where a row has its position and its velocity.  `some`, a constant: some rows stand beyond. */
struct motion {
    const double *x, *u;
};

LANES_INLINE struct motion motion_of(const struct record_source *of, bool some, int row)
{
    const bool beyond = some && row >= of->beyond.from;
    const size_t at = (size_t)row * DIM;

    return (struct motion){ (beyond ? of->beyond.x : of->x) + at, (beyond ? of->beyond.u : of->u) + at };
}

LANES_INLINE const double *density_of(const struct record_source *of, bool some, int row)
{
    return (some && row >= of->beyond.from ? of->beyond.rho : of->rho) + row;
}

/* One place; inside the box? */
LANES_INLINE bool pack_one(const struct record_source *of, bool some, int s, double rho, double pressure,
                           double *r)
{
    const double irho = 1 / rho, *offset = of->offset ? of->offset[s] : NULL;
    const struct motion at = motion_of(of, some, of->order[s] - of->first);
    const double *x = at.x, *u = at.u;

    r[RECORD_X] = offset ? x[0] + offset[0] : x[0];
    r[RECORD_X + 1] = offset ? x[1] + offset[1] : x[1];
    r[RECORD_V] = u[0];
    r[RECORD_V + 1] = u[1];
#if DIM == 3
    r[RECORD_Z] = offset ? x[2] + offset[2] : x[2];
    r[RECORD_VZ] = u[2];
#endif
    r[RECORD_RHO] = rho;
    r[RECORD_P2] = pressure * irho * irho;
    r[RECORD_M] = of->mass > 0 ? of->mass : of->m[of->order[s]];
    r[RECORD_IRHO] = irho;
    return list_inside(of->def, x);
}

#if DIM == 2 && LANES > 2
typedef double four __attribute__((vector_size(4 * sizeof(double))));
typedef long long four_bits __attribute__((vector_size(4 * sizeof(double))));

static inline four load(const double *from)
{
    four x;

    memcpy(&x, from, sizeof x);
    return x;
}

/* Position and velocity. */
static inline four motion(struct motion of)
{
    typedef double two __attribute__((vector_size(2 * sizeof(double))));
    two a, b;

    memcpy(&a, of.x, sizeof a);
    memcpy(&b, of.u, sizeof b);
    return __builtin_shufflevector(a, b, 0, 1, 2, 3);
}

/* The second halves of four records: their rows in columns. */
static inline void write_rest(four rho, four p2, four m, four irho, double *r)
{
    const four a = __builtin_shufflevector(rho, p2, 0, 4, 2, 6);
    const four b = __builtin_shufflevector(rho, p2, 1, 5, 3, 7);
    const four c = __builtin_shufflevector(m, irho, 0, 4, 2, 6);
    const four d = __builtin_shufflevector(m, irho, 1, 5, 3, 7);
    const four rest[] = {
        __builtin_shufflevector(a, c, 0, 1, 4, 5), __builtin_shufflevector(b, d, 0, 1, 4, 5),
        __builtin_shufflevector(a, c, 2, 3, 6, 7), __builtin_shufflevector(b, d, 2, 3, 6, 7),
    };

    for (int l = 0; l < 4; l++)
        memcpy(r + l * RECORD + RECORD_RHO, &rest[l], sizeof rest[l]);
}

LANES_INLINE four masses(const struct record_source *of, const int *c)
{
    return (four){ of->m[c[0]], of->m[c[1]], of->m[c[2]], of->m[c[3]] };
}

/* Places s..s+3; the bits of what is inside of low..high.  `alike`, a constant: masses are. */
LANES_INLINE four_bits pack_four(const struct record_source *of, bool some, bool alike, int s, four low,
                                 four high, four rho, four pressure, double *r)
{
    const int *c = of->order + s;
    const four irho = 1 / rho;
    four_bits inside = ~(four_bits){ 0 };

    for (int l = 0; l < 4; l++) {
        const four xu = motion(motion_of(of, some, c[l] - of->first));

        inside &= (xu >= low) & (xu <= high);
        memcpy(r + l * RECORD, &xu, sizeof xu);
    }
    const four m = alike ? of->mass - (four){ 0 } : masses(of, c);
    write_rest(rho, pressure * irho * irho, m, irho, r);
    return inside;
}

/* As many as there are whole fours of, none with offsets; returns the place after them. */
LANES_INLINE int pack_fours(const struct record_source *given, bool some, int from, int to,
                            const double *rho, const double *pressure, double *record, bool *inside)
{
    const struct record_source of = *given; /* stays in registers: no record is written to it */
    const double *a = of.def->low, *b = of.def->high;
    const four low = { a[0], a[1], -INFINITY, -INFINITY }, high = { b[0], b[1], INFINITY, INFINITY };
    four_bits all = ~(four_bits){ 0 };
    int s = from;

    for (; s + 4 <= to && !of.offset && of.mass > 0; s += 4)
        all &= pack_four(&of, some, true, s, low, high, load(rho + s - from),
                         load(pressure + s - from), record + (size_t)s * RECORD);
    for (; s + 4 <= to && !of.offset; s += 4)
        all &= pack_four(&of, some, false, s, low, high, load(rho + s - from),
                         load(pressure + s - from), record + (size_t)s * RECORD);
    *inside = all[0] & all[1] & all[2] & all[3];
    return s;
}

/* As many as there are whole fours of; returns the place after them. */
LANES_INLINE int read_fours(const struct record_source *given, bool some, int from, int to, double *rho,
                            bool *good)
{
    const struct record_source of = *given; /* stays in registers */
    const four low = of.bounds[0] - (four){ 0 }, high = of.bounds[1] - (four){ 0 };
    four_bits all = ~(four_bits){ 0 };
    int s = from;

    for (; s + 4 <= to && of.rho; s += 4) {
        const int *c = of.order + s;
        const double *x[4];

        for (int l = 0; l < 4; l++) {
            const struct motion at = motion_of(&of, some, c[l] - of.first);
            __builtin_prefetch(at.x);
            __builtin_prefetch(at.u);
            x[l] = density_of(&of, some, c[l] - of.first);
        }
        const four r = { *x[0], *x[1], *x[2], *x[3] };
        all &= (r >= low) & (r <= high);
        memcpy(rho + s - from, &r, sizeof r);
    }
    *good = all[0] & all[1] & all[2] & all[3];
    return s;
}
#else
static int read_fours(const struct record_source *of, bool some, int from, int to, double *rho, bool *good)
{
    (void)of;
    (void)some;
    (void)to;
    (void)rho;
    *good = true;
    return from;
}

static int pack_fours(const struct record_source *of, bool some, int from, int to, const double *rho,
                      const double *pressure, double *record, bool *inside)
{
    (void)of;
    (void)some;
    (void)to;
    (void)rho;
    (void)pressure;
    (void)record;
    *inside = true;
    return from;
}
#endif

LANES_INLINE bool pack(const struct record_source *of, bool some, int from, int to, const double *rho,
                       const double *pressure, double *record)
{
    bool inside;

    for (int s = pack_fours(of, some, from, to, rho, pressure, record, &inside); s < to; s++)
        inside &= pack_one(of, some, s, rho[s - from], pressure[s - from], record + (size_t)s * RECORD);
    return inside;
}

bool LANE_NAME(record_pack)(const struct record_source *of, int from, int to, const double *rho,
                            const double *pressure, double *record)
{
    return of->beyond.x ? pack(of, true, from, to, rho, pressure, record)
                        : pack(of, false, from, to, rho, pressure, record);
}

LANES_INLINE bool densities(const struct record_source *of, bool some, int from, int to, double *rho)
{
    bool good;

    for (int s = read_fours(of, some, from, to, rho, &good); s < to; s++) {
        const int row = of->order[s] - of->first;
        const struct motion at = motion_of(of, some, row);
        const double r = of->rho ? *density_of(of, some, row) : of->rho0;

        __builtin_prefetch(at.x);
        __builtin_prefetch(at.u);
        good &= (r >= of->bounds[0]) & (r <= of->bounds[1]);
        rho[s - from] = r;
    }
    return good;
}

bool LANE_NAME(record_densities)(const struct record_source *of, int from, int to, double *rho)
{
    return of->beyond.x ? densities(of, true, from, to, rho) : densities(of, false, from, to, rho);
}
