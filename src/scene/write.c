/* write.c -- values as a scene file writes them. */
#include "scene/tree.h"

#include <ctype.h>
#include <stdlib.h>

/* As few digits as give the same bits again: 17 always do. */
void scene_write_number(double number, FILE *to)
{
    char text[32];

    for (int digits = 6; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, number);
        if (strtod(text, NULL) == number)
            break;
    }
    fputs(text, to);
}

void scene_write_text(const char *text, FILE *to)
{
    fputc('"', to);
    for (const unsigned char *c = (const unsigned char *)text; *c; c++)
        if (*c == '"' || *c == '\\')
            fprintf(to, "\\%c", *c);
        else if (*c == '\n')
            fputs("\\n", to);
        else if (iscntrl(*c))
            fprintf(to, "\\x%02X", *c);
        else
            fputc(*c, to);
    fputc('"', to);
}

static void write_children(const struct scene_node *node, FILE *to)
{
    for (int i = 0; i < node->n; i++) {
        if (i > 0)
            fputs(", ", to);
        scene_write_node(node->child[i], to);
    }
}

void scene_write_node(const struct scene_node *node, FILE *to)
{
    switch (node->kind) {
    case SCENE_GROUP:
        fputs("{ ... }", to);
        break;
    case SCENE_LIST:
        fputc('(', to);
        write_children(node, to);
        fputc(')', to);
        break;
    case SCENE_NUMBER:
        scene_write_number(node->number, to);
        break;
    case SCENE_FLAG:
        fputs(node->flag ? "true" : "false", to);
        break;
    case SCENE_TEXT:
        scene_write_text(node->text, to);
        break;
    }
}
