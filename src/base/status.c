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
    bool starved;                                   /* of memory                   */
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

static bool keep(struct status_advice advice, const char *format, va_list arguments)
{
    if (atomic_flag_test_and_set(&taken))
        return false;
    print_cut(kept.what, sizeof kept.what, format, arguments);
    add(advice);
    return true;
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

static int keep_starved(struct status_advice advice, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    if (keep(advice, format, arguments))
        kept.starved = true;
    va_end(arguments);
    return STATUS_FAILED;
}

int status_starved(const char *format, ...)
{
    static const struct status_advice fewer = {
        .remedy = "use fewer particles (a larger spacing) or a machine with more memory" };
    char text[WHAT] = "out of memory: ";
    const size_t n = strlen(text);
    va_list arguments;

    va_start(arguments, format);
    mark_cut(text + n, sizeof text - n, vsnprintf(text + n, sizeof text - n, format, arguments));
    va_end(arguments);
    return keep_starved(fewer, "%s", text);
}

bool status_is_starved(void)
{
    return kept.starved;
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

void status_forgive(void)
{
    kept.what[0] = kept.cause[0] = kept.remedy[0] = kept.message[0] = '\0';
    kept.starved = false;
    atomic_flag_clear(&taken);
}

void status_clear(void)
{
    if (!kept.starved)
        status_forgive();
}

static void keep_warning(const char *line)
{
    for (int i = 0; i < STATUS_WARNINGS; i++)
        if (!warned[i]) {
            warned[i] = strdup(line);
            return;
        }
}

void status_warn(const char *format, ...)
{
    char line[STATUS_LINE];
    va_list arguments;

    if (hushed)
        return;
    va_start(arguments, format);
    print_cut(line, sizeof line, format, arguments);
    va_end(arguments);
    fprintf(stderr, "stiffwater: warning: %s\n", line);
    keep_warning(line);
}

void status_recall(const char *warning)
{
    for (int i = 0; i < STATUS_WARNINGS && warned[i]; i++)
        if (strcmp(warned[i], warning) == 0)
            return;
    keep_warning(warning);
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
        status_starved("%lu pieces of %lu bytes cannot be had", count, size);
    return memory;
}

int status_reserve(unsigned long bytes, const char *what)
{
    void *memory = malloc(bytes);

    free(memory);
    return memory ? STATUS_DONE : status_starved("%lu bytes for %s cannot be had", bytes, what);
}
