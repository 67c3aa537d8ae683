/* pairs.c -- tests/unit/effects.c for a table with the effects of doc/adding-a-part.md. */
#include "../unit/effects.c"
