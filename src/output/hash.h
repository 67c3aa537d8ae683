/* hash.h -- a number that tells whether two states are the same bits. */
#ifndef OUTPUT_HASH_H
#define OUTPUT_HASH_H

#include <stddef.h>
#include <stdint.h>

enum { HASH_TEXT = 17 };

#define HASH_START UINT64_C(0xcbf29ce484222325)

/* FNV-1a, 64 bits, over the bytes; `from` is HASH_START or the hash of what
 * came before.  For numbers of this machine's byte order. */
uint64_t hash_bytes(uint64_t from, const void *bytes, size_t n);

/* 16 hexadecimal digits into text [HASH_TEXT]; returns text. */
const char *hash_text(uint64_t hash, char text[HASH_TEXT]);

#endif
