/* checkpoint.c -- fuzzes what reads checkpoints: the file, and the archive that it becomes.
 *
 * First the bytes are such a file.  Then they are entries of an archive, 16 bytes and a name
 * each, which is asked for arrays that it may have or not. */
#include "bytes.h"

#include "base/archive.h"
#include "base/status.h"
#include "output/archive-file.h"

#include <string.h>

enum { ENTRY = 4 };

static void read_file(const uint8_t *bytes, size_t n)
{
    struct archive *a = NULL;
    bool found;
    char path[64];
    const int file = bytes_open(bytes, n, path);

    archive_file_read(path, &found, &a);
    archive_free(&a);
    close(file);
    status_forgive();
}

/* type, length, first letter of the name, what is asked for */
static void ask(struct archive *a, const uint8_t *e)
{
    const char name[] = { (char)('a' + e[2] % 8), '\0' };
    double number[256];
    long integer[256];
    char text[64];

    switch (e[3] % 4) {
    case 0: archive_numbers(a, name, number, e[1]); break;
    case 1: archive_integers(a, name, integer, e[1]); break;
    case 2: archive_text(a, name, text, sizeof text - e[1] % 32); break;
    default: archive_spent(a);
    }
}

static void make_archive(const uint8_t *bytes, size_t n)
{
    static const double data[256];
    struct archive *a;

    if (archive_create(&a) != STATUS_DONE)
        return;
    for (size_t i = 0; i + ENTRY <= n; i += ENTRY) {
        const char name[] = { (char)('a' + bytes[i + 2] % 8), '\0' };
        archive_add(a, name, (enum archive_type)(bytes[i] % 3), bytes[i + 1], data);
        status_forgive();
    }
    archive_turn(a);
    for (size_t i = 0; i + ENTRY <= n; i += ENTRY) {
        archive_try(a, bytes[i] & 128);
        ask(a, bytes + i);
        status_forgive();
    }
    archive_free(&a);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t n)
{
    read_file(bytes, n);
    make_archive(bytes, n);
    return 0;
}
