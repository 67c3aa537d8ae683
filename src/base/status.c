/* status.c -- keeps the texts of the first failure until they are printed. */
#include "base/status.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WHAT = 4096, ADVICE = 1024 };

static struct {
    char what[WHAT], cause[ADVICE], remedy[ADVICE]; /* what happened; "" or advice */
    char message[WHAT + 2 * ADVICE + 4];            /* all of them                 */
} kept;
static char *warned[STATUS_WARNINGS]; /* to be told again */
static bool hushed;
static atomic_flag taken = ATOMIC_FLAG_INIT; /* threads may fail together: one writes */

/* A text that did not fit ends in dots, so that it is not taken for whole. */
static void mark_cut(char *to, size_t room, int n)
{
    if (n < 0 || (size_t)n >= room)
        memcpy(to + room - 4, "...", 4);
}

const char *status_plain(char *text)
{
    for (char *at = text; *at; at++)
        if (iscntrl((unsigned char)*at) && *at != '\n')
            *at = *at == '\t' ? ' ' : '?';
    return text;
}

static void print_cut(char *to, size_t room, const char *format, va_list arguments)
{
    mark_cut(to, room, vsnprintf(to, room, format, arguments));
    status_plain(to);
}

/* Puts a text behind another one, which may be empty. */
static void append(char *to, size_t room, const char *text)
{
    const size_t n = strlen(to);
    const char *joint = n == 0 ? "" : isupper((unsigned char)text[0]) ? ". " : "; ";

    if (text[0] && n + 4 < room)
        mark_cut(to + n, room - n, snprintf(to + n, room - n, "%s%s", joint, text));
}

static void compose(void)
{
    kept.message[0] = '\0';
    append(kept.message, sizeof kept.message, kept.what);
    append(kept.message, sizeof kept.message, kept.cause);
    append(kept.message, sizeof kept.message, kept.remedy);
}

static void add(struct status_advice advice)
{
    append(kept.cause, sizeof kept.cause, advice.cause ? advice.cause : "");
    append(kept.remedy, sizeof kept.remedy, advice.remedy ? advice.remedy : "");
    compose();
}

static void keep(struct status_advice advice, const char *format, va_list arguments)
{
    if (atomic_flag_test_and_set(&taken))
        return;
    print_cut(kept.what, sizeof kept.what, format, arguments);
    add(advice);
}

int status_fail(int code, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    keep((struct status_advice){ 0 }, format, arguments);
    va_end(arguments);
    return code;
}

int status_fail_with(int code, struct status_advice advice, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    keep(advice, format, arguments);
    va_end(arguments);
    return code;
}

void status_advise(struct status_advice advice)
{
    if (kept.what[0])
        add(advice);
}

bool status_has_cause(void)
{
    return kept.cause[0];
}

bool status_has_remedy(void)
{
    return kept.remedy[0];
}

const char *status_message(void)
{
    return kept.message;
}

void status_clear(void)
{
    kept.what[0] = kept.cause[0] = kept.remedy[0] = kept.message[0] = '\0';
    atomic_flag_clear(&taken);
}

void status_warn(const char *format, ...)
{
    char line[4096];
    va_list arguments;

    if (hushed)
        return;
    va_start(arguments, format);
    print_cut(line, sizeof line, format, arguments);
    va_end(arguments);
    fprintf(stderr, "stiffwater: warning: %s\n", line);
    for (int i = 0; i < STATUS_WARNINGS; i++)
        if (!warned[i]) {
            warned[i] = strdup(line);
            return;
        }
}

void status_hush(bool on)
{
    hushed = on;
}

const char *status_warning(int i)
{
    return i < STATUS_WARNINGS ? warned[i] : NULL;
}

void *status_alloc(unsigned long count, unsigned long size)
{
    void *memory = NULL;

    if (size == 0 || count <= SIZE_MAX / size)
        memory = calloc(count > 0 ? count : 1, size > 0 ? size : 1);
    if (!memory)
        status_fail_with(STATUS_FAILED,
                         (struct status_advice){ .remedy = "use fewer particles (a larger "
                                                 "spacing) or a machine with more memory" },
                         "out of memory: %lu pieces of %lu bytes cannot be had", count, size);
    return memory;
}
