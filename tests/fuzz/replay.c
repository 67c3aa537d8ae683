/* replay.c -- see replay.h. */
#include "replay.h"

#include "bytes.h"

#include <dirent.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

static uint8_t *contents(const char *path, size_t *n)
{
    FILE *from = fopen(path, "rb");
    uint8_t *bytes;

    if (!from || fseek(from, 0, SEEK_END) != 0)
        abort();
    *n = (size_t)ftell(from);
    rewind(from);
    bytes = malloc(*n + 1);
    if (!bytes || fread(bytes, 1, *n, from) != *n)
        abort();
    fclose(from);
    return bytes;
}

/* What the program says of a wrong input would not be TAP. */
static int give(const char *path)
{
    size_t n;
    uint8_t *bytes = contents(path, &n);

    if (!freopen("/dev/null", "w", stdout))
        abort();
    LLVMFuzzerTestOneInput(bytes, n);
    free(bytes);
    return EXIT_SUCCESS;
}

static bool survives(const char *path)
{
    pid_t child;
    int how = 0;

    fflush(stdout);
    child = fork();
    if (child == 0)
        exit(give(path));
    return child > 0 && waitpid(child, &how, 0) == child && WIFEXITED(how)
        && WEXITSTATUS(how) == EXIT_SUCCESS;
}

int replay(const char *name)
{
    const char *top = getenv("top_srcdir");
    char folder[1024], path[2048];
    struct dirent **file;
    int tried = 0, n;
    bool bad = false;

    snprintf(folder, sizeof folder, "%s/tests/fuzz/corpus/%s", top ? top : ".", name);
    n = scandir(folder, &file, NULL, alphasort);
    for (int i = 0; i < n; i++) {
        snprintf(path, sizeof path, "%s/%s", folder, file[i]->d_name);
        if (file[i]->d_name[0] != '.') {
            const bool good = survives(path);
            printf("%sok %d - %s/%s\n", good ? "" : "not ", ++tried, name, file[i]->d_name);
            bad |= !good;
        }
        free(file[i]);
    }
    if (n >= 0)
        free(file);
    printf("1..%d\n", tried);
    return tried == 0 || bad;
}
