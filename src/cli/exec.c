/* exec.c -- hands over to the program of the scene's dimension. */
#include "cli/cli.h"

#include "base/status.h"
#include "scene/scene.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#ifndef STIFFWATER_LIBEXECDIR
#define STIFFWATER_LIBEXECDIR "/usr/local/libexec/stiffwater"
#endif

/* Directory of the running program; when it cannot be told one that is not there, rather than
 * the one we are in, which may be anybody's. */
static void own_directory(char *to, size_t size)
{
    const ssize_t n = readlink("/proc/self/exe", to, size - 1);
    char *slash;

    to[n > 0 ? n : 0] = '\0';
    slash = strrchr(to, '/');
    if (slash)
        *slash = '\0';
    else
        snprintf(to, size, "/proc/self/exe");
}

#ifndef STIFFWATER_DATADIR
#define STIFFWATER_DATADIR "/usr/local/share/stiffwater"
#endif

const char *cli_data(void)
{
    static char own[PATH_MAX - 64];
    char plots[PATH_MAX];

    own_directory(own, sizeof own);
    snprintf(plots, sizeof plots, "%s/plots", own);
    if (access(plots, R_OK) != 0)
        snprintf(own, sizeof own, "%s", STIFFWATER_DATADIR);
    return own;
}

void cli_beside(char *path, size_t size, int dimension, const char *kind)
{
    char own[PATH_MAX - 64];

    own_directory(own, sizeof own);
    snprintf(path, size, "%s/stiffwater-%dd%s", own, dimension, kind);
}

int cli_exec(int dimension, char **argv)
{
    char own[PATH_MAX - 64], path[PATH_MAX];

    own_directory(own, sizeof own);
    cli_beside(path, sizeof path, dimension, "");
    if (access(path, X_OK) != 0) /* installed, perhaps moved with its whole prefix */
        snprintf(path, sizeof path, "%s/../libexec/stiffwater/stiffwater-%dd", own, dimension);
    if (access(path, X_OK) != 0)
        snprintf(path, sizeof path, "%s/stiffwater-%dd", STIFFWATER_LIBEXECDIR, dimension);
    cli_huge_pages();
    execv(path, argv);
    return status_fail(STATUS_IO, "%s: %s; the programs stiffwater-2d and stiffwater-3d belong "
                       "beside stiffwater or into %s: install again", path, strerror(errno),
                       STIFFWATER_LIBEXECDIR);
}

struct dimension {
    int dimension;
};

static const struct param rows[] = {
    { .key = "dimension", .unit = "", .type = PARAM_INTEGER,
      .offset = offsetof(struct dimension, dimension), .fallback = 2, .min = 2, .max = 3,
      .about = "2 or 3" },
    { 0 },
};

/* Only the dimension matters here; every other key is the private program's. */
static int read_dimension(struct scene *scene, int *dimension)
{
    const struct scene_node *root = scene_root(scene);
    const int n = scene_count(root);
    const char **also = status_alloc(n + 1, sizeof *also);
    struct dimension d = { 2 };
    int status;

    if (!also)
        return STATUS_FAILED;
    for (int i = 0; i < n; i++)
        also[i] = scene_name(scene_at(root, i));
    status = scene_fill(scene, root, "", rows, also, 2, &d);
    free(also);
    *dimension = d.dimension;
    return status;
}

int cli_dimension(const struct cli *c, int *dimension)
{
    struct scene *scene = NULL;
    int status = scene_read(c->subject, &scene);

    for (int i = 0; i < c->overrides && status == STATUS_DONE; i++)
        status = scene_override(scene, c->override[i]);
    if (status == STATUS_DONE)
        status = read_dimension(scene, dimension);
    scene_free(&scene);
    return status;
}
