/* program.h -- runs another program as a child of its own, without a shell. */
#ifndef OUTPUT_PROGRAM_H
#define OUTPUT_PROGRAM_H

#include "output/aside.h"

#include <stdbool.h>

/* The first NAME in PATH, into to [ASIDE_PATH].  Places that depend on where we are do not count:
 * what is called so in a run's directory need not be it. */
bool program_find(const char *name, char *to);

/* Runs words[0], found so, in a directory and waits for it; what it has to say goes to the file log
 * there.  0; ENOENT: there is no such program; another errno: it cannot be started; -1: it ended
 * badly. */
int program_run(const char *directory, char *const *words, const char *log);

#endif
