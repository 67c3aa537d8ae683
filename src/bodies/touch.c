/* touch.c -- the law of two surfaces that press and rub at one place.
 *
 *   k = 5/4 m U^2/d_U^(5/2)                                                         (RT1)
 *   N = max(0, k d^(3/2) + c d^(1/4) d'),  c = eta(e) sqrt(k m_c)                   (RT2)
 *   xi' = g (v_t - A(z) max(0, v_t.xi^) xi^) - max(0, 1 - 1/z)/tau xi - kappa n (n.xi),
 *   z = k_t |xi_t|/(mu N),  s = mu N/k_t,  g = s/(s + tau |v_t|)                    (RT3)
 *   F_t = -(k_t xi_t + c_t v_t) min(1, mu N/|k_t xi_t + c_t v_t|)                   (RT4)
 *
 * After Mindlin, for spheres that are made of something, in place of k_t xi_t:
 *   k_t = 8 G* sqrt(R* d),  s = 3/2 mu N/k_t,  z = |xi_t|/s                         (RT8)
 *   mu N (1 - (1 - z)^(3/2)) xi^,  z < 1
 * J. Appl. Mech. 16 (1949) 259-268; Johnson, Contact Mechanics, 1985, 7.2.
 *
 * Hertz, J. reine angew. Math. 92 (1882) 156-171; damping: Tsuji, Tanaka, Ishida, Powder
 * Technology 71 (1992) 239-250; xi is a spring while it sticks (Dupont, Hayward, Armstrong,
 * Altpeter, IEEE Trans. Automatic Control 47 (2002) 787-792), made to bear N -> 0. */
#include "bodies/touch.h"

#include <math.h>

static const double elastic = 0.9; /* share of the grip up to which xi is a spring   */
static const double forget = 200;  /* kappa: of what stands across the surface [1/s] */
static const double wave = 2.7;    /* (RT5)                                          */

const double touch_softest = 0.25;

double touch_softness(double speed, double c0)
{
    return fmin(touch_softest, wave * speed / (c0 + speed));
}

double touch_mixed(double rule, double a, double b)
{
    return !isnan(rule) ? rule : isnan(a) ? b : isnan(b) ? a : sqrt(a * b);
}

struct touch_law touch_law(double mass, double speed, double depth, double restitution, double mu)
{
    const double k = 1.25 * mass * speed * speed / pow(depth, 2.5);

    return (struct touch_law){ .k = k, .along = 1.2 * k * sqrt(depth / 100), .mu = mu,
                               .eta = touch_damping(restitution),
                               .tau = 1 / touch_rate(speed, depth) };
}

/* 1.37 U/d_U of one corner, times 4^(2/5) for the four of a face. */
double touch_rate(double speed, double depth)
{
    return 2.4 * speed / depth;
}

static const double reach = 3, crossed = 0.1; /* (RT6) */

double touch_coming(double overlap, double closing, double depth)
{
    const double speed = overlap > 0 ? fabs(closing) : fmax(0, closing);

    return reach * speed / (crossed * depth + fmax(0, -overlap));
}

double touch_window(double rate, double closing)
{
    return reach * closing / rate;
}

static double push(double eta, double x, double v)
{
    return x > 0 ? fmax(0, x * sqrt(x) + eta * sqrt(sqrt(x)) * v) : 0;
}

/* Speed after an impact with speed 1, mass 1, k 1, by the midpoint rule. */
static double rebound(double eta)
{
    const double h = 5e-4;
    double x = 0, v = 1;

    for (int i = 0; i < 40000 && (x > 0 || v > 0); i++) {
        const double vm = v - 0.5 * h * push(eta, x, v), xm = x + 0.5 * h * v;
        v -= h * push(eta, xm, vm);
        x += h * vm;
    }
    return -v;
}

static double find_damping(double restitution)
{
    double low = 0, high = 4;

    for (int i = 0; i < 40; i++) {
        const double middle = 0.5 * (low + high);
        *(rebound(middle) > restitution ? &low : &high) = middle;
    }
    return 0.5 * (low + high);
}

/* The last one is remembered: a search takes milliseconds, and thousands of pairs ask for the same. */
double touch_damping(double restitution)
{
    static _Thread_local double of = 1, found = 0;

    if (restitution >= 1)
        return 0;
    if (restitution != of) {
        found = find_damping(restitution);
        of = restitution;
    }
    return found;
}

static double dot(const double *a, const double *b)
{
    double sum = 0;

    for (int d = 0; d < DIM; d++)
        sum += a[d] * b[d];
    return sum;
}

/* What v has along the surface; returns its length. */
static double flatten(const double *v, const double *normal, double *to)
{
    const double across = dot(v, normal);

    for (int d = 0; d < DIM; d++)
        to[d] = v[d] - across * normal[d];
    return sqrt(dot(to, to));
}

static double smooth(double x)
{
    const double c = fmin(1, fmax(0, x));

    return c * c * (3 - 2 * c);
}

/* mu N by s: how far it bends until all slides, as if the spring were a straight one. */
static double secant(const struct touch_law *law, double depth)
{
    return law->shear > 0 ? law->shear * sqrt(depth) / 1.5 : law->along;
}

/* Force of the spring by its length. */
static double spring(const struct touch_law *law, double along, double grip, double length)
{
    const double z = fmin(1, along * length / grip);

    if (!(law->shear > 0))
        return along;
    return z > 0 ? grip * (1 - (1 - z) * sqrt(1 - z)) / length : 1.5 * along;
}

static void bend(const struct touch_law *law, const struct touch_place *at, double grip,
                 const double *xi, double *rate)
{
    const double along = secant(law, at->depth);
    double vt[DIM], bent[DIM];
    const double speed = flatten(at->velocity, at->normal, vt);
    const double length = flatten(xi, at->normal, bent), across = dot(xi, at->normal);
    const double zeta = along * length / grip, s = grip / along;
    const double follow = s / (s + law->tau * speed);
    const double slip = length > 0 ? smooth((zeta - elastic) / (1 - elastic))
                                         * fmax(0, dot(vt, bent)) / (length * length) : 0;
    const double slack = zeta > 1 ? (1 - 1 / zeta) / law->tau : 0;

    for (int d = 0; d < DIM; d++)
        rate[d] = follow * (vt[d] - slip * bent[d]) - slack * xi[d]
                - forget * across * at->normal[d];
}

void touch_forget(const double *xi, double *xi_rate)
{
    for (int i = 0; i < DIM; i++)
        xi_rate[i] = -forget * xi[i];
}

void touch(const struct touch_law *law, const struct touch_place *at, const double *xi,
           double *press, double *rub, double *xi_rate)
{
    const double d = fmax(0, at->depth), c = law->eta * sqrt(law->k * at->carried);
    const double N = d > 0 ? fmax(0, law->k * d * sqrt(d) + c * sqrt(sqrt(d)) * at->rate) : 0;
    const double grip = law->mu * N, along = secant(law, d);
    const double damp = 0.4 * sqrt(along * at->mass);
    double bent[DIM], vt[DIM];

    for (int i = 0; i < DIM; i++) {
        press[i] = N * at->normal[i];
        rub[i] = 0;
    }
    touch_forget(xi, xi_rate);
    if (!(grip > 0))
        return;
    const double hold = spring(law, along, grip, flatten(xi, at->normal, bent));
    flatten(at->velocity, at->normal, vt);
    for (int i = 0; i < DIM; i++)
        rub[i] = -(hold * bent[i] + damp * vt[i]);
    const double most = sqrt(dot(rub, rub));
    for (int i = 0; i < DIM; i++)
        rub[i] *= most > grip ? grip / most : 1;
    bend(law, at, grip, xi, xi_rate);
}
