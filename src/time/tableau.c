/* tableau.c -- coefficients that SUNDIALS does not have, and what follows from them.
 *
 * Checked in tests/unit/time.c: order conditions up to the order claimed, and
 * the order that is measured. */
#include "time/tableau.h"

/* RK3(2)4[2R+]C of Kennedy, Carpenter, Lewis, Appl. Numer. Math. 35 (2000)
 * 177-219: the low-storage A_i stand below the diagonal, b_j further left. */
#define KCL_B1 (1017324711453. / 9774461848756)
#define KCL_B2 (8237718856693. / 13685301971492)
const struct tableau tableau_cks43 = {
    .name = "CKLLSRK43_2", .stages = 4, .order = 3, .embedded = 2,
    .a = { { 0 },
           { 11847461282814. / 36547543011857 },
           { KCL_B1, 3943225443063. / 7078155732230 },
           { KCL_B1, KCL_B2, -346793006927. / 4029903576067 } },
    .b = { KCL_B1, KCL_B2, 57731312506979. / 19404895981398, -101169746363290. / 37734290219643 },
    .d = { 15763415370699. / 46270243929542, 514528521746. / 5659431552419,
           27030193851939. / 9429696342944, -69544964788955. / 30262026368149 },
};

/* OPT53, our own: its stability polynomial (z^4: 0.03103369, z^5: 0.00578555) is
 * the best for the spectrum of a dam break, as measured on finite difference
 * Jacobians; the freedom left makes the error small.  Needs the dissipation of
 * the fluid: on the imaginary axis it is stable to 2.19 only. */
const struct tableau tableau_opt53 = {
    .name = "OPT53", .stages = 5, .order = 3, .embedded = 2,
    .a = { { 0 },
           { 0.4148707784808236 },
           { -0.029639526812381748, 0.22621763142158388 },
           { 0.035176664778079514, 0.082157138822544773, 0.58383842153075294 },
           { -0.061016025461970179, 0.3057879512030422, 0.17374899983549758,
             0.46998986207183496 } },
    .b = { 0.059011780250727279, 0.2394052060680236, 0.26425217069436946, 0.21267157331455078,
           0.22465926967232883 },
    .d = { -0.0087133945628688411, 0.29090186893291003, 0.30550236603082215,
           0.25132517518644781, 0.16098398441268885 },
};

/* OPT64, made like OPT53 (z^5: 0.00544003, z^6: 0.00086321). */
const struct tableau tableau_opt64 = {
    .name = "OPT64", .stages = 6, .order = 4, .embedded = 3,
    .a = { { 0 },
           { 0.33558377333967282 },
           { 0.13223964760666984, 0.1075877055706905 },
           { 0.019177332045080764, -0.010174958347037202, 0.43143187367702124 },
           { 0.086286080504246299, 0.18897538308304232, 0.0080992546549164129,
             0.41524653176964599 },
           { 0.075424256045131102, 0.09230789437681311, 0.30776144207747552,
             0.019360607267042272, 0.35347764561578088 } },
    .b = { 0.097145221311653582, 0.042293459086369722, 0.18411351824132061, 0.33872006694032197,
           -0.039822673771220181, 0.37755040819155433 },
    .d = { 0.19239287268375388, 0.039524558616557133, -0.00023524954984696644,
           0.29628635404499049, 0.29481703785865709, 0.17721442634588841 },
};

/* Bogacki, Shampine, Comput. Math. Appl. 32 (1996) 15-28; first same as last. */
#define BS_B                                                                         \
    587. / 8064, 0, 4440339. / 15491840, 24353. / 124800, 387. / 44800, 2152. / 5985, \
    7267. / 94080
const struct tableau tableau_bs54 = {
    .name = "BOGACKI_SHAMPINE_8_4_5", .stages = 8, .order = 5, .embedded = 4,
    .a = { { 0 },
           { 1. / 6 },
           { 2. / 27, 4. / 27 },
           { 183. / 1372, -162. / 343, 1053. / 1372 },
           { 68. / 297, -4. / 11, 42. / 143, 1960. / 3861 },
           { 597. / 22528, 81. / 352, 63099. / 585728, 58653. / 366080, 4617. / 20480 },
           { 174197. / 959244, -30942. / 79937, 8152137. / 19744439, 666106. / 1039181,
             -29421. / 29068, 482048. / 414219 },
           { BS_B } },
    .b = { BS_B },
    .d = { 2479. / 34992, 0, 123. / 416, 612941. / 3411720, 43. / 1440, 2272. / 6561,
           79937. / 1113912, 3293. / 556956 },
};

/* ARK2 of Giraldo, Kelly, Constantinescu, SIAM J. Sci. Comput. 35 (2013)
 * B1162-B1194: both halves have the nodes 0, 2 - sqrt 2, 1 and the weights
 * 1/sqrt 8, 1/sqrt 8, 1 - 1/sqrt 2; the implicit one is TR-BDF2, L-stable. */
#define ROOT 1.41421356237309504880
#define ARK2_G (1 - ROOT / 2)
#define ARK2_W (ROOT / 4)
#define ARK2_D (4 - ROOT) / 8, (4 - ROOT) / 8, ROOT / 4
const struct tableau tableau_ark2_erk = {
    .name = "ARK2_ERK_3_1_2", .stages = 3, .order = 2, .embedded = 1,
    .a = { { 0 }, { 2 - ROOT }, { (3 - 2 * ROOT) / 6, (3 + 2 * ROOT) / 6 } },
    .b = { ARK2_W, ARK2_W, ARK2_G },
    .d = { ARK2_D },
};
const struct tableau tableau_ark2_dirk = {
    .name = "ARK2_DIRK_3_1_2", .stages = 3, .order = 2, .embedded = 1,
    .a = { { 0 }, { ARK2_G, ARK2_G }, { ARK2_W, ARK2_W, ARK2_G } },
    .b = { ARK2_W, ARK2_W, ARK2_G },
    .d = { ARK2_D },
};

const struct tableau *const tableau_own[] = {
    &tableau_cks43, &tableau_opt53, &tableau_opt64, &tableau_bs54, &tableau_ark2_erk,
    &tableau_ark2_dirk, 0
};

double tableau_node(const struct tableau *t, int i)
{
    double c = 0;

    for (int j = 0; j < t->stages; j++)
        c += t->a[i][j];
    return c;
}

bool tableau_first_same_as_last(const struct tableau *t)
{
    for (int j = 0; j < t->stages; j++)
        if (t->a[t->stages - 1][j] != t->b[j])
            return false;
    return true;
}
