/* replay-scene.c -- the kept inputs of scene.c. */
#include "replay.h"

int main(void)
{
    return replay("scene");
}
