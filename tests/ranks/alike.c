/* alike.c -- a block that ranks have alike takes memory once, and nothing else changes. */
#include "alike.h"

#include "base/status.h"
#include "claims.h"
#include "ranks/ranks.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NUMBERS = 1 << 20, OWN = NUMBERS / 2 + 7 }; /* of 8 MiB; the one that differs */

static double number(int i)
{
    return i == OWN ? -1 - ranks_me() : claims_random((unsigned)i);
}

/* Memory that this process has for itself [MB]; below 0: the system does not say. */
static double own_memory(void)
{
    FILE *file = fopen("/proc/self/smaps_rollup", "r");
    char line[200];
    double kilobytes = -1;

    while (file && fgets(line, sizeof line, file))
        if (strncmp(line, "Private_Dirty:", 14) == 0)
            kilobytes = atof(line + 14);
    if (file)
        fclose(file);
    return kilobytes / 1e3;
}

static bool is_as_it_was(const double *block, int but)
{
    bool good = true;

    for (int i = 0; i < NUMBERS; i++)
        good &= i == but || block[i] == number(i);
    return good;
}

/* Nobody goes on before all are here. */
static void wait_for_all(void)
{
    claim(ranks_agree(STATUS_DONE) == STATUS_DONE, "all are here");
}

static void one_rank_writes(double *block)
{
    const int at = 3, last = ranks_count() - 1;

    wait_for_all();
    if (ranks_me() == last)
        block[at] = -7;
    wait_for_all();
    claim(block[at] == (ranks_me() == last ? -7 : number(at)) && is_as_it_was(block, at),
          "what one rank writes to it no other sees");
}

void alike_claims(void)
{
    double *block = calloc(NUMBERS, sizeof *block), before, after;

    for (int i = 0; i < NUMBERS; i++)
        block[i] = number(i);
    before = own_memory();
    ranks_alike(block, NUMBERS * sizeof *block);
    after = own_memory();
    claim(is_as_it_was(block, -1), "what is alike is what it was, and so is what is not");
    if (ranks_count() > 1)
        claim(before < 0 || before - after > 6, "8.4 MB that all have take %.1f MB less", before - after);
    ranks_alike(block, 100);
    ranks_alike(block, 0);
    one_rank_writes(block);
    free(block);
}
