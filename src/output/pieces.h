/* pieces.h -- files to which all ranks write.
 *
 * The first rank opens a file and writes what is small, HDF5's own bytes among it; each rank then
 * writes its rows of the large arrays where they belong, so that no rank needs all of them, and the file
 * has the bytes that one rank would have written.  All ranks must see the same directory. */
#ifndef OUTPUT_PIECES_H
#define OUTPUT_PIECES_H

#include "output/aside.h"
#include "output/image.h"

#include <stdbool.h>

/* Rows of an array that this rank has. */
struct piece {
    int array;      /* which of those that an image leaves out                    */
    long from, n;   /* rows: the first of them in the array, how many             */
    size_t bytes;   /* of a row                                                   */
    void (*fill)(const void *self, long first, long n, void *to); /* rows `first` .. of these n */
    const void *self;
};

struct pieces {
    bool shared;    /* all ranks write; else the first has all rows               */
    int n;
    const struct piece *piece;
};

/* Writes them into the file that the first rank has open as `a`, with this status: there the image begins
 * at byte `ahead`.  `safely`: they are on the disk; those of other ranks than the first are in any case.
 * Where pieces are shared all ranks call it, others with a and image NULL, and all have the first status
 * that is none: STATUS_FAILED, STATUS_IO. */
int pieces_write(int status, struct aside *a, const struct image *image, long ahead,
                 const struct pieces *pieces, bool safely);

/* A fill() for numbers, self [n], bytes that of one. */
void pieces_numbers(const void *self, long first, long n, void *to);

#endif
