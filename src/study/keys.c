/* keys.c -- keys of a scene that a study sets itself. */
#include "study/keys.h"

#include "base/status.h"

#include <string.h>

int keys_free(const struct key_owner *own, int n, const char *const *setting)
{
    for (int i = 0; i < n; i++)
        for (const struct key_owner *o = own; o->instead; o++) {
            const size_t length = strlen(o->key);
            if (strncmp(setting[i], o->key, length) == 0 && setting[i][length] == '=')
                return status_fail(STATUS_BAD_SCENE, "%.60s: %s is set for each run: %s",
                                   setting[i], o->key, o->instead);
        }
    return STATUS_DONE;
}
