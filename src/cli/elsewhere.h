/* elsewhere.h -- where a key of the man page differs in 3D. */
#ifndef CLI_ELSEWHERE_H
#define CLI_ELSEWHERE_H

#include "base/param.h"

enum { ELSEWHERE_LINE = 1200 }; /* length of a line, at most */

/* Reads a file of lines NAME TAB FACTS TAB ABOUT: the keys of 3D, NAME as "GROUP KEY". */
int elsewhere_read(const char *path);

/* Writes to the page in what a key of 2D differs there. */
void elsewhere_show(const char *name, const struct param *r, const char *facts);

/* STATUS_FAILED when a key of 3D was never asked for. */
int elsewhere_check(void);

#endif
