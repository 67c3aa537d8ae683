/* status.h -- how functions say that something went wrong.
 *
 * A function that can fail returns 0 or one of the codes below, which are
 * also the exit status of the program.  The sentence for the user is kept by
 * status_fail() until somebody prints it; the first failure wins, so callers
 * add nothing and simply hand the code up with TRY(). */
#ifndef BASE_STATUS_H
#define BASE_STATUS_H

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

/* The sentence of the last failure ("" if none); valid until the next one. */
const char *status_message(void);

/* Forgets the last failure: for callers that handled it. */
void status_clear(void);

/* A line on standard error that starts with "stiffwater: warning:". */
void status_warn(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* malloc(count * size), zeroed; NULL and a failure kept when there is none. */
void *status_alloc(unsigned long count, unsigned long size);

#endif
