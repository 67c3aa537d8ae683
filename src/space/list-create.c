/* list-create.c -- takes a pair list's memory and gives it back. */
#include "space/list-private.h"

#include "base/status.h"

#include <stdlib.h>

static void *array(size_t count, size_t size)
{
    return status_alloc(count > 0 ? count : 1, size);
}

int list_create(struct list **list, const struct list_def *def, int lanes)
{
    struct list *made = array(1, sizeof *made);
    struct list_private *own = array(1, sizeof *own);
    const size_t n = (size_t)def->from[KINDS];
    const size_t groups = n / (size_t)lanes + KINDS;

    *list = made;
    if (!made || !own) {
        free(own);
        free(made);
        *list = NULL;
        return STATUS_FAILED;
    }
    *made = (struct list){ .def = *def, .lanes = lanes, .n = (int)n, .bad = -1, .own = own };
    made->order = array(n, sizeof *made->order);
    made->slot = array(n, sizeof *made->slot);
    own->built = array(n * DIM, sizeof *own->built);
    own->order_room = n;
    own->per_metre = LIST_UNITS / (def->support + def->skin);
    bool good = made->order && made->slot && own->built && images_create(made) == STATUS_DONE;
    for (int w = 0; w < LIST_WORDS; w++) {
        good = good && (own->place[w] = array(n + LIST_PAD, sizeof(int)));
        own->place_room[w] = n + LIST_PAD;
    }
    own->stand = own->images.home ? own->images.home[0] : own->built;
    made->group_slot = own->group_slot = array(groups, sizeof *own->group_slot);
    made->group_kind = own->group_kind = array(groups, sizeof *own->group_kind);
    made->segment_from = own->segment_from = array(groups + 1, sizeof *own->segment_from);
    made->rows_before = own->rows_before = array(groups + 1, sizeof *own->rows_before);
    if (good && own->group_slot && own->group_kind && own->segment_from && own->rows_before)
        return STATUS_DONE;
    list_free(list);
    return STATUS_FAILED;
}

void list_free(struct list **list)
{
    if (!*list)
        return;
    struct list_private *own = (*list)->own;

    for (int t = 0; t < own->stores; t++) {
        free(own->store[t].j);
        free(own->store[t].found);
        free(own->store[t].near);
    }
    for (int kind = 0; kind < KINDS; kind++) {
        free(own->cells[kind].start);
        free(own->image_cells[kind].start);
    }
    images_free(&own->images);
    drift_free(&own->drift);
    for (int w = 0; w < LIST_WORDS; w++)
        free(own->place[w]);
    free(own->store);
    free(own->built);
    free(own->group_slot);
    free(own->group_kind);
    free(own->segment_from);
    free(own->rows_before);
    free(own->segment);
    free(own);
    free((*list)->order);
    free((*list)->offset);
    free((*list)->slot);
    free(*list);
    *list = NULL;
}
