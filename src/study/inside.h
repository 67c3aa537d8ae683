/* inside.h -- a comparison at work; for the files of this room. */
#ifndef STUDY_INSIDE_H
#define STUDY_INSIDE_H

#include "study/compare.h"
#include "study/facts.h"
#include "study/member.h"
#include "study/result.h"
#include "study/words.h"

enum { INSIDE_WORD = 96 };

/* One combination of the values of the swept keys. */
struct point {
    const char *value[COMPARE_SWEEPS];
    char label[256];      /* "beam.E=5e9 spacing=0.01"; "" without a sweep          */
    struct facts facts;
    int pieces;           /* positions are compared at until / pieces                */
    int fine;             /* pictures of the reference until then                    */
    struct trial *reference, *disturbed; /* NULL: the finest is; growth is not asked */
    struct point *finest; /* with the least spacing, all else as here                */
    char place[256];      /* label without the spacing                               */
};

/* One run. */
struct trial {
    struct point *point;
    char method[INSIDE_WORD], tol[INSIDE_WORD]; /* tol "": a method without              */
    int repeat;                                 /* 0, 1, ...                              */
    bool disturbed;                             /* gravity tilted by TRIAL_DISTURBANCE    */
    struct trial *reference;                    /* what its errors are taken against      */
    struct member run;
    struct result result;
};

struct study {
    const struct compare_order *order;
    struct member_home home;
    int sweeps;
    char key[COMPARE_SWEEPS][INSIDE_WORD];
    const char *unit[COMPARE_SWEEPS]; /* of the keys                                     */
    struct words values[COMPARE_SWEEPS], methods, tols;
    int points, cases;   /* cases: methods x tolerances of one point                  */
    struct point *point; /* [points]                                                  */
    struct trial *reference; /* [points] and, with growth, [points] more              */
    struct trial *trial; /* [repeat][points][cases]                                   */
    int trials;
    bool finest;         /* each run's reference is that with the least spacing       */
    char reference_method[INSIDE_WORD], reference_tol[INSIDE_WORD]; /* unless so      */
};

#endif
