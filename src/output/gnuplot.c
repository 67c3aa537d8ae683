/* gnuplot.c -- runs gnuplot as a child of its own, in the directory of the figures. */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* posix_spawn_file_actions_addchdir_np */
#endif
#include "output/gnuplot.h"

#include "base/status.h"
#include "output/aside.h"
#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

/* The first gnuplot in PATH [ASIDE_PATH].  Places that depend on where we are do not count: what
 * is called so in a run's directory need not be gnuplot. */
static bool find_gnuplot(char *to)
{
    const char *path = getenv("PATH");

    for (const char *at = path; at; at = strchr(at, ':')) {
        at += *at == ':';
        const int n = (int)strcspn(at, ":");
        snprintf(to, ASIDE_PATH, "%.*s/gnuplot", n, at);
        if (*at == '/' && n < ASIDE_PATH - 16 && access(to, X_OK) == 0)
            return true;
    }
    return false;
}

/* -d: the user's ~/.gnuplot does not change our figures */
static int spawn(const char *directory, const char *script, const char *log, pid_t *child)
{
    char program[ASIDE_PATH];
    char *const words[] = { "gnuplot", "-d", (char *)script, NULL };
    posix_spawn_file_actions_t actions;
    int error = find_gnuplot(program) ? posix_spawn_file_actions_init(&actions) : ENOENT;

    if (error != 0)
        return error;
    error = posix_spawn_file_actions_addchdir_np(&actions, directory);
    if (error == 0)
        error = posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (error == 0)
        error = posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, log,
                                                 O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (error == 0)
        error = posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
    if (error == 0)
        error = posix_spawn(child, program, &actions, NULL, words, environ);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

static int refused(int error)
{
    if (error == ENOENT)
        return status_fail(STATUS_IO,
                           "gnuplot was not found, so no figures were drawn; the data "
                           "are complete. On Debian: apt-get install gnuplot-nox; then draw them "
                           "with `stiffwater plot DIR`");
    return status_fail(STATUS_IO, "gnuplot cannot be started: %s", strerror(error));
}

int gnuplot_run(const char *directory, const char *script, const char *shown)
{
    char name[ASIDE_PATH], log[ASIDE_PATH];
    int error, ended = 0;
    pid_t child;

    TRY(aside_join(log, directory, script));
    snprintf(name, sizeof name, "%s.log", script);
    TRY(aside_join(log, directory, name));
    error = spawn(directory, script, name, &child);
    if (error != 0)
        return refused(error);
    while (waitpid(child, &ended, 0) < 0)
        if (errno != EINTR)
            return status_fail(STATUS_IO, "gnuplot was lost: %s", strerror(errno));
    if (!WIFEXITED(ended) || WEXITSTATUS(ended) != 0)
        return status_fail(STATUS_IO, "gnuplot could not draw %s/%s; what it said is in %s/%s",
                           shown, script, shown, name);
    remove(log);
    return STATUS_DONE;
}
