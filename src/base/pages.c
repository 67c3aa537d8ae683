/* pages.c -- how much memory there is for an array of which some entries alone are written. */
#include "base/pages.h"

#include <stdbool.h>
#include <stdlib.h>
#include <unistd.h>

struct pages {
    size_t bytes; /* of one           */
    bool *here;   /* [pages] written? */
};

/* Returns how many were not there yet. */
static long write_entry(struct pages *p, long entry, size_t size)
{
    const size_t first = (size_t)entry * size / p->bytes, last = ((size_t)entry + 1) * size - 1;
    long more = 0;

    for (size_t i = first; i <= last / p->bytes; i++) {
        more += !p->here[i];
        p->here[i] = true;
    }
    return more;
}

static long last_entry(long from, long n, const int *row)
{
    long last = from;

    for (long i = 0; i < n; i++)
        last = row[i] > last ? row[i] : last;
    return last;
}

double pages_bytes(long from, long n, const int *row, size_t size)
{
    const long page = sysconf(_SC_PAGESIZE);
    struct pages p = { .bytes = page > 0 ? (size_t)page : 4096 };
    long pages = 0;

    p.here = calloc((size_t)(last_entry(from, n, row) + 1) * size / p.bytes + 1, sizeof *p.here);
    if (!p.here)
        return (double)from * (double)size + (double)n * (double)p.bytes;
    for (long i = 0; i < from; i++)
        pages += write_entry(&p, i, size);
    for (long i = 0; i < n; i++)
        pages += write_entry(&p, row[i], size);
    free(p.here);
    return (double)pages * (double)p.bytes;
}
