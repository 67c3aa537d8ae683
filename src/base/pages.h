/* pages.h -- how much memory there is for an array of which some entries alone are written.
 *
 * A process has memory for whole pages of those that it writes to, as long as an array comes
 * from the system, zeroed. */
#ifndef BASE_PAGES_H
#define BASE_PAGES_H

#include <stddef.h>

/* Bytes of the pages that hold entries 0 .. from-1 and row[0] .. row[n-1], of `size` bytes each, of an
 * array that begins with a page.  Where there is no memory to find out: as if no two of these n had a
 * page together. */
double pages_bytes(long from, long n, const int *row, size_t size);

#endif
