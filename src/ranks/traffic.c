/* traffic.c -- how much this rank sends. */
#include "ranks/traffic.h"

static struct ranks_traffic all;

struct ranks_traffic ranks_traffic(void)
{
    return all;
}

void ranks_traffic_ask(double bytes)
{
    all.asked++;
    all.asked_bytes += bytes;
}

void ranks_traffic_gather(double bytes)
{
    all.gathers++;
    all.gathered_bytes += bytes;
}

void ranks_traffic_exchange(double messages, double bytes)
{
    all.exchanges++;
    all.messages += messages;
    all.sent_bytes += bytes;
}
