/* book-rows.c -- where the quadratures of the book stand in y. */
#include "plan/inside.h"
#include "plan/solver.h"

#include "base/status.h"

/* Is there a body force beside the weight? */
static bool pulls(const struct plan *p)
{
    for (int i = 0; i < p->parts; i++)
        if (p->part[i].part->as.force && !p->part[i].part->as.force->weight)
            return true;
    return false;
}

int plan_book_rows(struct plan *p)
{
    const struct plan_solved *solved = plan_solved(p->in.set.method);
    struct plan_book *b = &p->book;

    b->work = 0;
    b->walls = b->work + p->slots;
    b->damping = b->walls + 1;
    b->driven = b->damping + p->bodies;
    b->impulse = b->driven + p->bodies;
    b->support = b->impulse + (p->particles->objects + p->book.panels) * DIM;
    b->applied = b->support + p->bodies * DIM;
    b->pull = b->applied + p->bodies * DIM;
    b->contacts = b->pull + (pulls(p) ? DIM : 0);
    b->dissipated = b->contacts + p->contacts.columns;
    b->solved = b->dissipated + (plan_ahead(p) > 0 ? 1 : 0);
    while (solved && b->solved_works < PLAN_SOLVED_WORKS && solved->work[b->solved_works])
        b->solved_works++;
    b->n = b->solved + b->solved_works;
    b->row = layout_add(&p->layout, LAYOUT_OTHER, "book", "J", b->n, 1, 0);
    return b->row < 0 ? STATUS_FAILED : STATUS_DONE;
}
