/* status.c -- keeps the sentence of the first failure until somebody prints it. */
#include "base/status.h"

#include <stdarg.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char message[4096];
static atomic_flag taken = ATOMIC_FLAG_INIT; /* threads may fail together: one writes */

/* A sentence that did not fit ends in dots, so that nobody takes it for whole. */
static void print_cut(char *to, size_t room, const char *format, va_list arguments)
{
    const int n = vsnprintf(to, room, format, arguments);

    if (n < 0 || (size_t)n >= room)
        memcpy(to + room - 4, "...", 4);
}

int status_fail(int code, const char *format, ...)
{
    va_list arguments;

    if (atomic_flag_test_and_set(&taken))
        return code;
    va_start(arguments, format);
    print_cut(message, sizeof message, format, arguments);
    va_end(arguments);
    return code;
}

const char *status_message(void)
{
    return message;
}

void status_clear(void)
{
    message[0] = '\0';
    atomic_flag_clear(&taken);
}

void status_warn(const char *format, ...)
{
    char line[4096];
    va_list arguments;

    va_start(arguments, format);
    print_cut(line, sizeof line, format, arguments);
    va_end(arguments);
    fprintf(stderr, "stiffwater: warning: %s\n", line);
}

void *status_alloc(unsigned long count, unsigned long size)
{
    void *memory = NULL;

    if (size == 0 || count <= SIZE_MAX / size)
        memory = calloc(count > 0 ? count : 1, size > 0 ? size : 1);
    if (!memory)
        status_fail(STATUS_FAILED,
                    "out of memory: %lu pieces of %lu bytes cannot be had; use fewer particles "
                    "(a larger spacing) or a machine with more memory", count, size);
    return memory;
}
