/* figures-record.c -- which files of RUN/figures are ours and as we left them. */
#include "output/figures-record.h"

#include "base/status.h"
#include "output/aside.h"
#include "output/hash.h"

#include <string.h>
#include <unistd.h>

static int find(const struct figures_record *r, const char *name)
{
    for (int i = 0; i < r->n; i++)
        if (strcmp(r->file[i].name, name) == 0)
            return i;
    return -1;
}

static void put(struct figures_record *r, const char *name, const char *hash)
{
    const int found = find(r, name), i = found < 0 ? r->n : found;

    if (i == FIGURES_RECORD_MOST || strlen(name) >= FIGURES_RECORD_NAME || strchr(name, '/'))
        return;
    r->n += found < 0;
    snprintf(r->file[i].name, sizeof r->file[i].name, "%s", name);
    snprintf(r->file[i].hash, sizeof r->file[i].hash, "%s", hash);
}

void figures_record_read(struct figures_record *r, const char *dir)
{
    char path[ASIDE_PATH], line[400], name[FIGURES_RECORD_NAME], hash[40];
    FILE *in;

    r->n = 0;
    if (aside_join(path, dir, ".drawn") != STATUS_DONE)
        return;
    in = fopen(path, "r");
    while (in && fgets(line, sizeof line, in))
        if (sscanf(line, "%39s %199[^\n]", hash, name) == 2)
            put(r, name, hash);
    if (in)
        fclose(in);
}

int figures_record_write(const struct figures_record *r, const char *dir)
{
    char path[ASIDE_PATH];
    struct aside a;

    TRY(aside_join(path, dir, ".drawn"));
    TRY(aside_open(&a, path));
    for (int i = 0; i < r->n; i++)
        fprintf(a.to, "%s %s\n", r->file[i].hash, r->file[i].name);
    return aside_close(&a);
}

bool figures_record_has(const struct figures_record *r, const char *name)
{
    return find(r, name) >= 0;
}

/* Of a file's bytes; "" when it cannot be read. */
static void hash_of(const char *dir, const char *name, char *to, size_t size)
{
    char path[ASIDE_PATH], text[HASH_TEXT], bytes[4096];
    uint64_t hash = HASH_START;
    size_t n;
    FILE *in = aside_join(path, dir, name) == STATUS_DONE ? fopen(path, "r") : NULL;

    *to = '\0';
    if (!in)
        return;
    while ((n = fread(bytes, 1, sizeof bytes, in)) > 0)
        hash = hash_bytes(hash, bytes, n);
    fclose(in);
    snprintf(to, size, "%s", hash_text(hash, text));
}

bool figures_record_foreign(const struct figures_record *r, const char *dir, const char *name)
{
    const int found = find(r, name);
    char path[ASIDE_PATH], hash[40];

    if (aside_join(path, dir, name) != STATUS_DONE || access(path, F_OK) != 0)
        return false;
    hash_of(dir, name, hash, sizeof hash);
    return found < 0 || strcmp(hash, r->file[found].hash) != 0;
}

void figures_record_add(struct figures_record *r, const char *dir, const char *name)
{
    char hash[40];

    hash_of(dir, name, hash, sizeof hash);
    if (*hash)
        put(r, name, hash);
}
