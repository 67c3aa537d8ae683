/* columns.c -- the columns of book.csv: name, unit and place in a sheet in one row. */
#include "book/book.h"
#include "plan/solver.h"

#include <stdio.h>
#include <string.h>

/* In 2D everything that has mass is per metre of depth. */
#if DIM == 2
#define UNIT(whole) whole "/m"
#else
#define UNIT(whole) whole
#endif
#define AT(member) offsetof(struct book_sheet, member)

static const struct book_column stored[] = {
    { "kinetic", UNIT("J"), AT(energy.kinetic) },
    { "potential", UNIT("J"), AT(energy.potential) },
    { "internal", UNIT("J"), AT(energy.internal) },
    { "elastic", UNIT("J"), AT(energy.elastic) },
};

static const struct book_column sums[] = {
    { "pressure_defect", UNIT("J"), AT(pressure_defect) },
    { "total", UNIT("J"), AT(total) },
    { "defect", UNIT("J"), AT(defect) },
    { "mass", UNIT("kg"), AT(mass) },
    { "momentum_x", UNIT("kg m/s"), AT(momentum[0]) },
    { "momentum_y", UNIT("kg m/s"), AT(momentum[1]) },
#if DIM == 3
    { "momentum_z", UNIT("kg m/s"), AT(momentum[2]) },
#endif
};

/* In the order in which read_works() of sheet.c finds them. */
int book_work_names(const struct plan *p, char (*name)[BOOK_NAME])
{
    int n = 0;

    for (int i = 0; i < p->parts; i++)
        if (p->part[i].slot >= 0 && !part_conserves(p->part[i].part))
            snprintf(name[n++], BOOK_NAME, "%s", p->part[i].part->name);
    snprintf(name[n++], BOOK_NAME, "walls");
    for (int i = 0; i < p->bodies; i++) {
        snprintf(name[n++], BOOK_NAME, "%.60s.damping", p->body[i].name);
        snprintf(name[n++], BOOK_NAME, "%.60s.load", p->body[i].name);
    }
    for (int i = 0; i < p->contacts.columns; i++)
        snprintf(name[n++], BOOK_NAME, "%s", p->contacts.kind->column[i]);
    for (int i = p->book.dissipated; i < p->book.solved; i++)
        snprintf(name[n++], BOOK_NAME, "%s.dissipated", p->pressure->part->name);
    for (int i = 0; i < p->book.solved_works; i++)
        snprintf(name[n++], BOOK_NAME, "%s", plan_solved(p->in.set.method)->work[i]);
    return n;
}

static int list_works(const struct plan *p, struct book_column *to)
{
    char name[BOOK_WORKS][BOOK_NAME];
    const int n = book_work_names(p, name);

    for (int i = 0; i < n; i++) {
        memcpy(to[i].name, name[i], sizeof to[i].name);
        to[i].unit = UNIT("J");
        to[i].at = AT(work) + (size_t)i * sizeof(double);
    }
    return n;
}

int book_columns(const struct plan *p, struct book_column *to)
{
    const int first = sizeof stored / sizeof stored[0], last = sizeof sums / sizeof sums[0];
    int works;

    memcpy(to, stored, sizeof stored);
    works = list_works(p, to + first);
    memcpy(to + first + works, sums, sizeof sums);
    return first + works + last;
}
