/* figures-record.h -- which files of RUN/figures are ours and as we left them: RUN/figures/.drawn. */
#ifndef OUTPUT_FIGURES_RECORD_H
#define OUTPUT_FIGURES_RECORD_H

#include <stdbool.h>

enum { FIGURES_RECORD_MOST = 1000, FIGURES_RECORD_NAME = 200 };

struct figures_record {
    int n;
    struct {
        char name[FIGURES_RECORD_NAME], hash[40];
    } file[FIGURES_RECORD_MOST];
};

/* Reads DIR/.drawn; without one it is empty. */
void figures_record_read(struct figures_record *r, const char *dir);
int figures_record_write(const struct figures_record *r, const char *dir);

bool figures_record_has(const struct figures_record *r, const char *name);

/* Is DIR/NAME there, and not as it was when it was added? */
bool figures_record_foreign(const struct figures_record *r, const char *dir, const char *name);

/* Adds DIR/NAME as it is now. */
void figures_record_add(struct figures_record *r, const char *dir, const char *name);

#endif
