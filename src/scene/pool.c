/* pool.c -- memory that is given back all at once. */
#include "base/status.h"
#include "scene/tree.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

struct scene_chunk {
    struct scene_chunk *before;
    max_align_t memory[];
};

void *scene_pool_take(struct scene_pool *pool, size_t bytes)
{
    struct scene_chunk *chunk = status_alloc(1, sizeof *chunk + bytes);

    if (!chunk)
        return NULL;
    chunk->before = pool->last;
    pool->last = chunk;
    return chunk->memory;
}

char *scene_pool_print(struct scene_pool *pool, const char *format, ...)
{
    va_list arguments;
    char *text;
    int n;

    va_start(arguments, format);
    n = vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    text = scene_pool_take(pool, (size_t)n + 1);
    if (!text)
        return NULL;
    va_start(arguments, format);
    vsnprintf(text, (size_t)n + 1, format, arguments);
    va_end(arguments);
    return text;
}

void *scene_pool_grow(struct scene_pool *pool, void *array, int n, int *room, size_t size)
{
    const int wanted = *room > 0 ? 2 * *room : 8;
    void *larger;

    if (n < *room)
        return array;
    larger = scene_pool_take(pool, (size_t)wanted * size);
    if (!larger)
        return NULL;
    if (n > 0)
        memcpy(larger, array, (size_t)n * size);
    *room = wanted;
    return larger;
}

void scene_pool_free(struct scene_pool *pool)
{
    while (pool->last) {
        struct scene_chunk *before = pool->last->before;

        free(pool->last);
        pool->last = before;
    }
}
