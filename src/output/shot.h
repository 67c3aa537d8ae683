/* shot.h -- one snapshot of a run, snapshots/0003.csv, read back. */
#ifndef OUTPUT_SHOT_H
#define OUTPUT_SHOT_H

#include <stdbool.h>
#include <stddef.h>

/* Values of `kind', as in space/kinds.h: between them are walls, from the latter on skins. */
enum { SHOT_FLUID = 0, SHOT_SKIN = 3 };

struct shot {
    char *text;           /* the file                                        */
    size_t head;          /* bytes of its lines before the first row         */
    int n;                /* rows: particles                                 */
    size_t *line;         /* [n + 1] where each begins                       */
    float (*x)[3];        /* [n] position, in the plane with z = 0 [m]       */
    float *speed, *p;     /* [n] [m/s], [Pa]                                 */
    unsigned char *dye, *kind; /* [n] */
};

/* STATUS_IO when a row is not whole.  shot_free() it, also then. */
int shot_read(struct shot *s, const char *path, int dim);
void shot_free(struct shot *s);

bool shot_is_wall(const struct shot *s, int i);

/* A file as text, ending with 0; NULL and a failure kept when it cannot be read. */
char *shot_text(const char *path);

/* n numbers with commas between, from *at on, which is moved behind them and the end of the line. */
int shot_numbers(const char **at, double *to, int n);

#endif
