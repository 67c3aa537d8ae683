/* powers.c -- rates of the quadratures of the book. */
#include "book/book.h"

#include <string.h>

void book_add_load(const struct plan *p, int i, double share, const struct body_load *load,
                   double *book)
{
    const struct plan_book *b = &p->book;

    book[b->damping + i] += share * load->damping;
    book[b->driven + i] += share * load->driven;
    for (int d = 0; d < DIM; d++) {
        book[b->support + i * DIM + d] += share * load->support[d];
        book[b->applied + i * DIM + d] += share * load->applied[d];
    }
}

void book_rates(const struct plan *p, const struct book_powers *of, double *book)
{
    const struct plan_book *b = &p->book;

    memset(book, 0, (size_t)b->n * sizeof *book);
    for (int i = 0; i < p->slots; i++)
        book[b->work + i] = of->work[i];
    book[b->walls] = -of->walls;
    for (int i = 0; i < p->bodies; i++)
        book_add_load(p, i, 1, &of->body[i].load, book);
    for (int i = b->pull; i < b->contacts; i++)
        book[i] = of->pull[i - b->pull];
    for (int i = b->contacts; i < b->dissipated; i++)
        book[i] = of->contacts[i - b->contacts];
    for (int i = b->dissipated; i < b->solved; i++)
        book[i] = of->dissipated[i - b->dissipated];
    for (int o = 0; o < p->particles->objects + p->book.panels; o++)
        for (int d = 0; d < DIM; d++)
            book[b->impulse + o * DIM + d] = of->force[o][d];
}
