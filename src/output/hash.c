/* hash.c -- FNV-1a: for each byte, hash = (hash xor byte) * prime.
 *
 * Offset and prime of the 64-bit variant: Fowler, Noll, Vo; IETF draft
 * draft-eastlake-fnv. */
#include "output/hash.h"

#include <inttypes.h>
#include <stdio.h>

uint64_t hash_bytes(uint64_t from, const void *bytes, size_t n)
{
    const unsigned char *byte = bytes;
    uint64_t hash = from;

    for (size_t i = 0; i < n; i++)
        hash = (hash ^ byte[i]) * UINT64_C(0x100000001b3);
    return hash;
}

const char *hash_text(uint64_t hash, char text[HASH_TEXT])
{
    snprintf(text, HASH_TEXT, "%016" PRIx64, hash);
    return text;
}
