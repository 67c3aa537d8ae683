/* children.c -- runs programs side by side, each with a limit of time. */
#include "study/children.h"

#include "base/status.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static const double patience = 20;  /* [s] between SIGTERM and SIGKILL */
static const double nap = 0.01;     /* [s] between two looks           */

static double clock_now(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* In the child: becomes the program, or tells through the pipe why not.  If its parent dies,
 * the program is asked to end in order. */
static _Noreturn void become(const struct child *c, pid_t parent, int tell)
{
    const int in = open("/dev/null", O_RDONLY | O_CLOEXEC);
    const int out = open(c->said, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    int error;

    if (in >= 0 && out >= 0 && dup2(in, STDIN_FILENO) >= 0 && dup2(out, STDOUT_FILENO) >= 0
        && dup2(out, STDERR_FILENO) >= 0 && prctl(PR_SET_PDEATHSIG, SIGTERM) == 0
        && getppid() == parent)
        execv(c->words[0], c->words);
    error = errno;
    while (write(tell, &error, sizeof error) < 0 && errno == EINTR) {
    }
    _exit(127);
}

/* 0, or what errno was in the child. */
static int hear(int from)
{
    int error = 0;
    ssize_t n;

    do
        n = read(from, &error, sizeof error);
    while (n < 0 && errno == EINTR);
    return n == sizeof error ? error : 0;
}

static int spawn(struct child *c)
{
    const pid_t parent = getpid();
    int pipe_of[2], error;

    if (pipe(pipe_of) != 0)
        return errno;
    fcntl(pipe_of[1], F_SETFD, FD_CLOEXEC); /* closed when the program begins */
    c->pid = fork();
    if (c->pid == 0) {
        close(pipe_of[0]);
        become(c, parent, pipe_of[1]);
    }
    error = c->pid < 0 ? errno : 0;
    close(pipe_of[1]);
    if (error == 0)
        error = hear(pipe_of[0]);
    close(pipe_of[0]);
    if (error != 0 && c->pid > 0)
        waitpid(c->pid, NULL, 0);
    return error;
}

static int start(struct child *c)
{
    const int error = spawn(c);

    if (error != 0) {
        c->pid = 0;
        return status_fail(STATUS_IO, "%s cannot be started: %s (what it says was to go to %s)",
                           c->words[0], strerror(error), c->said);
    }
    c->began = clock_now();
    return STATUS_DONE;
}

/* One wish is one signal: a second SIGTERM would kill before files are complete. */
static void hurry(struct child *c)
{
    const double now = clock_now();

    if (c->budget > 0 && !c->told && now - c->began > c->budget) {
        c->late = true;
        c->told = now;
        kill(c->pid, SIGTERM);
    } else if (c->told && now - c->told > patience) {
        kill(c->pid, SIGKILL);
    }
}

/* Has it ended? */
static bool is_over(struct child *c)
{
    int how;
    const pid_t found = waitpid(c->pid, &how, WNOHANG);

    if (found == 0 || (found < 0 && errno == EINTR))
        return false;
    c->code = found < 0 ? -SIGKILL : WIFEXITED(how) ? WEXITSTATUS(how) : -WTERMSIG(how);
    c->pid = 0;
    c->ended = true;
    return true;
}

static int look_after(struct child *child, int n, const struct children_watch *watch, int *running)
{
    for (int i = 0; i < n; i++) {
        if (child[i].pid == 0)
            continue;
        if (is_over(&child[i])) {
            (*running)--;
            TRY(watch->end(watch->self, i));
        } else {
            hurry(&child[i]);
        }
    }
    return STATUS_DONE;
}

static void end_all(struct child *child, int n)
{
    const double now = clock_now();
    bool left = true;

    for (int i = 0; i < n; i++)
        if (child[i].pid && !child[i].told) {
            child[i].told = now;
            kill(child[i].pid, SIGTERM);
        }
    while (left) {
        left = false;
        nanosleep(&(struct timespec){ .tv_nsec = (long)(1e9 * nap) }, NULL);
        for (int i = 0; i < n; i++)
            if (child[i].pid && !is_over(&child[i])) {
                hurry(&child[i]);
                left = true;
            }
    }
}

static int go(struct child *child, int n, int jobs, const struct children_watch *watch)
{
    int next = 0, running = 0;

    while (next < n || running > 0) {
        if (watch->asked && watch->asked())
            return status_fail(STATUS_STOPPED, "stopped by signal %d; the table holds what had "
                               "ended, and the same command goes on from there", watch->asked());
        while (next < n && running < jobs) {
            const int i = next++;
            if (watch->begin && !watch->begin(watch->self, i))
                continue;
            TRY(start(&child[i]));
            running++;
        }
        TRY(look_after(child, n, watch, &running));
        watch->look(watch->self, running);
        if (running > 0)
            nanosleep(&(struct timespec){ .tv_nsec = (long)(1e9 * nap) }, NULL);
    }
    return STATUS_DONE;
}

int children_run(struct child *child, int n, int jobs, const struct children_watch *watch)
{
    const int status = go(child, n, jobs, watch);

    end_all(child, n);
    return status;
}
