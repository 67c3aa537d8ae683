/* movie.c -- a movie of a run's particle files: tables, drawn in a room of their own, joined. */
#include "output/movie.h"

#include "base/status.h"
#include "output/figures-data.h"
#include "output/figures-room.h"
#include "output/gnuplot.h"
#include "output/movie-frames.h"
#include "output/program.h"

#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { FEWEST = 3 };

/* Says to the script whether frames are to be joined by ffmpeg, and have rigid bodies. */
static int tell_script(const struct figures_room *room, bool joined, bool bodies)
{
    char path[ASIDE_PATH];
    struct aside a;

    TRY(aside_join(path, room->at, "joined.gp"));
    TRY(aside_open(&a, path));
    fprintf(a.to, "joined = %d\nshaped = %d\n", joined, bodies);
    return aside_close(&a);
}

static int join(const struct figures_room *room)
{
    char *const words[] = { "ffmpeg", "-nostdin", "-y", "-loglevel", "error", "-framerate", "12",
                            "-i", "frame-%04d.png", "-c:v", "libvpx-vp9", "-pix_fmt", "yuv420p",
                            "-b:v", "0", "-crf", "30", "movie.webm", NULL };

    if (program_run(room->at, words, "ffmpeg.log") != 0)
        return status_fail(STATUS_IO, "ffmpeg could not join the frames; take it out of PATH for a "
                           "GIF by gnuplot alone");
    return STATUS_DONE;
}

/* Bodies are in the index of the files if they are anywhere. */
static bool has_bodies(const char *run)
{
    char path[ASIDE_PATH];

    return aside_join(path, run, "fields/000000-bodies.vtkhdf") == STATUS_DONE
           && access(path, R_OK) == 0;
}

static int frames(const struct figures_room *room, const char *run, int *n)
{
    struct movie_shot shot = { .bodies = has_bodies(run) };
    char path[ASIDE_PATH];

    TRY(aside_join(path, room->at, "constants.gp"));
    shot.dim = (int)figures_data_constant(path, "dim");
    if (shot.dim == 3)
        shot.middle = 0.5 * (figures_data_constant(path, "low_y")
                             + figures_data_constant(path, "high_y"));
    return movie_frames(&shot, run, room->at, n);
}

static int draw(const struct figures_room *room, const char *run, const char *scripts)
{
    char path[ASIDE_PATH];
    const bool joined = program_find("ffmpeg", path);
    int n;

    TRY(figures_room_bring_data(room, "constants.gp"));
    TRY(frames(room, run, &n));
    if (n < FEWEST)
        return status_fail(STATUS_BAD_SCENE, "%s: %d particle files make no movie; run the scene "
                           "with a smaller output.fields", run, n);
    TRY(figures_room_bring(room, scripts, "style.gp"));
    TRY(figures_room_bring(room, scripts, "movie.gp"));
    TRY(tell_script(room, joined, has_bodies(run)));
    TRY(gnuplot_run(room->at, "movie.gp", room->at));
    return joined ? join(room) : STATUS_DONE;
}

/* The movie goes to the run, the other one that there may be from before goes. */
static int put(const struct figures_room *room, const char *run)
{
    static const char *const names[] = { "movie.webm", "movie.gif" };
    char from[ASIDE_PATH], to[ASIDE_PATH];

    for (int i = 0; i < 2; i++) {
        TRY(aside_join(from, room->at, names[i]));
        TRY(aside_join(to, run, names[i]));
        if (access(from, F_OK) != 0)
            remove(to);
        else if (rename(from, to) != 0)
            return status_fail(STATUS_IO, "%s: cannot be written: %s", to, strerror(errno));
        else
            printf("%s\n", to);
    }
    return STATUS_DONE;
}

static void clear(const struct figures_room *room)
{
    char path[ASIDE_PATH];
    struct dirent *entry;
    DIR *dir = opendir(room->at);

    while (dir && (entry = readdir(dir)))
        if (strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0
            && aside_join(path, room->at, entry->d_name) == STATUS_DONE)
            remove(path);
    if (dir)
        closedir(dir);
    rmdir(room->at);
}

int movie_write(const char *run, const char *scripts)
{
    struct figures_room room;
    int status;

    TRY(figures_room_make(&room, run));
    status = draw(&room, run, scripts);
    if (status == STATUS_DONE)
        status = put(&room, run);
    clear(&room);
    return status;
}
