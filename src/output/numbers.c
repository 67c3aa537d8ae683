/* numbers.c -- the main numbers of a run, from its files. */
#include "output/numbers.h"

#include "base/status.h"
#include "output/aside.h"
#include "output/force.h"
#include "output/figures-data.h"
#include "output/json-find.h"
#include "output/table.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static const double warned_energy = 0.01; /* as run/doubts.c warns */
static const double warned_mach = 0.15;   /* as `check' warns      */

struct reader {
    struct numbers *to;
    const char *run;
    char path[ASIDE_PATH]; /* of run.json */
    const char *newton, *joule;
};

/* The next row, to be filled. */
static struct numbers_row *add(struct reader *r, const char *what)
{
    struct numbers_row *row = &r->to->row[r->to->n];

    if (r->to->n < NUMBERS_MOST - 1)
        r->to->n++;
    *row = (struct numbers_row){ .wrong = false };
    snprintf(row->what, sizeof row->what, "%s", what);
    return row;
}

#define SAY(member, ...) snprintf(member, sizeof(member), __VA_ARGS__)

static double number(const struct reader *r, const char *key)
{
    return json_find_number(r->path, key);
}

static void add_energy(struct reader *r)
{
    const double defect = number(r, "energy_defect_max"), most = number(r, "energy_most");
    struct numbers_row *row;

    if (!(most > 0))
        return;
    row = add(r, "energy defect");
    SAY(row->value, "%.3g %s at its largest", defect, r->joule);
    SAY(row->against, "%.2g %% of the %.3g %s there were; should be below %g %%",
        100 * defect / most, most, r->joule, 100 * warned_energy);
    row->wrong = !(defect <= warned_energy * most);
}

static void add_speed(struct reader *r)
{
    const double speed = number(r, "speed_max"), sound = number(r, "sound");
    struct numbers_row *row;

    if (!(sound > 0) || isnan(speed))
        return;
    row = add(r, "fastest water");
    SAY(row->value, "%.3g m/s, Mach %.2g", speed, speed / sound);
    SAY(row->against, "%.3g m/s expected; Mach should stay below %g", number(r, "speed_expected"),
        warned_mach);
    row->wrong = speed > warned_mach * sound;
}

static void add_density(struct reader *r)
{
    const double low = number(r, "density_min"), high = number(r, "density_max");
    const double rho0 = number(r, "rho0");
    struct numbers_row *row;

    if (!(rho0 > 0) || isnan(low))
        return;
    row = add(r, "density");
    SAY(row->value, "%+.2g %% to %+.2g %%", 100 * (low / rho0 - 1), 100 * (high / rho0 - 1));
    SAY(row->against, "of rho0 = %g kg/m^3; +%.2g %% is Mach %g squared", rho0,
        100 * warned_mach * warned_mach, warned_mach);
    row->wrong = high > 1.2 * rho0;
}

static void add_leaks(struct reader *r)
{
    const double out = number(r, "escaped"), sunk = number(r, "in_solids_max");
    struct numbers_row *row;

    if (!(number(r, "fluid") > 0))
        return;
    row = add(r, "leaks");
    SAY(row->value, "%.0f particles out of the tank, %.0f in solids at most", out, sunk);
    SAY(row->against, "of %.0f; should be 0", number(r, "fluid"));
    row->wrong = out > 0 || sunk > 0;
}

static bool open_table(const struct reader *r, const char *name, struct table *t)
{
    char path[ASIDE_PATH];

    if (snprintf(path, sizeof path, "%s/%s", r->run, name) >= ASIDE_PATH || !table_read(t, path))
        return false;
    if (t->rows > 1)
        return true;
    table_free(t);
    return false;
}

/* The fastest that a column grows, over a fiftieth of the time of the table or a row. */
static double fastest(const struct table *t, int column)
{
    const double window = force_window(t) * (1 - 1e-9);
    double most = 0;

    for (int i = 1, from = 0; i < t->rows; i++) {
        while (from + 1 < i && table_at(t, i, 0) - table_at(t, from + 1, 0) >= window)
            from++;
        most = fmax(most, (table_at(t, i, column) - table_at(t, from, column))
                          / (table_at(t, i, 0) - table_at(t, from, 0)));
    }
    return most;
}

static void say_front(struct reader *r, const struct table *t, int x)
{
    struct numbers_row *row = add(r, "front");
    int far = 0;

    for (int i = 0; i < t->rows; i++)
        if (table_at(t, i, x) > table_at(t, far, x))
            far = i;
    SAY(row->value, "%.4g m at its furthest, at %.3g s", table_at(t, far, x),
        table_at(t, far, 0));
    SAY(row->against, "%.3g m/s at its fastest, over %.2g s; %.3g m/s expected of the water",
        fastest(t, x), force_window(t), number(r, "speed_expected"));
}

static void add_front(struct reader *r)
{
    struct table t;

    if (!open_table(r, "front.csv", &t))
        return;
    if (table_column(&t, "x") >= 0)
        say_front(r, &t, table_column(&t, "x"));
    table_free(&t);
}

/* Weight of the fluid at the start [N], NAN without any. */
static double weight(const struct reader *r)
{
    const double g = number(r, "gravity");
    struct table t;
    double mass = NAN;

    if (!open_table(r, "book.csv", &t))
        return NAN;
    if (table_column(&t, "mass") >= 0)
        mass = table_at(&t, 0, table_column(&t, "mass"));
    table_free(&t);
    return mass * g;
}

/* Weight of a rigid body [N], 0 when it is none. */
static double own_weight(const struct reader *r, const char *name, size_t length)
{
    char path[ASIDE_PATH], word[80], mass[40];

    if (aside_join(path, r->run, "figures/constants.gp") != STATUS_DONE)
        return 0;
    for (int i = 0; figures_data_word(path, "bodies", i, word, sizeof word); i++)
        if (strlen(word) == length && strncmp(word, name, length) == 0
            && figures_data_word(path, "masses", i, mass, sizeof mass))
            return strtod(mass, NULL) * number(r, "gravity");
    return 0;
}

static void add_force(struct reader *r, const struct table *t, int column, double heavy)
{
    const double window = force_window(t), force = force_peak(t, column, window);
    const char *name = t->name[column];
    const double own = own_weight(r, name, strlen(name) - 3);
    char what[80];
    struct numbers_row *row;

    snprintf(what, sizeof what, "force on %.*s", (int)(strlen(name) - 3), name);
    row = add(r, what);
    SAY(row->value, "%.4g %s at its largest, as a mean over %.2g s", force, r->newton, window);
    if (own > 0)
        SAY(row->against, "%.3g times its own weight, %.3g %s", force / own, own, r->newton);
    else if (heavy > 0)
        SAY(row->against, "%.3g times the weight of the fluid, %.3g %s", force / heavy, heavy,
            r->newton);
}

static void add_forces(struct reader *r)
{
    const double heavy = weight(r);
    struct table t;

    if (!open_table(r, "forces.csv", &t))
        return;
    for (int i = 1; i < t.columns; i++) {
        const size_t n = strlen(t.name[i]);
        if (n > 3 && strcmp(t.name[i] + n - 3, ".ix") == 0)
            add_force(r, &t, i, heavy);
    }
    table_free(&t);
}

static void add_tip(struct reader *r, const struct table *t, int x, int y)
{
    char what[80];
    struct numbers_row *row;
    double most = 0, at = 0;

    for (int i = 0; i < t->rows; i++) {
        const double far = hypot(table_at(t, i, x), table_at(t, i, y));
        if (far > most) {
            most = far;
            at = table_at(t, i, 0);
        }
    }
    snprintf(what, sizeof what, "tip of %.*s", (int)(strlen(t->name[x]) - 6), t->name[x]);
    row = add(r, what);
    SAY(row->value, "%.4g mm displaced at its most, at %.3g s", 1e3 * most, at);
    SAY(row->against, "%.4g mm at the end",
        1e3 * hypot(table_at(t, t->rows - 1, x), table_at(t, t->rows - 1, y)));
}

static void add_tips(struct reader *r)
{
    struct table t;

    if (!open_table(r, "beam.csv", &t))
        return;
    for (int i = 1; i + 1 < t.columns; i++) {
        const size_t n = strlen(t.name[i]);
        if (n > 6 && strcmp(t.name[i] + n - 6, ".tip_x") == 0)
            add_tip(r, &t, i, i + 1);
    }
    table_free(&t);
}

static void add_steps(struct reader *r)
{
    const double steps = number(r, "steps"), rejected = number(r, "rejected");
    struct numbers_row *row = add(r, "steps");

    SAY(row->value, "%.0f, %.0f attempts thrown away", steps, rejected);
    SAY(row->against, "a tenth would point to something violent: see steps.csv");
    row->wrong = rejected > 0.1 * steps;
}

void numbers_read(struct numbers *n, const char *run)
{
    struct reader r = { .to = n, .run = run };
    const bool flat = snprintf(r.path, sizeof r.path, "%s/run.json", run) < ASIDE_PATH
                   && json_find_number(r.path, "dimension") == 2;

    n->n = 0;
    r.newton = flat ? "N/m" : "N";
    r.joule = flat ? "J/m" : "J";
    add_energy(&r);
    add_speed(&r);
    add_density(&r);
    add_leaks(&r);
    add_front(&r);
    add_forces(&r);
    add_tips(&r);
    add_steps(&r);
}

void numbers_print(const struct numbers *n, FILE *to)
{
    for (int i = 0; i < n->n; i++)
        fprintf(to, "%c %-18s %s%s%s\n", n->row[i].wrong ? '!' : ' ', n->row[i].what,
                n->row[i].value, n->row[i].against[0] ? "; " : "", n->row[i].against);
}
