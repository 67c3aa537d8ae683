/* json-find.h -- what stands behind a key in a file that output/json.h wrote, in whatever
 * object. */
#ifndef OUTPUT_JSON_FIND_H
#define OUTPUT_JSON_FIND_H

#include <stdbool.h>

/* The number behind "KEY":, NAN if there is none. */
double json_find_number(const char *path, const char *key);

/* The text behind "KEY":, cut to size; false and "" if there is none. */
bool json_find_text(const char *path, const char *key, char *to, unsigned long size);

/* Text i = 0, 1, ... of the list behind "KEY":, likewise. */
bool json_find_item(const char *path, const char *key, int i, char *to, unsigned long size);

#endif
