/* spread-json.c -- spread.json: which runs a spread is of, and until when they agree. */
#include "study/spread-inside.h"

#include "base/status.h"
#include "output/json.h"
#include "study/quantity.h"

#include <math.h>

#ifndef PACKAGE_VERSION
#define PACKAGE_VERSION "unknown"
#endif

static void write_runs(struct json *j, const struct spread *s)
{
    json_object(j, "status");
    for (int i = 0; i < s->order->runs; i++)
        json_text(j, s->member[i].name,
                  s->member[i].ended ? member_status(&s->member[i]) : "missing");
    json_end(j);
}

static void write_lost(struct json *j, const struct spread *s)
{
    char key[256];

    json_object(j, "lost");
    json_number(j, "positions", s->apart.lost);
    for (int i = 0; i < SPREAD_INSIDE_TABLES; i++)
        for (int c = 1; c < s->bundle[i].columns; c++) {
            snprintf(key, sizeof key, "%s %.200s", quantity_tables[i],
                     s->bundle[i].table[0].name[c]);
            json_number(j, key, spread_lost(s, i, c));
        }
    json_end(j);
}

int spread_json_write(const struct spread *s)
{
    char path[MEMBER_PATH];
    struct json *j;

    TRY(aside_join(path, s->home.directory, "spread.json"));
    TRY(json_open(&j, path));
    json_text(j, "scene", s->order->scene);
    json_text(j, "version", PACKAGE_VERSION);
    json_number(j, "until", s->facts.until);
    json_number(j, "spacing", s->facts.dx);
    json_number(j, "disturbance", s->order->size);
    json_integer(j, "seed", s->order->seed);
    json_integer(j, "runs", s->order->runs);
    json_integer(j, "done", s->done);
    json_number(j, "share", s->order->share);
    json_number(j, "window_from", s->window[0]);
    json_number(j, "window_to", s->window[1]);
    write_runs(j, s);
    write_lost(j, s);
    return json_close(&j);
}
