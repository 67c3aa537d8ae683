/* method.c -- all methods by name. */
#include "time/method.h"

#include "base/status.h"
#include "scene/scene.h"
#include "time/ab3.h"
#include "time/alone.h"
#include "time/arkode.h"
#include "time/cvode.h"
#include "time/dv.h"
#include "time/fixed.h"
#include "time/gslode.h"
#include "time/mri.h"
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The order of `stiffwater list methods`. */
const struct method *const method_table[] = {
    &arkode_imex2.method,
    &arkode_imex3.method,
    &arkode_imex4.method,
    &arkode_imex5.method,
    &arkode_ark436.method,
    &arkode_cks43.method,
    &arkode_opt53.method,
    &arkode_opt64.method,
    &arkode_bs54.method,
    &cvode_adams.method,
    &cvode_bdf.method,
    &gslode_rkf45.method,
    &gslode_rk8pd.method,
    &gslode_msadams.method,
    &ab3_kind.method,
    &dv_kind.method,
    &fixed_leapfrog.method,
    &fixed_euler.method,
    &fixed_staggered.method,
    &fixed_pcisph.method,
    &fixed_mps.method,
    &mri_method.kind.method,
    &mri_rigid_method.kind.method,
    &arkode_erk2.method,
    &arkode_erk3.method,
    &arkode_erk4.method,
    &arkode_erk5.method,
    &arkode_erk6.method,
    &arkode_dirk2.method,
    &arkode_dirk3.method,
    &arkode_dirk4.method,
    &arkode_dirk5.method,
    &arkode_heun_euler_2_1_2.method,
    &arkode_bogacki_shampine_4_2_3.method,
    &arkode_ark324l2sa_erk_4_2_3.method,
    &arkode_zonneveld_5_3_4.method,
    &arkode_ark436l2sa_erk_6_3_4.method,
    &arkode_ark437l2sa_erk_7_3_4.method,
    &arkode_sayfy_aburub_6_3_4.method,
    &arkode_cash_karp_6_4_5.method,
    &arkode_fehlberg_6_4_5.method,
    &arkode_dormand_prince_7_4_5.method,
    &arkode_ark548l2sa_erk_8_4_5.method,
    &arkode_ark548l2sab_erk_8_4_5.method,
    &arkode_verner_8_5_6.method,
    &arkode_fehlberg_13_7_8.method,
    NULL
};

struct method_def method_def_default(void)
{
    return (struct method_def){ .tol = PLAN_TOL, .norm = VECTOR_NORM_MAX };
}

const char *method_bodies_alone(const struct plan *plan)
{
    return plan_viscous(plan) ? "it does not solve for the velocities of a fluid whose viscosity "
                                "is implicit; imex3, imex4 and imex5 do, or set "
                                "side = \"explicit\""
                              : NULL;
}

/* Beams alone: imex4 keeps their vibrations for a sixth of the steps.  In water imex3 is
 * safer: the pair of imex4 makes energy where a light beam hangs in water. */
const char *method_default(const struct plan *plan)
{
    if (!plan_stiff(plan))
        return "cks43";
    return alone_bodies(plan) ? "imex4" : "imex3";
}

static const struct method *exact(const char *name)
{
    for (int i = 0; method_table[i]; i++)
        if (strcmp(method_table[i]->name, name) == 0)
            return method_table[i];
    return NULL;
}

static int refuse_name(const char *name)
{
    const char *names[sizeof method_table / sizeof method_table[0]], *near;

    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        names[i] = method_table[i] ? method_table[i]->name : NULL;
    near = scene_nearest(name, names);
    return status_fail(STATUS_BAD_SCENE,
                       "there is no method \"%s\"%s%s%s; `stiffwater list methods` shows all", name,
                       near ? " (did you mean \"" : "", near ? near : "", near ? "\"?)" : "");
}

/* NAME@1e-4s, whose s ends the text. */
static int read_seconds(const struct method *m, const char *text, struct method_def *def)
{
    char *end;

    if (m->varies)
        return status_fail(STATUS_BAD_SCENE, "method %s@%s: %s", m->name, text, m->varies);
    errno = 0;
    def->seconds = strtod(text, &end);
    if (errno == 0 && end != text && strcmp(end, "s") == 0 && def->seconds > 0
        && isfinite(def->seconds))
        return STATUS_DONE;
    return status_fail(STATUS_BAD_SCENE, "method %s@%s: a constant step is a number of seconds "
                       "above 0 with an s behind it, like %s@1e-4s", m->name, text, m->name);
}

/* The number after the @. */
static int read_step(const struct method *m, const char *text, struct method_def *def)
{
    char *end;

    if (text[0] && text[strlen(text) - 1] == 's')
        return read_seconds(m, text, def);
    if (m->adaptive)
        return status_fail(STATUS_BAD_SCENE,
                           "method %s@%s: %s chooses its step by its error, so it has no CFL "
                           "number; set `tol` instead (default %g)%s%s%s", m->name, text, m->name,
                           method_def_default().tol,
                           m->varies ? "" : ", or give all steps one length in seconds, like ",
                           m->varies ? "" : m->name, m->varies ? "" : "@1e-4s");
    errno = 0;
    def->step = strtod(text, &end);
    if (errno == 0 && end != text && *end == '\0' && def->step > 0 && def->step <= 10)
        return STATUS_DONE;
    return status_fail(STATUS_BAD_SCENE,
                       "method %s@%s: after the @ stands the CFL number, h = number * hs/(c0 + v), "
                       "above 0 and up to 10, like %s@0.25, or a step in seconds, like %s@1e-4s",
                       m->name, text, m->name, m->name);
}

int method_find(const char *name, struct method_def *def, const struct method **out)
{
    const char *at = strchr(name, '@');
    const size_t n = at ? (size_t)(at - name) : strlen(name);
    char plain[64] = "";

    *out = NULL;
    if (n < sizeof plain) {
        memcpy(plain, name, n);
        *out = exact(plain);
    }
    if (!*out)
        return refuse_name(n < sizeof plain ? plain : name);
    return at ? read_step(*out, at + 1, def) : STATUS_DONE;
}
