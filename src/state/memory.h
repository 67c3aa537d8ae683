/* memory.h -- how much memory this machine can give, and how much was taken. */
#ifndef STATE_MEMORY_H
#define STATE_MEMORY_H

/* Bytes free for programs: MemAvailable of a file like /proc/meminfo; where
 * there is none, the free pages that sysconf() knows of; 0: unknown. */
double memory_available(const char *meminfo);

/* The most that this program has held so far [bytes]. */
double memory_peak(void);

#endif
