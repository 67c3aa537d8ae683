/* replay-setting.c -- the kept inputs of setting.c. */
#include "replay.h"

int main(void)
{
    return replay("setting");
}
