/* table.c -- fuzzes the tables that comparisons read of their runs. */
#include "bytes.h"

#include "output/table.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t n)
{
    struct table t = { 0 };
    char path[64], unit[8];
    const int file = bytes_open(bytes, n, path);

    if (table_read(&t, path)) {
        for (int i = 0; i < t.columns; i++) {
            table_unit(&t, i, unit, sizeof unit);
            table_column(&t, t.name[i]);
        }
        for (int i = 0; i < t.rows; i++)
            table_at(&t, i, t.columns - 1);
        if (table_alike(&t, &t))
            table_same_times(&t, &t);
    }
    table_free(&t);
    close(file);
    return 0;
}
