/* json.c -- a small JSON writer (RFC 8259): objects, numbers, texts, flags. */
#include "output/json.h"

#include "base/status.h"
#include "output/aside.h"
#include "output/utf8.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct json {
    struct aside file;
    int depth;  /* open objects, the outermost included */
    bool first; /* nothing stands in the innermost yet  */
};

int json_open(struct json **out, const char *path)
{
    struct json *j = status_alloc(1, sizeof *j);

    if (!j)
        return STATUS_FAILED;
    if (aside_open(&j->file, path) != STATUS_DONE) {
        free(j);
        return STATUS_IO;
    }
    fputc('{', j->file.to);
    j->depth = 1;
    j->first = true;
    *out = j;
    return STATUS_DONE;
}

/* Names of files may hold any bytes: what is no UTF-8 becomes U+FFFD. */
static void quoted(FILE *to, const char *text)
{
    const unsigned char *s = (const unsigned char *)text;

    fputc('"', to);
    while (*s) {
        const int n = utf8_sequence(s);
        if (n == 0)
            fputs("\\ufffd", to);
        else if (*s == '"' || *s == '\\')
            fprintf(to, "\\%c", *s);
        else if (*s < 0x20 || *s == 0x7f)
            fprintf(to, "\\u%04x", *s);
        else
            fwrite(s, 1, (size_t)n, to);
        s += n > 0 ? n : 1;
    }
    fputc('"', to);
}

static void new_line(struct json *j)
{
    fprintf(j->file.to, "\n%*s", 2 * j->depth, "");
}

static void start(struct json *j, const char *key)
{
    if (!j->first)
        fputc(',', j->file.to);
    j->first = false;
    new_line(j);
    quoted(j->file.to, key);
    fputs(": ", j->file.to);
}

void json_number(struct json *j, const char *key, double value)
{
    start(j, key);
    if (isfinite(value))
        fprintf(j->file.to, "%.17g", value);
    else
        fputs("null", j->file.to);
}

void json_integer(struct json *j, const char *key, long long value)
{
    start(j, key);
    fprintf(j->file.to, "%lld", value);
}

void json_flag(struct json *j, const char *key, bool value)
{
    start(j, key);
    fputs(value ? "true" : "false", j->file.to);
}

void json_text(struct json *j, const char *key, const char *text)
{
    start(j, key);
    if (text)
        quoted(j->file.to, text);
    else
        fputs("null", j->file.to);
}

void json_texts(struct json *j, const char *key, int n, const char *const *texts)
{
    start(j, key);
    fputc('[', j->file.to);
    j->depth++;
    for (int i = 0; i < n; i++) {
        fputs(i > 0 ? "," : "", j->file.to);
        new_line(j);
        quoted(j->file.to, texts[i]);
    }
    j->depth--;
    if (n > 0)
        new_line(j);
    fputc(']', j->file.to);
}

void json_object(struct json *j, const char *key)
{
    start(j, key);
    fputc('{', j->file.to);
    j->depth++;
    j->first = true;
}

void json_end(struct json *j)
{
    j->depth--;
    if (!j->first)
        new_line(j);
    fputc('}', j->file.to);
    j->first = false;
}

int json_close(struct json **json)
{
    struct json *j = *json;
    int code;

    while (j->depth > 0)
        json_end(j);
    fputc('\n', j->file.to);
    code = aside_close(&j->file);
    free(j);
    *json = NULL;
    return code;
}
