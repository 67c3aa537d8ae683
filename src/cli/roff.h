/* roff.h -- writes a man page: texts in which nothing is taken for a command. */
#ifndef CLI_ROFF_H
#define CLI_ROFF_H

#include "base/param.h"

#include <stdio.h>

/* n characters, n < 0: all of them. */
void roff_text(FILE *to, const char *text, int n);

void roff_heading(FILE *to, const char *before, const char *title); /* .SS before title */
void roff_paragraph(FILE *to, const char *text);                    /* with a full stop */

/* An entry of a list: its tag, bold, and what stands behind the tag. */
void roff_tag(FILE *to, const char *before, const char *tag, const char *behind);

/* Unit, default, range and words of a key, as they are: for roff_tag(). */
void roff_facts(FILE *to, const struct param *r);

#endif
