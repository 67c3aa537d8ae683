/* json.h -- writes one JSON object to a file, whole or not at all.
 *
 *     TRY(json_open(&json, "out/run.json"));
 *     json_text(json, "status", "done");
 *     json_object(json, "particles");
 *     json_integer(json, "fluid", 1800);
 *     json_end(json);
 *     TRY(json_close(&json));
 *
 * Only opening and closing can fail: writes that went wrong are told there. */
#ifndef OUTPUT_JSON_H
#define OUTPUT_JSON_H

#include <stdbool.h>

struct json;

int json_open(struct json **out, const char *path);

void json_number(struct json *j, const char *key, double value); /* %.17g; not finite: null */
void json_integer(struct json *j, const char *key, long long value);
void json_flag(struct json *j, const char *key, bool value);
void json_text(struct json *j, const char *key, const char *text); /* NULL: null */
/* A list of n texts, each on a line of its own. */
void json_texts(struct json *j, const char *key, int n, const char *const *texts);

void json_object(struct json *j, const char *key); /* what follows belongs to key ... */
void json_end(struct json *j);                     /* ... until here                  */

/* Ends all objects that are open, renames the file into place, frees. */
int json_close(struct json **json);

#endif
