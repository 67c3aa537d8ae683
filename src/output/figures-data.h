/* figures-data.h -- constants of figures as data: read, checked and written anew, never run. */
#ifndef OUTPUT_FIGURES_DATA_H
#define OUTPUT_FIGURES_DATA_H

#include <stdbool.h>
#include <stdio.h>

/* NAME = VALUE, for gnuplot; what is not finite becomes NaN. */
void figures_data_number(FILE *to, const char *name, double value);

/* NAME = "TEXT", for gnuplot.  All but letters, digits and a few signs are written as octal
 * numbers, so that no text can be anything else than a text. */
void figures_data_text(FILE *to, const char *name, const char *text);

/* Copies a file of such lines, comments left out.  STATUS_IO: it cannot be read or written, or
 * holds a line that neither of the two above writes. */
int figures_data_copy(const char *from, const char *to);

/* A line NAME = NUMBER of such a file; NAN: there is none. */
double figures_data_constant(const char *path, const char *name);

/* Word i = 0, 1, ... of a line NAME = "TEXT", cut to size; false: there is none. */
bool figures_data_word(const char *path, const char *name, int i, char *to, size_t size);

#endif
