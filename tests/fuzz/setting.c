/* setting.c -- fuzzes KEY=VALUE, a line each, over a scene that is sound without them. */
#include "bytes.h"

#include "base/status.h"
#include "plan/plan.h"
#include "plan/survey.h"
#include "scene/scene.h"

#include <string.h>

static const char sound[] =
    "dimension = 2; gravity = [0.0, -9.81]; until = 0.02; spacing = 0.02;\n"
    "domain = { from = [0.0, 0.0]; to = [0.4, 0.2]; };\n"
    "fluid = { left = { from = [0.0, 0.0]; to = [0.1, 0.1]; }; };\n"
    "wall = { tank = { type = \"frame\"; }; };\n"
    "beam = { plate = { at = [0.3, 0.0]; length = 0.1; thickness = 0.02; E = 1e8; "
    "density = 1200.0; }; };\n"
    "effects = { continuity = { }; pressure = { }; artificial-viscosity = { }; };\n"
    "probe = { bed = { at = [0.05, 0.015]; what = \"pressure\"; }; };\n";

static int set_all(struct scene *scene, char *lines)
{
    for (char *rest, *line = strtok_r(lines, "\n", &rest); line; line = strtok_r(NULL, "\n", &rest))
        TRY(scene_override(scene, line));
    return STATUS_DONE;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t n)
{
    struct scene *scene = NULL;
    const struct plan *plan = NULL;
    struct plan_survey survey = { 0 };
    char path[64], *lines = calloc(n + 1, 1);
    const int file = bytes_open((const uint8_t *)sound, strlen(sound), path);

    memcpy(lines, bytes, n);
    if (scene_read(path, &scene) == STATUS_DONE && set_all(scene, lines) == STATUS_DONE
        && scene_override(scene, "spacing=0.02") == STATUS_DONE)
        plan_survey_create(scene, &survey, &plan);
    plan_survey_free(&survey);
    plan_free(&plan);
    scene_free(&scene);
    status_forgive();
    close(file);
    free(lines);
    return 0;
}
