/* arkode-methods.c -- the methods that ARKStep runs, one row each. */
#include "time/arkode.h"

#include "time/alone.h"

/* Low gain: at the stability limit few steps are rejected, and single errors up
 * to four times tol pass. */
static const struct control_row low_gain = { { 0.28, -0.23, 0 }, 1, 4, 1.3 };
static const struct control_row low_gain_opt53 = { { 0.30, -0.20, 0 }, 1, 4, 1.3 };
static const struct control_row low_gain_opt64 = { { 0.35, -0.25, 0 }, 1, 4, 1.3 };
static const struct control_row low_gain_ark436 = { { 0.38, -0.18, 0.01 }, 1, 4, 1.3 };

/* Where accuracy decides: every error below tol. */
static const struct control_row accurate = { { 0.60, -0.20, 0 }, 0.5, 1, 2.5 };
static const struct control_row pid = { { 0.58, -0.21, 0.10 }, 0.6, 1, 2.5 };

static const char *serves(const struct plan *plan)
{
    long range[ARKODE_RANGES + 1][2];

    if (plan_size(plan) == 0)
        return "nothing in this scene moves";
    if (plan_stiff_ranges(plan, plan_layout(plan), ARKODE_RANGES + 1, range) > ARKODE_RANGES)
        return "the scene has more stiff bodies than ARKODE_RANGES in arkode.h";
    return NULL;
}

static const char *serves_alone(const struct plan *plan)
{
    if (plan_size(plan) > 0 && !plan_stiff(plan))
        return "it solves everything implicitly, and this scene has no beam to solve for: use "
               "cks43 or another explicit method";
    if (plan_size(plan) > 0 && !alone_bodies(plan))
        return "it solves everything implicitly, and this scene's water has no implicit solve: "
               "use imex3, which takes the water explicitly, or bdf";
    return serves(plan);
}

static const double *state(const void *self)
{
    const struct arkode *a = self;

    return vector_read(a->node[0].y);
}

static const char *table(const void *self)
{
    const struct arkode *a = self;

    return a->tables;
}

#define METHOD(NAME, ORDER, ABOUT, SOURCE, SERVES)                                       \
    .method = { .name = NAME, .told = { ABOUT, SOURCE }, .adaptive = true,               \
                .order = ORDER, .serves = SERVES, .create = arkode_create,               \
                .step = arkode_step,                                                     \
                .at = arkode_at, .state = state, .restart = arkode_restart,              \
                .table = table, .free = arkode_free, .room = { arkode_vectors, arkode_vectors }, \
                .rearrange = arkode_rearrange }

#define OWN(NAME, ABOUT, SOURCE, TABLE, ORDER, CONTROL)                                  \
    { METHOD(NAME, ORDER, ABOUT, SOURCE, serves), .own = &TABLE, .order = ORDER,         \
      .control = &CONTROL }

#define ERK(NAME, ABOUT, SOURCE, TABLE, ORDER, CONTROL)                                  \
    { METHOD(NAME, ORDER, ABOUT, SOURCE, serves), .erk = TABLE, .order = ORDER,          \
      .control = &CONTROL }

#define PAIR(NAME, ABOUT, TABLE, STAGES, ORDER)                                          \
    { METHOD(NAME, ORDER, ABOUT,                                                         \
             "Kennedy, Carpenter, Appl. Numer. Math. 44 (2003) 139-181", serves),        \
      .erk = "ARKODE_" TABLE "_ERK_" STAGES, .dirk = "ARKODE_" TABLE "_DIRK_" STAGES,    \
      .order = ORDER, .control = &pid }

#define DIRK(NAME, ABOUT, TABLE, ORDER)                                                  \
    { METHOD(NAME, ORDER, ABOUT, "Kennedy, Carpenter, NASA/TM-2016-219173",              \
             serves_alone),                                                              \
      .dirk = "ARKODE_" TABLE, .order = ORDER, .control = &pid }

#define NAMED(TABLE, ORDER)                                                              \
    ERK("ARKODE_" TABLE, "explicit table of SUNDIALS by its own name",                   \
        "SUNDIALS, ARKODE manual", "ARKODE_" TABLE, ORDER, pid)

/* clang-format off */
const struct arkode_row arkode_imex2 =
    { METHOD("imex2", 2, "explicit fluid, implicit beams, order 2(1)",
             "Giraldo, Kelly, Constantinescu, SIAM J. Sci. Comput. 35 (2013) B1162-B1194", serves),
      .own = &tableau_ark2_erk, .own_dirk = &tableau_ark2_dirk, .order = 2, .control = &pid };
const struct arkode_row arkode_imex3 =
    PAIR("imex3", "explicit fluid, implicit beams, order 3(2)", "ARK324L2SA", "4_2_3", 3);
const struct arkode_row arkode_imex4 =
    PAIR("imex4", "explicit fluid, implicit beams, order 4(3)", "ARK436L2SA", "6_3_4", 4);
const struct arkode_row arkode_imex5 =
    PAIR("imex5", "explicit fluid, implicit beams, order 5(4)", "ARK548L2SA", "8_4_5", 5);
const struct arkode_row arkode_ark436 =
    ERK("ark436", "explicit, 6 stages, order 4(3), wide stability",
        "Kennedy, Carpenter, Appl. Numer. Math. 44 (2003) 139-181",
        "ARKODE_ARK436L2SA_ERK_6_3_4", 4, low_gain_ark436);
const struct arkode_row arkode_cks43 =
    OWN("cks43", "explicit, 4 stages, order 3(2), widest on the imaginary axis",
        "Kennedy, Carpenter, Lewis, Appl. Numer. Math. 35 (2000) 177-219", tableau_cks43, 3,
        low_gain);
const struct arkode_row arkode_opt53 =
    OWN("opt53", "explicit, 5 stages, order 3(2), fitted to a dam break's spectrum",
        "derived here, see src/time/tableau.c", tableau_opt53, 3, low_gain_opt53);
const struct arkode_row arkode_opt64 =
    OWN("opt64", "explicit, 6 stages, order 4(3), fitted to a dam break's spectrum",
        "derived here, see src/time/tableau.c", tableau_opt64, 4, low_gain_opt64);
const struct arkode_row arkode_bs54 =
    OWN("bs54", "explicit, 7 stages, order 5(4), for five digits",
        "Bogacki, Shampine, Comput. Math. Appl. 32 (1996) 15-28", tableau_bs54, 5, accurate);
const struct arkode_row arkode_erk2 =
    ERK("erk2", "explicit, order 2(1)", "Heun; Euler", "ARKODE_HEUN_EULER_2_1_2", 2, pid);
const struct arkode_row arkode_erk3 =
    ERK("erk3", "explicit, order 3(2)", "Bogacki, Shampine, Appl. Math. Lett. 2 (1989) 321-325",
        "ARKODE_BOGACKI_SHAMPINE_4_2_3", 3, pid);
const struct arkode_row arkode_erk4 =
    ERK("erk4", "explicit, order 4(3)", "Zonneveld 1964", "ARKODE_ZONNEVELD_5_3_4", 4, pid);
const struct arkode_row arkode_erk5 =
    ERK("erk5", "explicit, order 5(4)", "Cash, Karp, ACM Trans. Math. Softw. 16 (1990) 201-222",
        "ARKODE_CASH_KARP_6_4_5", 5, pid);
const struct arkode_row arkode_erk6 =
    ERK("erk6", "explicit, order 6(5)", "Verner, SIAM J. Numer. Anal. 15 (1978) 772-790",
        "ARKODE_VERNER_8_5_6", 6, pid);
const struct arkode_row arkode_dirk2 =
    { METHOD("dirk2", 2, "beams alone, all implicit, order 2(1)",
             "TR-BDF2: Bank and others, IEEE Trans. Electron Devices 32 (1985) 1992-2007",
             serves_alone), .own_dirk = &tableau_ark2_dirk, .order = 2, .control = &pid };
const struct arkode_row arkode_dirk3 =
    DIRK("dirk3", "beams alone, all implicit, order 3(2)", "ESDIRK325L2SA_5_2_3", 3);
const struct arkode_row arkode_dirk4 =
    DIRK("dirk4", "beams alone, all implicit, order 4(3)", "ESDIRK436L2SA_6_3_4", 4);
const struct arkode_row arkode_dirk5 =
    DIRK("dirk5", "beams alone, all implicit, order 5(4)", "ESDIRK547L2SA2_7_4_5", 5);
const struct arkode_row arkode_heun_euler_2_1_2 = NAMED("HEUN_EULER_2_1_2", 2);
const struct arkode_row arkode_bogacki_shampine_4_2_3 = NAMED("BOGACKI_SHAMPINE_4_2_3", 3);
const struct arkode_row arkode_ark324l2sa_erk_4_2_3 = NAMED("ARK324L2SA_ERK_4_2_3", 3);
const struct arkode_row arkode_zonneveld_5_3_4 = NAMED("ZONNEVELD_5_3_4", 4);
const struct arkode_row arkode_ark436l2sa_erk_6_3_4 = NAMED("ARK436L2SA_ERK_6_3_4", 4);
const struct arkode_row arkode_ark437l2sa_erk_7_3_4 = NAMED("ARK437L2SA_ERK_7_3_4", 4);
const struct arkode_row arkode_sayfy_aburub_6_3_4 = NAMED("SAYFY_ABURUB_6_3_4", 4);
const struct arkode_row arkode_cash_karp_6_4_5 = NAMED("CASH_KARP_6_4_5", 5);
const struct arkode_row arkode_fehlberg_6_4_5 = NAMED("FEHLBERG_6_4_5", 5);
const struct arkode_row arkode_dormand_prince_7_4_5 = NAMED("DORMAND_PRINCE_7_4_5", 5);
const struct arkode_row arkode_ark548l2sa_erk_8_4_5 = NAMED("ARK548L2SA_ERK_8_4_5", 5);
const struct arkode_row arkode_ark548l2sab_erk_8_4_5 = NAMED("ARK548L2SAb_ERK_8_4_5", 5);
const struct arkode_row arkode_verner_8_5_6 = NAMED("VERNER_8_5_6", 6);
const struct arkode_row arkode_fehlberg_13_7_8 = NAMED("FEHLBERG_13_7_8", 8);
/* clang-format on */
