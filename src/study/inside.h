/* inside.h -- a comparison at work; for the files of this room. */
#ifndef STUDY_INSIDE_H
#define STUDY_INSIDE_H

#include "output/aside.h"
#include "study/compare.h"
#include "study/words.h"
#include "study/result.h"

enum { INSIDE_PATH = ASIDE_PATH, INSIDE_WORD = 96, INSIDE_MESSAGE = 600 };

/* One combination of the values of the swept keys. */
struct point {
    const char *value[COMPARE_SWEEPS];
    char label[256];      /* "beam.E=5e9 spacing=0.01"; "" without a sweep          */
    char title[128];
    double until, dx;     /* [s], [m]; dx 0 without particles                        */
    double gravity[3];    /* [m/s^2]                                                */
    int dimension;
    bool beam;
    int pieces;           /* positions are compared at until / pieces                */
    int fine;             /* pictures of the reference until then                    */
    struct trial *reference, *disturbed; /* disturbed: NULL when growth is not asked */
};

/* One run. */
struct trial {
    struct point *point;
    char method[INSIDE_WORD], tol[INSIDE_WORD]; /* tol "": a method without              */
    int repeat;                                 /* 0, 1, ...                              */
    bool disturbed;                             /* gravity tilted by TRIAL_DISTURBANCE    */
    char name[256];                             /* below DIR/runs                         */
    bool ended, reused, late;
    int code;                                   /* as struct child has it                 */
    char message[INSIDE_MESSAGE];
    struct result result;
};

struct study {
    const struct compare_order *order;
    char directory[INSIDE_PATH / 2], program[INSIDE_PATH];
    char identity[512];  /* of program and scene files                                */
    int sweeps;
    char key[COMPARE_SWEEPS][INSIDE_WORD];
    struct words values[COMPARE_SWEEPS], methods, tols;
    int points, cases;   /* cases: methods x tolerances of one point                  */
    struct point *point; /* [points]                                                  */
    struct trial *reference; /* [points] and, with growth, [points] more              */
    struct trial *trial; /* [repeat][points][cases]                                   */
    int trials;
    char reference_method[INSIDE_WORD], reference_tol[INSIDE_WORD];
};

#endif
