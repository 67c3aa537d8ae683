/* contact-together.c -- ranks measure solids together, each a part. */
#include "walls/contact-together.h"

#include "base/status.h"
#include "ranks/ranks.h"

struct contact_part contact_together_part(const struct part_places *at, int n)
{
    if (!at->together)
        return (struct contact_part){ 0, n };
    return (struct contact_part){ ranks_part(n, ranks_me()), ranks_part(n, ranks_me() + 1) };
}

int contact_together_agree(const struct part_places *at, int status)
{
    return at->together ? ranks_agree_within(status) : status;
}

int contact_together_compare(const struct part_places *at, int n)
{
    double most[2] = { n, -n }; /* and least */

    if (!at->together)
        return STATUS_DONE;
    ranks_most(2, most);
    if (most[0] == -most[1])
        return STATUS_DONE;
    return status_fail_with(STATUS_BAD_SCENE, (struct status_advice){
        .cause = "They run different programs, or the same one with different libraries",
        .remedy = "let all run one program, and link it with the same libraries" },
        "ranks have from %g to %g particles of solids", -most[1], most[0]);
}

void contact_together_hear(const struct part_places *at, int n, size_t bytes, void *rows)
{
    const int ranks = ranks_count();
    int count[ranks];

    for (int r = 0; r < ranks; r++)
        count[r] = ranks_part(n, r + 1) - ranks_part(n, r);
    if (at->together)
        ranks_gather(count, bytes, NULL, rows);
}

void contact_together_hear_uneven(const struct part_places *at, int n, const long *start, int each, size_t bytes,
                                  void *rows)
{
    const int ranks = ranks_count();
    int count[ranks];

    for (int r = 0; r < ranks; r++)
        count[r] = (int)((start[ranks_part(n, r + 1)] - start[ranks_part(n, r)]) / each);
    if (at->together)
        ranks_gather(count, bytes, NULL, rows);
}

long contact_together_sum(const struct part_places *at, long number)
{
    int64_t sum = number;

    if (at->together)
        ranks_add(1, &sum);
    return (long)sum;
}
