/* traffic.h -- what this rank has sent so far, as mpi*.c note it; without MPI nothing. */
#ifndef RANKS_TRAFFIC_H
#define RANKS_TRAFFIC_H

/* Times that all asked all (sums, maxima, bids), and bytes of a question; times that rows went from
 * all to all, and bytes of this rank's; uses of routes, messages and bytes on them. */
struct ranks_traffic {
    double asked, asked_bytes, gathers, gathered_bytes, exchanges, messages, sent_bytes;
};

struct ranks_traffic ranks_traffic(void);

/* Of one more. */
void ranks_traffic_ask(double bytes);
void ranks_traffic_gather(double bytes);
void ranks_traffic_exchange(double messages, double bytes);

#endif
