/* figures-room.h -- a directory of our own in which figures are drawn, so that no script, and no
 * link, of a run's directory takes part.
 *
 *     TRY(figures_room_make(&r, run));
 *     bring scripts and data, run gnuplot in r.at
 *     status = figures_room_hang(&r);
 *
 * It lies in the run's directory, where scripts find their tables as ../NAME.csv. */
#ifndef OUTPUT_FIGURES_ROOM_H
#define OUTPUT_FIGURES_ROOM_H

#include "output/aside.h"

struct figures_room {
    char at[ASIDE_PATH];      /* RUN/.figures-XXXXXX */
    char figures[ASIDE_PATH]; /* RUN/figures         */
};

/* Makes both directories. */
int figures_room_make(struct figures_room *r, const char *run);

/* Takes away the figures in RUN/figures that we drew and that are as we left them. */
void figures_room_clear(const char *run);

/* Copies DIR/NAME into the room; NAME of RUN/figures as data, output/figures-data.h. */
int figures_room_bring(const struct figures_room *r, const char *dir, const char *name);
int figures_room_bring_data(const struct figures_room *r, const char *name);

/* Moves all that is in the room to RUN/figures, prints the names of figures and takes the room
 * away.  A file in RUN/figures that we did not leave as it is there stays, as NAME.mine,
 * NAME.mine-2, ...; figures that we had drawn and that are no longer drawn go. */
int figures_room_hang(const struct figures_room *r);

#endif
