/* param.h -- one row describes a parameter everywhere: reading, range check,
 * `explain`, scene.used and the manual. */
#ifndef BASE_PARAM_H
#define BASE_PARAM_H

#include <stddef.h>

enum param_type {
    PARAM_NUMBER = 0, /* double                                             */
    PARAM_INTEGER,    /* int                                                */
    PARAM_FLAG,       /* bool                                               */
    PARAM_WORD,       /* const char *, one of words; the first is default   */
    PARAM_TEXT,       /* const char *, owned by the scene, never NULL       */
    PARAM_VECTOR,     /* double[3]; a scene gives `dimension` numbers       */
    PARAM_POINTS,     /* struct param_points, a list of vectors             */
    PARAM_PAIRS,      /* struct param_points, a list of pairs of numbers    */
    PARAM_WORDS       /* unsigned, bit i set when words[i] is in the list   */
};

struct param_points {
    int n;
    double (*x)[3]; /* [n][3] owned by the scene */
};

struct param {
    const char *key;          /* NULL ends a table                          */
    const char *unit;         /* "" if it has none                          */
    size_t offset;            /* of the value in the part's struct          */
    double fallback;          /* default; NAN: see about (it is computed)   */
    double min, max;          /* accepted range, ends included              */
    const char *about;        /* one sentence                               */
    enum param_type type;
    const char *const *words; /* of PARAM_WORD, PARAM_WORDS; NULL-ended     */
    int required;             /* no default: the scene must give it         */
};

#endif
