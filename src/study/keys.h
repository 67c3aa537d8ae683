/* keys.h -- keys of a scene that a study sets itself. */
#ifndef STUDY_KEYS_H
#define STUDY_KEYS_H

struct key_owner {
    const char *key;
    const char *instead; /* what to do; NULL ends a table */
};

/* Refuses "KEY=VALUE" [n] where the study would set KEY again behind it. */
int keys_free(const struct key_owner *own, int n, const char *const *setting);

#endif
