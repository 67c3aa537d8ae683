/* patience.h -- work that may not take longer than some seconds nor more than 1 GB of memory, in a
 * process of its own.
 *
 *     ended = patience_try(3.5);
 *     if (ended == PATIENCE_BEGIN) { work; patience_done(); print; return status; }
 *     if (ended == PATIENCE_OVER) it took too much: say less */
#ifndef RUN_PATIENCE_H
#define RUN_PATIENCE_H

#include <stdbool.h>

enum { PATIENCE_BEGIN = -1, PATIENCE_OVER = -2 };

/* PATIENCE_BEGIN: here the work is to be done, which is a child, or this process when there can
 * be none.  In the parent, when the child has ended: its exit status, or PATIENCE_OVER when,
 * before patience_done(), its main thread had spent `seconds` of its processor, or the child held
 * so much memory that within the next hundredth of a second it could be 1 GB.  If the child was
 * killed otherwise, so is the parent.
 *
 * Of several ranks one may call it by itself: the child is alone (ranks_leave()) and may not return
 * from main(), but has to end by _exit(). */
int patience_try(double seconds);

/* From here on it may take as much as it likes. */
void patience_done(void);

/* In the child: all that is asked is whether it comes to patience_done(), where it ends.  Is it? */
void patience_is_all(void);
bool patience_asks(void);

#endif
