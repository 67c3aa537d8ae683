/* patience.c -- work that may not take longer than some seconds nor more than 1 GB, in a process of
 * its own. */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include "run/patience.h"

#include "ranks/ranks.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { LOOKS = 100 };  /* in a second */

static const long most_bytes = 850000000; /* a processor touches 0.1 GB in a hundredth of a second */

static timer_t timer;
static bool runs;      /* timer                                      */
static bool is_all;    /* the process ends at patience_done()        */
static long looks, most_looks;
static int statm = -1; /* /proc/self/statm: its second number is how many pages are held */

static long held(void)
{
    char text[64];
    const ssize_t n = pread(statm, text, sizeof text, 0);
    long pages = 0;
    ssize_t i = 0;

    while (i < n && text[i] != ' ')
        i++;
    for (i++; i < n && text[i] >= '0' && text[i] <= '9'; i++)
        pages = 10 * pages + text[i] - '0';
    return pages * sysconf(_SC_PAGESIZE);
}

/* The signal does by default, when it has returned, what is wanted then: it ends the process. */
static void look(int ring)
{
    const int before = errno;

    looks += 1 + timer_getoverrun(timer);
    if (looks >= most_looks || held() > most_bytes) {
        signal(ring, SIG_DFL);
        raise(ring);
    }
    errno = before;
}

/* The main thread's time: it has a share in all loops, and waits without spending any, so that
 * neither the number of threads nor other programs change what can be looked at. */
static void set_off(double seconds)
{
    struct sigevent ring = { .sigev_notify = SIGEV_SIGNAL, .sigev_signo = SIGVTALRM };
    const struct timespec each = { .tv_nsec = 1000000000 / LOOKS };
    const struct itimerspec when = { .it_value = each, .it_interval = each };
    const struct sigaction act = { .sa_handler = look, .sa_flags = SA_RESTART };

    looks = 0;
    most_looks = (long)(seconds * LOOKS);
    statm = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
    sigaction(SIGVTALRM, &act, NULL);
    runs = timer_create(CLOCK_THREAD_CPUTIME_ID, &ring, &timer) == 0
           && timer_settime(timer, 0, &when, NULL) == 0;
}

void patience_is_all(void)
{
    is_all = true;
}

bool patience_asks(void)
{
    return is_all;
}

void patience_done(void)
{
    if (is_all)
        _exit(EXIT_SUCCESS);
    if (runs) {
        timer_delete(timer);
        close(statm);
    }
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
    child = fork();
    if (child > 0)
        return wait_for(child);
    if (child == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() != parent)
            _exit(EXIT_FAILURE);
        ranks_leave();
        set_off(seconds);
    }
    return PATIENCE_BEGIN;
}
