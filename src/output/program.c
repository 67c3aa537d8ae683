/* program.c -- runs another program as a child of its own. */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* posix_spawn_file_actions_addchdir_np */
#endif
#include "output/program.h"

#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

bool program_find(const char *name, char *to)
{
    const char *path = getenv("PATH");

    for (const char *at = path; at; at = strchr(at, ':')) {
        at += *at == ':';
        const int n = (int)strcspn(at, ":");
        snprintf(to, ASIDE_PATH, "%.*s/%s", n, at, name);
        if (*at == '/' && n < ASIDE_PATH - 40 && access(to, X_OK) == 0)
            return true;
    }
    return false;
}

static int spawn(const char *directory, char *const *words, const char *log, pid_t *child)
{
    char program[ASIDE_PATH];
    posix_spawn_file_actions_t actions;
    int error = program_find(words[0], program) ? posix_spawn_file_actions_init(&actions) : ENOENT;

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

int program_run(const char *directory, char *const *words, const char *log)
{
    int ended = 0;
    pid_t child;
    const int error = spawn(directory, words, log, &child);

    if (error != 0)
        return error;
    while (waitpid(child, &ended, 0) < 0)
        if (errno != EINTR)
            return errno;
    return WIFEXITED(ended) && WEXITSTATUS(ended) == 0 ? 0 : -1;
}
