/* pairs.c -- tests/unit/effects.c for the table with the effects of doc/adding-a-part.md. */
#include "../unit/effects.c"
