/* spread-apart.c -- how far the particles of runs that began alike are apart. */
#include "study/spread-inside.h"

#include "base/status.h"

#include <math.h>

/* A particle beside a side that repeats may stand at the other one. */
static double nearest(double far, double period)
{
    return period > 0 ? far - period * round(far / period) : far;
}

/* Variance over the runs of one coordinate of one particle [m^2]. */
static double variance(const struct bundle *b, int row, int column, double period)
{
    const double first = table_at(&b->table[0], row, column);
    double sum = 0, sum2 = 0;

    for (int i = 1; i < b->runs; i++) {
        const double far = nearest(table_at(&b->table[i], row, column) - first, period);
        sum += far;
        sum2 += far * far;
    }
    return fmax(0, (sum2 - sum * sum / b->runs) / (b->runs - 1));
}

/* Root mean square and largest of all fluid particles [m]. */
static void measure(const struct bundle *b, const struct facts *f, double *rms, double *worst)
{
    static const char *const axes[] = { "x", "y", "z" };
    const int kind = table_column(&b->table[0], "kind");
    double sum = 0;
    long n = 0;

    *worst = 0;
    for (int row = 0; row < b->rows; row++) {
        double one = 0;
        if (table_at(&b->table[0], row, kind) != 0)
            continue;
        for (int d = 0; d < f->dimension; d++)
            one += variance(b, row, table_column(&b->table[0], axes[d]), f->period[d]);
        sum += one;
        *worst = fmax(*worst, sqrt(one));
        n++;
    }
    *rms = n > 0 ? sqrt(sum / n) : NAN;
}

void spread_apart_read(struct spread *s)
{
    struct spread_apart *a = &s->apart;

    a->lost = NAN;
    for (a->n = 0; s->facts.dx > 0 && a->n <= SPREAD_INSIDE_PICTURES; a->n++) {
        const int i = a->n;
        struct bundle b;
        char name[64];
        snprintf(name, sizeof name, "snapshots/%04d.csv", i);
        if (!bundle_read(&b, &s->home, s->member, s->order->runs, name))
            break;
        a->t[i] = s->facts.until * i / SPREAD_INSIDE_PICTURES;
        measure(&b, &s->facts, &a->rms[i], &a->worst[i]);
        bundle_free(&b);
        a->rms[i] /= s->facts.dx;
        a->worst[i] /= s->facts.dx;
        if (isnan(a->lost) && a->rms[i] > s->order->share)
            a->lost = a->t[i];
    }
}

int spread_apart_write(const struct spread *s)
{
    char path[MEMBER_PATH];
    struct aside a;

    TRY(aside_join(path, s->home.directory, "spread-positions.csv"));
    if (s->apart.n == 0) {
        remove(path);
        return STATUS_DONE;
    }
    TRY(aside_open(&a, path));
    fputs("# units: s,spacings,spacings\nt,rms,worst\n", a.to);
    for (int i = 0; i < s->apart.n; i++) {
        fprintf(a.to, "%.10g", s->apart.t[i]);
        table_put(a.to, s->apart.rms[i]);
        table_put(a.to, s->apart.worst[i]);
        fputc('\n', a.to);
    }
    return aside_close(&a);
}
