/* used.c -- all noted values as a scene file. */
#include "base/status.h"
#include "scene/tree.h"

#include <string.h>

/* Answers whether path is, or is below, the first n characters of prefix. */
static bool begins(const char *path, const char *prefix, int n)
{
    return n == 0 || (strncmp(path, prefix, (size_t)n) == 0 && (path[n] == '.' || !path[n]));
}

/* No note before number i is in the group that the first n characters of its path name. */
static bool opens_group(const struct scene *scene, int i, int n)
{
    for (int k = 0; k < i; k++)
        if (begins(scene->note[k].path, scene->note[i].path, n))
            return false;
    return true;
}

static void write_note(const struct scene_note *note, int indent, FILE *to)
{
    const char *gap = note->unit[0] && note->origin[0] ? ", " : "";

    fprintf(to, "%*s%s%s = %s;", indent, "", note->silent ? "# " : "", note->key, note->value);
    if (note->unit[0] || note->origin[0])
        fprintf(to, "  # %s%s%s", note->unit, gap, note->origin);
    fputc('\n', to);
}

static void write_group(const struct scene *scene, const char *path, int n, int indent, FILE *to);

/* The group below the first n characters of note i's path, unless it was written before. */
static void write_below(const struct scene *scene, int i, int n, int indent, FILE *to)
{
    const char *path = scene->note[i].path, *name = path + n + (n > 0);
    const int length = (int)strcspn(name, "."), all = (int)(name - path) + length;

    if (!opens_group(scene, i, all))
        return;
    fprintf(to, "%*s%.*s = {\n", indent, "", length, name);
    write_group(scene, path, all, indent + 4, to);
    fprintf(to, "%*s};\n", indent, "");
}

/* All of the group that the first n characters of path name. */
static void write_group(const struct scene *scene, const char *path, int n, int indent, FILE *to)
{
    for (int i = 0; i < scene->notes; i++) {
        const struct scene_note *note = &scene->note[i];

        if (!begins(note->path, path, n))
            continue;
        if (note->path[n])
            write_below(scene, i, n, indent, to);
        else if (note->key)
            write_note(note, indent, to);
    }
}

int scene_write_used(const struct scene *scene, FILE *to)
{
    fputs("# All parameters of the run, SI units. Running this file again gives the same bits.\n",
          to);
    write_group(scene, "", 0, 0, to);
    return ferror(to) ? status_fail(STATUS_IO, "the scene that was used cannot be written; is "
                                    "the disk full?") : STATUS_DONE;
}
