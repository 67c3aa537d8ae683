/* patience.h -- work that may not take longer than some seconds, in a process of its own.
 *
 *     ended = patience_try(3.5);
 *     if (ended == PATIENCE_BEGIN) { work; patience_done(); print; return status; }
 *     if (ended == PATIENCE_OVER) it took too long: say less */
#ifndef RUN_PATIENCE_H
#define RUN_PATIENCE_H

enum { PATIENCE_BEGIN = -1, PATIENCE_OVER = -2 };

/* PATIENCE_BEGIN: here the work is to be done, which is a child, or this process when there can
 * be none.  In the parent, when the child has ended: its exit status, or PATIENCE_OVER when its
 * main thread had spent `seconds` of its processor before patience_done().  If the child was
 * killed otherwise, so is the parent. */
int patience_try(double seconds);

/* From here on it may take as long as it likes. */
void patience_done(void);

#endif
