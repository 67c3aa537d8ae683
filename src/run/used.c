/* used.c -- scene.used: the scene of a run with all that was computed for it. */
#include "run/inside.h"

#include "base/status.h"
#include "output/aside.h"
#include "scene/scene.h"

int run_write_used(const struct run *r)
{
    char path[ASIDE_PATH];
    struct aside file;
    int status;

    TRY(aside_join(path, r->directory, "scene.used"));
    TRY(aside_open(&file, path));
    status = scene_write_used(r->scene, file.to);
    TRY(aside_close(&file));
    return status;
}
