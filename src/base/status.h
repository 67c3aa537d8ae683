/* status.h -- how functions say that something went wrong.
 *
 * A function that can fail returns 0 or one of the codes below, which are
 * also the exit status of the program.  The sentence for the user is kept by
 * status_fail() until it is printed; the first failure wins, so callers
 * add nothing and simply hand the code up with TRY().
 *
 * What happened, where, and with which value is one text; the likely cause and what to
 * change are two more.  They become one sentence only in status_message(): code that
 * wants to know whether there is advice asks status_has_remedy(). */
#ifndef BASE_STATUS_H
#define BASE_STATUS_H

#include <stdbool.h>

enum status {
    STATUS_DONE = 0,      /* all is well                                    */
    STATUS_FAILED = 1,    /* the run failed: diverged, step collapsed       */
    STATUS_BAD_SCENE = 2, /* the scene or the command line is wrong         */
    STATUS_STOPPED = 3,   /* stopped on request, outputs closed             */
    STATUS_IO = 4         /* input or output failed                         */
};

#define TRY(call)                 \
    do {                          \
        const int try_ = (call);  \
        if (try_ != STATUS_DONE)  \
            return try_;          \
    } while (0)

/* Keeps the message and returns code, for `return status_fail(...)`. */
int status_fail(int code, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* What there is to say beside what happened; NULL or "": nothing.  A text that begins with
 * a capital letter is printed as a sentence, another one goes on behind a semicolon. */
struct status_advice {
    const char *cause;  /* why, most likely: "The step is longer than is stable" */
    const char *remedy; /* what to change: "take a higher eos.c0"                */
};

/* The same, with advice, which is copied: a failure that is not kept adds none. */
int status_fail_with(int code, struct status_advice advice, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Adds advice to the failure that is kept, behind what it has already; nothing if there
 * is no failure. */
void status_advise(struct status_advice advice);

/* Does the failure that is kept say why, or what to change? */
bool status_has_cause(void);
bool status_has_remedy(void);

/* What happened, the cause and the remedy of the failure that is kept, in this order ("" if
 * there is none); valid until the next one. */
const char *status_message(void);

/* Memory that could not be had: STATUS_FAILED, "out of memory: " and the text, with what to
 * change.  No shorter step mends that, so status_clear() does not forget it. */
int status_starved(const char *format, ...) __attribute__((format(printf, 1, 2)));
bool status_is_starved(void);

/* Forgets the last failure: for callers that handled it; any, also one of memory. */
void status_clear(void);
void status_forgive(void);

/* Control characters of text become "?", so that what is quoted does not command the terminal;
 * messages are such.  Returns text. */
const char *status_plain(char *text);

/* A line on standard error that starts with "stiffwater: warning:". */
void status_warn(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* The warnings so far, the first STATUS_WARNINGS of them: i = 0, 1, ...; NULL: no more. */
enum { STATUS_WARNINGS = 20, STATUS_LINE = 4096 };
const char *status_warning(int i);

/* One of an earlier part of a run: kept, unless it is there already, and not printed. */
void status_recall(const char *warning);

/* Warnings are neither printed nor kept while this is on: for a look at a scene that nobody asked
 * for. */
void status_hush(bool on);

/* malloc(count * size), zeroed; NULL and a failure kept when there is none. */
void *status_alloc(unsigned long count, unsigned long size);

/* Could so many bytes be had now?  For what libraries will ask for that crash without it;
 * STATUS_FAILED says what they are for. */
int status_reserve(unsigned long bytes, const char *what);

#endif
