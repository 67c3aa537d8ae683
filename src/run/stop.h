/* stop.h -- SIGINT, SIGTERM and SIGHUP ask a run to end with complete files. */
#ifndef RUN_STOP_H
#define RUN_STOP_H

#include <stdbool.h>

void stop_leave(void);  /* until then a signal ends the program, STATUS_STOPPED */
void stop_listen(void); /* from now on signals are only noted; one that comes
                         * more than a second after the first kills            */
int stop_asked(void);   /* the signal that came, 0: none                       */
bool stop_urgent(void); /* it came more than half a second ago                 */

#endif
