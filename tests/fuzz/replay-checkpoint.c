/* replay-checkpoint.c -- the kept inputs of checkpoint.c. */
#include "replay.h"

int main(void)
{
    return replay("checkpoint");
}
