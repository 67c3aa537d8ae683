/* replay-table.c -- the kept inputs of table.c. */
#include "replay.h"

int main(void)
{
    return replay("table");
}
