/* stop.c -- notes SIGINT and SIGTERM. */
#include "run/stop.h"

#include <signal.h>
#include <stddef.h>

static volatile sig_atomic_t asked;

static void note(int signal)
{
    asked = signal;
}

void stop_listen(void)
{
    struct sigaction action = { .sa_handler = note, .sa_flags = SA_RESETHAND };

    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
}

int stop_asked(void)
{
    return asked;
}
