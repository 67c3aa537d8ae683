/* report.c -- run.json: how a run ended and what it took. */
#include "run/inside.h"

#include "base/status.h"
#include "eval/balance.h"
#include "output/aside.h"
#include "output/hash.h"
#include "output/json.h"
#include "ranks/ranks.h"
#include "scene/scene.h"
#include "state/memory.h"

#include <math.h>
#include <string.h>

#ifndef PACKAGE_VERSION
#define PACKAGE_VERSION "unknown"
#endif

static void write_what(struct json *j, const struct run *r, int status, const char *message)
{
    static const char *const words[] = { "done", "failed", "failed", "stopped", "failed" };
    const struct settings *s = plan_settings(r->plan);

    json_text(j, "status", status == RUN_GOES ? "running" : words[status]);
    json_text(j, "message", message);
    json_text(j, "title", s->title);
    json_text(j, "scene", r->path);
    json_text(j, "version", PACKAGE_VERSION);
    json_integer(j, "dimension", DIM);
    json_text(j, "method", r->method->name);
    json_text(j, "table", r->table);
    json_text(j, "norm", s->norm);
    json_number(j, "tol", s->tol);
    json_text(j, "precision", plan_precision(r->plan));
    json_integer(j, "threads", r->team.most);
    json_integer(j, "ranks", ranks_count());
    json_number(j, "t_end", r->past.tally.t);
}

static void write_sizes(struct json *j, const struct run *r)
{
    const struct particles *all = plan_particles(r->plan);

    json_object(j, "particles");
    json_integer(j, "fluid", particles_count(all, KIND_FLUID));
    json_integer(j, "wall", particles_count(all, KIND_WALL) + particles_count(all, KIND_WALL_SLIP));
    json_integer(j, "skin", particles_count(all, KIND_SKIN) + particles_count(all, KIND_SKIN_SLIP));
    json_end(j);
    json_integer(j, "carved", run_carved(r, NULL));
    json_integer(j, "state_size", plan_size(r->plan));
}

static void write_work(struct json *j, const struct run *r)
{
    const struct moment_counts *c = moment_counts(r->moment);

    json_integer(j, "steps", r->past.tally.steps);
    json_integer(j, "rejected", r->past.tally.rejected);
    json_integer(j, "rhs_explicit", c->rhs_explicit);
    json_integer(j, "rhs_implicit", c->rhs_implicit);
    json_integer(j, "solves", c->solves);
    json_integer(j, "pair_passes", c->passes);
    json_integer(j, "operator_products", c->products);
    json_integer(j, "rebuilds", c->rebuilds);
    json_integer(j, "pressure_iterations", c->iterations);
    json_number(j, "pressure_compression", c->iterations ? c->compression : NAN);
    json_number(j, "pressure_gain", c->gain > 0 ? c->gain : NAN);
    json_integer(j, "contact_pairs", c->looked);
    json_integer(j, "contact_segments", c->settled);
    json_number(j, "contact_depth_max", c->deepest);
    json_integer(j, "refused", c->refused);
    json_number(j, "cpu_s", run_cpu() - r->cpu_start);
    json_number(j, "wall_s", run_clock() - r->clock_start);
    json_number(j, "threads_mean", team_mean(&r->team));
    json_number(j, "mean_step", r->past.tally.steps ? r->past.tally.t / r->past.tally.steps : 0);
    json_integer(j, "checkpoints", r->past.checkpoints.written);
    json_integer(j, "checkpoints_by_clock", r->past.checkpoints.by_clock);
    json_object(j, "limited_by");
    json_integer(j, "error", r->past.tally.limited[METHOD_ERROR]);
    json_integer(j, "stability", r->past.tally.limited[METHOD_STABILITY]);
    json_integer(j, "output", r->past.tally.limited[METHOD_OUTPUT]);
    json_end(j);
}

/* How ranks share the work of pairs. */
static void write_balance(struct json *j, const struct run *r)
{
    const struct balance b = balance_told(r->moment);

    json_integer(j, "repartitions", b.cuts);
    json_integer(j, "particles_moved", b.moved);
    json_number(j, "imbalance_before", b.before);
    json_number(j, "imbalance_after", b.after);
}

/* What numbers are to be held against. */
static void write_scales(struct json *j, const struct run *r)
{
    const struct scales *s = plan_scales(r->plan);

    json_number(j, "speed_expected", s->fluid ? plan_speed_expected(r->plan) : NAN);
    json_number(j, "sound", s->fluid ? s->c0 : NAN);
    json_number(j, "rho0", s->fluid ? s->rho0 : NAN);
    json_number(j, "gravity", sqrt(s->g[0] * s->g[0] + s->g[1] * s->g[1] + s->g[2] * s->g[2]));
}

static void write_warnings(struct json *j)
{
    const char *text[STATUS_WARNINGS];
    int n = 0;

    while (n < STATUS_WARNINGS && status_warning(n)) {
        text[n] = status_warning(n);
        n++;
    }
    json_texts(j, "warnings", n, text);
}

static void write_books(struct json *j, const struct run *r, const double *y)
{
    char hash[HASH_TEXT];
    struct observe_sunk sunk;
    size_t size;

    moment_by_id(r->moment, y, r->y);
    size = (size_t)moment_tidy(r->moment, r->y);
    observe_sunk(r->moment, r->past.tally.t, y, &sunk);
    json_integer(j, "escaped", observe_escaped(r->moment, r->past.tally.t, y));
    json_integer(j, "in_solids", sunk.n);
    json_integer(j, "in_solids_max", outputs_sunk(r->outputs)->n);
    json_number(j, "energy_initial", outputs_energy_initial(r->outputs));
    json_number(j, "energy_most", outputs_energy_most(r->outputs));
    json_number(j, "energy_defect", outputs_defect(r->outputs));
    json_number(j, "energy_defect_max", outputs_defect_max(r->outputs));
    json_number(j, "momentum_defect", outputs_momentum_defect(r->outputs));
    json_number(j, "density_min", r->past.tally.density[1] > 0 ? r->past.tally.density[0] : NAN);
    json_number(j, "density_max", r->past.tally.density[1] > 0 ? r->past.tally.density[1] : NAN);
    json_number(j, "speed_max", r->past.tally.density[1] > 0 ? r->past.tally.speed : NAN);
    write_scales(j, r);
    json_integer(j, "peak_rss_kb", (long)(memory_peak() / 1024));
    json_text(j, "state_hash",
              hash_text(hash_bytes(HASH_START, r->y, size * sizeof *y), hash));
}

int run_report(const struct run *r, int status, const char *message, const double *y)
{
    char path[ASIDE_PATH];
    struct json *j;

    TRY(aside_join(path, r->directory, "run.json"));
    TRY(json_open(&j, path));
    write_what(j, r, status, message);
    write_sizes(j, r);
    write_work(j, r);
    write_balance(j, r);
    write_books(j, r, y);
    write_warnings(j);
    return json_close(&j);
}
