/* instructions.c -- counts instructions by stepping through a copy of the process. */
#define _GNU_SOURCE
#include "instructions.h"

#include <link.h>
#include <signal.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ptrace.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

/* Where code lies. */
struct code {
    uintptr_t from, to;
};

/* The program's own, and what is not counted: libgomp, which takes a team of threads from the
 * heap for every loop, and what it calls cost by how the heap happens to lie; copies of memory
 * by libc by how their two ends are aligned. */
struct codes {
    struct code own, gomp, libc;
};

static int find_code(struct dl_phdr_info *info, size_t size, void *found)
{
    struct codes *codes = found;
    struct code code = { 0 };

    (void)size;
    for (int i = 0; i < info->dlpi_phnum; i++)
        if (info->dlpi_phdr[i].p_flags & PF_X)
            code = (struct code){ info->dlpi_addr + info->dlpi_phdr[i].p_vaddr,
                                  info->dlpi_addr + info->dlpi_phdr[i].p_vaddr
                                      + info->dlpi_phdr[i].p_memsz };
    if (info->dlpi_name[0] == '\0')
        codes->own = code;
    if (strstr(info->dlpi_name, "libgomp"))
        codes->gomp = code;
    if (strstr(info->dlpi_name, "/libc.so"))
        codes->libc = code;
    return 0;
}

static void copy(void (*work)(void *with), void *with)
{
    if (ptrace(PTRACE_TRACEME, 0, 0, 0))
        _exit(1);
    raise(SIGSTOP);
    work(with);
    raise(SIGSTOP);
    _exit(0);
}

static bool among(const struct code *code, uintptr_t at)
{
    return at >= code->from && at < code->to;
}

/* Is the next instruction one of those that are not counted, or of a library that libgomp has
 * called?  `before`: was the last.  Elsewhere than on x86-64 that is not asked. */
static bool apart(pid_t pid, const struct codes *codes, bool before)
{
#ifdef __x86_64__
    struct user_regs_struct at;

    if (ptrace(PTRACE_GETREGS, pid, 0, &at) == 0)
        return among(&codes->gomp, at.rip) || among(&codes->libc, at.rip)
               || (before && !among(&codes->own, at.rip));
#endif
    (void)pid;
    (void)codes;
    return before;
}

/* Steps until the copy stops itself again; -1: it ended, or may not be traced. */
static long count(pid_t pid, const struct codes *codes)
{
    bool beside = false;
    long n = 0;
    int status;

    if (waitpid(pid, &status, 0) != pid || !WIFSTOPPED(status))
        return -1;
    for (;;) {
        beside = apart(pid, codes, beside);
        if (ptrace(PTRACE_SINGLESTEP, pid, 0, 0) || waitpid(pid, &status, 0) != pid
            || !WIFSTOPPED(status))
            return -1;
        if (WSTOPSIG(status) != SIGTRAP)
            return n;
        n += !beside;
    }
}

long instructions_of(void (*work)(void *with), void *with)
{
    struct codes codes = { 0 };
    const pid_t pid = fork();
    long n;

    if (pid < 0)
        return -1;
    if (pid == 0)
        copy(work, with);
    dl_iterate_phdr(find_code, &codes);
    n = count(pid, &codes);
    kill(pid, SIGKILL);
    waitpid(pid, NULL, 0);
    return n;
}
