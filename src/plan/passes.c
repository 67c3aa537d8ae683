/* passes.c -- the passes of a plan: the lines of the table that are present in it, with
 * what its parts read. */
#include "plan/inside.h"

#include "base/status.h"
#include "space/laws.h"

#include <stdio.h>

/* What an evaluation leaves behind. */
static const unsigned results = PASS_POSITION_RATE | PASS_ACCELERATION | PASS_DENSITY_RATE
                                | PASS_SOLID_FORCE | PASS_BODY_RATES | PASS_BOOK | PASS_HALF_BOOK;

/* Fields that rows of a pair ask for, by NEED_ bits; masses never change. */
static unsigned fields_of(unsigned rows)
{
    unsigned fields = PASS_POSITION | PASS_MOTION;

    if (rows & (NEED_V | NEED_XV))
        fields |= PASS_VELOCITY;
    if (rows & (NEED_RHO | NEED_IRHO | NEED_P2))
        fields |= PASS_DENSITY | PASS_SOLID_DENSITY;
    if (rows & NEED_P2)
        fields |= PASS_PRESSURE | PASS_SOLID_PRESSURE;
    return fields;
}

/* Fields of these kinds (bits) that a sum over pairs gives. */
static unsigned given_by(const struct plan_field *f)
{
    const bool solid = f->meets[KIND_WALL] | f->meets[KIND_WALL_SLIP] | f->meets[KIND_SKIN]
                       | f->meets[KIND_SKIN_SLIP];
    unsigned fields = solid ? PASS_SOLID_DENSITY | PASS_SOLID_PRESSURE : 0;

    if (f->part->part->as.summed->carry)
        return PASS_DRIFT;
    return f->meets[KIND_FLUID] ? fields | PASS_DENSITY | PASS_PRESSURE : fields;
}

/* A sum reads of its owners what it reads of neighbours; solids that it gives a density to
 * have none before. */
static struct plan_pass of_field(const struct pass *pass, const struct plan_field *f)
{
    const unsigned provides = given_by(f);
    const unsigned reads = fields_of(f->part->part->as.summed->rows) & ~provides;
    unsigned owners = 0, partners = 0;

    for (int k = 0; k < KINDS; k++) {
        owners |= f->meets[k] ? KIND_BIT(k) : 0;
        partners |= f->meets[k];
    }
    return (struct plan_pass){ .pass = pass, .name = f->part->path, .of = f,
                               .needs = pass->needs | (reads & passes_of_kinds(owners)),
                               .neighbours = pass->neighbours
                                             | (reads & passes_of_kinds(partners)),
                               .provides = pass->provides | provides, .adds = pass->adds };
}

/* Laws read of both sides what their rows ask for. */
static unsigned read_by_laws(const struct plan *p, bool with_pressure)
{
    unsigned fields = 0;

    for (int i = 0; i < p->parts; i++) {
        const struct part *part = p->part[i].part;
        if (part->as.law && (with_pressure || !(part->needs & FIELD_PRESSURE)))
            fields |= fields_of(part->as.law->rows);
    }
    return fields;
}

static unsigned read_by_faces(const struct plan *p)
{
    return p->face ? fields_of(p->face->part->part->as.law->rows) : 0;
}

static unsigned there(const struct plan *p)
{
    unsigned kinds = 0;

    for (int k = 0; k < KINDS; k++)
        kinds |= particles_count(p->particles, k) > 0 ? KIND_BIT(k) : 0;
    return passes_of_kinds(kinds);
}

static struct plan_pass of_table(const struct plan *p, const struct pass *pass)
{
    struct plan_pass one = { .pass = pass, .name = pass->name, .needs = pass->needs,
                             .neighbours = pass->neighbours, .provides = pass->provides,
                             .adds = pass->adds };
    unsigned reads = 0;

    if (pass->provides & (PASS_FORCE | PASS_OTHERS))
        reads = read_by_laws(p, pass->provides & PASS_FORCE);
    if (pass->provides & PASS_SLIP)
        reads = read_by_faces(p);
    one.needs |= reads;
    one.neighbours |= reads;
    if (p->row.x < 0) { /* walls alone wait for nothing that water would bring */
        one.needs &= there(p);
        one.neighbours &= there(p);
    }
    return one;
}

static unsigned summed_fields(const struct plan *p)
{
    unsigned fields = 0;

    for (int i = 0; i < p->passes.fields; i++)
        fields |= given_by(&p->passes.field[i]);
    return fields;
}

static int add(struct plan_passes *to, struct plan_pass one)
{
    if (to->n == PLAN_PASSES)
        return status_fail(STATUS_FAILED, "more than %d passes in an evaluation", PLAN_PASSES);
    to->pass[to->n++] = one;
    return STATUS_DONE;
}

static int add_line(struct plan *p, const struct pass *line)
{
    struct plan_passes *to = &p->passes;

    if (line->present && !line->present(p))
        return STATUS_DONE;
    if (line->kind != PASS_EACH_SUM)
        return add(to, of_table(p, line));
    for (int i = 0; i < to->fields; i++)
        TRY(add(to, of_field(line, &to->field[i])));
    return STATUS_DONE;
}

/* Densities that are no sums are rows of y or those at rest; with them there is a pressure
 * as soon as there are records, but for solids that have a pass of their own for both.  Those that are sums are results: limits and outputs look at
 * them, though no law may. */
int passes_make(struct plan *p, const struct pass *table)
{
    const unsigned summed = summed_fields(p);
    const unsigned pressed = p->passes.press ? PASS_SOLID_DENSITY | PASS_SOLID_PRESSURE : 0;
    const unsigned densities = (PASS_DENSITY | PASS_SOLID_DENSITY) & ~summed;
    const unsigned idle = (p->particles->n > 0 ? 0 : PASS_FORCE | PASS_POWER | PASS_ACCELERATION)
                          | (p->bodies > 0 ? 0 : PASS_BODY_RATES);
    struct plan_passes *to = &p->passes;

    to->n = 0;
    for (const struct pass *line = table; line->name; line++)
        TRY(add_line(p, line));
    for (int i = 0; i < to->n; i++)
        if (to->pass[i].provides & PASS_RECORDS) {
            to->pass[i].provides &= ~(summed | pressed);
            to->pass[i].needs |= densities;
        }
    to->n = passes_order(to->pass, to->n, PASS_POSITION | PASS_VELOCITY | idle
                                                  | (densities & ~pressed),
                         results | (summed & (PASS_DENSITY | PASS_SOLID_DENSITY)));
    return to->n < 0 ? STATUS_FAILED : STATUS_DONE;
}

/* What a neighbour has to bring, be it fluid or solid, in one word. */
static unsigned one_word(unsigned fields)
{
    const unsigned solid = (fields & PASS_POSITION ? PASS_MOTION : 0)
                           | (fields & PASS_DENSITY ? PASS_SOLID_DENSITY : 0)
                           | (fields & PASS_PRESSURE ? PASS_SOLID_PRESSURE : 0);

    return fields & ~solid;
}

void plan_pass_show(const struct plan *p, int i, struct plan_pass_show *out)
{
    static const char *const over[] = {
        [PASS_POINTWISE] = "points", [PASS_OVER_PAIRS] = "pairs", [PASS_SOLVE] = "solve",
        [PASS_BODIES] = "bodies", [PASS_EACH_SUM] = "pairs",
    };
    const struct plan_pass *one = &p->passes.pass[i];

    out->name = one->name;
    out->over = over[one->pass->kind];
    passes_names(one->provides & there(p), out->provides, sizeof out->provides);
    passes_names(one->adds & there(p), out->adds, sizeof out->adds);
    passes_names(one_word(one->neighbours) & there(p), out->neighbours, sizeof out->neighbours);
}

bool plan_pass_field(const struct plan *p, int i, struct plan_pass_field *out)
{
    unsigned used = 0;

    for (int k = 0; k < p->passes.n; k++)
        used |= p->passes.pass[k].provides | p->passes.pass[k].needs | p->passes.pass[k].neighbours;
    passes_field(i, &out->name, &out->unit, &out->width);
    return (used & there(p)) & (1u << i);
}

int plan_passes(const struct plan *p)
{
    return p->passes.n;
}
