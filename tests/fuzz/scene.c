/* scene.c -- fuzzes the way from the text of a scene to a plan, and back to scene.used. */
#include "bytes.h"

#include "base/status.h"
#include "plan/plan.h"
#include "plan/survey.h"
#include "scene/scene.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t n)
{
    struct scene *scene = NULL;
    const struct plan *plan = NULL;
    struct plan_survey survey = { 0 };
    char path[64];
    const int file = bytes_open(bytes, n, path);

    /* coarse, so that most of the time goes into reading, not into particles */
    if (scene_read(path, &scene) == STATUS_DONE && scene_override(scene, "spacing=0.02") == STATUS_DONE
        && plan_survey_create(scene, &survey, &plan) == STATUS_DONE) {
        FILE *used = fopen("/dev/null", "w");
        scene_write_used(scene, used);
        fclose(used);
    }
    plan_survey_free(&survey);
    plan_free(&plan);
    scene_free(&scene);
    status_forgive();
    close(file);
    return 0;
}
