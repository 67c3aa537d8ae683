/* children.c -- runs programs side by side, each with a limit of time. */
#include "study/children.h"

#include "base/status.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

extern char **environ;

static const double patience = 20;  /* [s] between SIGTERM and SIGKILL */
static const double nap = 0.01;     /* [s] between two looks           */

static double clock_now(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int spawn(struct child *c)
{
    posix_spawn_file_actions_t actions;
    int error = posix_spawn_file_actions_init(&actions);

    if (error != 0)
        return error;
    error = posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (error == 0)
        error = posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, c->said,
                                                 O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (error == 0)
        error = posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
    if (error == 0)
        error = posix_spawnp(&c->pid, c->words[0], &actions, NULL, c->words, environ);
    posix_spawn_file_actions_destroy(&actions);
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
