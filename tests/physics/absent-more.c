/* absent-more.c -- absent.c for the program with one effect more in its tables. */
#define ABSENT_MORE
#include "absent.c"
