/* member.h -- one run of a study: a child process `PROGRAM run' that works in DIR/runs/NAME. */
#ifndef STUDY_MEMBER_H
#define STUDY_MEMBER_H

#include "output/aside.h"
#include "output/mark.h"

#include <stdbool.h>

enum { MEMBER_PATH = ASIDE_PATH, MEMBER_MESSAGE = 600 };

/* What all runs of a study share. */
struct member_home {
    const char *scene;           /* path                                              */
    int overrides;
    const char *const *override; /* [overrides] "KEY=VALUE"                           */
    int threads;                 /* 0: 1                                              */
    const char *command;         /* of the program; NULL: run                         */
    double budget;               /* [s] of the clock for a run; 0: any                */
    const struct mark_owner *owner; /* whose mark the directory gets                  */
    bool force;                  /* as mark_claim() has it                            */
    char directory[MEMBER_PATH / 2], program[MEMBER_PATH];
    char identity[512];          /* of program and scene files                        */
};

struct member {
    char name[256];              /* below DIR/runs; "": there is none                 */
    double until;                /* when it is done [s]                               */
    bool ended, reused, late;
    int code;                    /* as struct child has it                            */
    char message[MEMBER_MESSAGE];
};

/* Fills directory (`asked', or for NULL the scene's name without ".scene" and `suffix'),
 * program and identity of a home whose other members are set. */
int member_home_make(struct member_home *h, const char *asked, const char *suffix);

/* Makes the directory, and its mark: before anything is written there.  STATUS_IO when it is
 * somebody else's. */
int member_home_claim(const struct member_home *h);

/* Makes the directory of a member; STATUS_IO where a link stands. */
int member_directory(const struct member_home *h, const struct member *m);

/* Adds text to the name; what a directory's name had better not hold becomes "_". */
void member_name_add(struct member *m, const char *text);

/* What the run's child is called with, NULL-ended: the home's settings, then `settings', a
 * line "KEY=VALUE\n" each.  The texts live in one piece of memory behind the array: free()
 * it.  NULL: no memory. */
char **member_words(const struct member_home *h, const struct member *m, const char *settings);

/* Takes over the run if DIR/runs/NAME holds one that ended with the same order, and not by a
 * signal, which says nothing of the run. */
bool member_reuse(const struct member_home *h, struct member *m, const char *settings);

/* Writes down how it ended, for member_reuse(), and reads what it said. */
int member_end(const struct member_home *h, struct member *m, const char *settings);

/* "done", "failed", "stopped" or "refused" */
const char *member_status(const struct member *m);

/* "DIR/runs/NAME/FILE" into to [MEMBER_PATH] */
void member_path(const struct member_home *h, const struct member *m, const char *file, char *to);

#endif
