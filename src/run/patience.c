/* patience.c -- work that may not take longer than some seconds, in a process of its own. */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include "run/patience.h"

#include "ranks/ranks.h"

#include <errno.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static timer_t timer;
static bool runs; /* timer */

/* The main thread's time: it has a share in all loops, and waits without spending any, so that
 * neither the number of threads nor other programs change what can be looked at. */
static void set_off(double seconds)
{
    struct sigevent ring = { .sigev_notify = SIGEV_SIGNAL, .sigev_signo = SIGVTALRM };
    const struct itimerspec when = {
        .it_value = { (time_t)seconds, (long)(1e9 * (seconds - (double)(time_t)seconds)) },
    };

    signal(SIGVTALRM, SIG_DFL); /* ends the process */
    runs = timer_create(CLOCK_THREAD_CPUTIME_ID, &ring, &timer) == 0
           && timer_settime(timer, 0, &when, NULL) == 0;
}

void patience_done(void)
{
    if (runs)
        timer_delete(timer);
    runs = false;
}

static int wait_for(pid_t child)
{
    int how = 0;

    while (waitpid(child, &how, 0) < 0)
        if (errno != EINTR)
            return PATIENCE_OVER;
    if (WIFEXITED(how))
        return WEXITSTATUS(how);
    if (WTERMSIG(how) != SIGVTALRM) {
        signal(WTERMSIG(how), SIG_DFL);
        raise(WTERMSIG(how));
    }
    return PATIENCE_OVER;
}

int patience_try(double seconds)
{
    const pid_t parent = getpid();
    pid_t child;

    fflush(stdout);
    child = ranks_may_fork() ? fork() : -1;
    if (child > 0)
        return wait_for(child);
    if (child == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() != parent)
            _exit(EXIT_FAILURE);
        set_off(seconds);
    }
    return PATIENCE_BEGIN;
}
