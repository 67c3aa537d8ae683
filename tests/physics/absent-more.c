/* absent-more.c -- absent.c for the program whose tables have one effect more. */
#define ABSENT_MORE
#include "absent.c"
