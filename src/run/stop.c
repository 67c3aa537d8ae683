/* stop.c -- notes SIGINT, SIGTERM and SIGHUP.
 *
 * timeout(1) and batch systems signal the process and then its group, so that one
 * wish comes twice: what follows within a second is the same wish. */
#include "run/stop.h"

#include "base/status.h"

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <time.h>
#include <unistd.h>

static volatile sig_atomic_t asked;
static struct timespec first; /* written by the handler only */
static bool hangup_ignored;

static bool is_later(const struct timespec *now, double seconds)
{
    return (double)(now->tv_sec - first.tv_sec) + 1e-9 * (double)(now->tv_nsec - first.tv_nsec)
           > seconds;
}

static void note(int number)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    if (!asked) {
        first = now;
        asked = number;
    } else if (is_later(&now, 1)) {
        signal(number, SIG_DFL);
        raise(number); /* waits until this handler is left */
    }
}

/* Was SIGHUP ignored when the program began?  Asked before the constructors of libraries: UCX,
 * which comes with a SUNDIALS that is built for MPI, takes this signal in its own. */
static void ask_hangup(void)
{
    struct sigaction now;

    hangup_ignored = sigaction(SIGHUP, NULL, &now) == 0 && now.sa_handler == SIG_IGN;
}
__attribute__((section(".preinit_array"), used)) static void (*const before_libraries)(void)
    = ask_hangup;

/* Nothing has been written yet. */
static void leave(int number)
{
    static const char words[] = "stiffwater: stopped by a signal before the first file was "
                                "written\n";

    (void)number;
    _exit(write(STDERR_FILENO, words, sizeof words - 1) < 0 ? STATUS_IO : STATUS_STOPPED);
}

/* A run under nohup(1) outlives its terminal. */
static void hear_hangup(const struct sigaction *action)
{
    if (hangup_ignored)
        signal(SIGHUP, SIG_IGN);
    else
        sigaction(SIGHUP, action, NULL);
}

static void hear(void (*handler)(int number))
{
    struct sigaction action = { .sa_handler = handler, .sa_flags = SA_RESTART };

    sigemptyset(&action.sa_mask);
    sigaddset(&action.sa_mask, SIGINT);
    sigaddset(&action.sa_mask, SIGTERM);
    sigaddset(&action.sa_mask, SIGHUP);
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    hear_hangup(&action);
}

void stop_leave(void)
{
    hear(leave);
}

void stop_listen(void)
{
    hear(note);
    signal(SIGPIPE, SIG_IGN); /* an unread progress line is no reason to end */
    signal(SIGXFSZ, SIG_IGN); /* write() says it, and the run ends in order       */
}

int stop_asked(void)
{
    return asked;
}

bool stop_urgent(void)
{
    struct timespec now;

    if (!asked)
        return false;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return is_later(&now, 0.5);
}
