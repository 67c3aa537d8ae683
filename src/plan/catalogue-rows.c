/* catalogue-rows.c -- rows of parameters, as `explain` prints them. */
#include "plan/catalogue-rows.h"

#include <math.h>

static void print_default(const struct param *r, FILE *to)
{
    fputs(r->required ? "required" : "default ", to);
    if (r->required)
        return;
    if (r->type == PARAM_WORD)
        fprintf(to, "%s", r->words[0] ? r->words[0] : "-");
    else if (r->type == PARAM_FLAG)
        fputs(r->fallback != 0 ? "true" : "false", to);
    else if (r->type == PARAM_TEXT)
        fputs("\"\"", to);
    else if (r->type == PARAM_POINTS || r->type == PARAM_PAIRS || r->type == PARAM_WORDS)
        fputs("none", to);
    else if (isnan(r->fallback))
        fputs("computed", to);
    else
        fprintf(to, "%g", r->fallback);
}

void catalogue_row(const struct param *r, FILE *to)
{
    fprintf(to, "  %-18s %-10s ", r->key, r->unit);
    print_default(r, to);
    if ((r->type == PARAM_NUMBER || r->type == PARAM_INTEGER) && r->max > r->min)
        fprintf(to, ", %g to %g", r->min, r->max);
    fprintf(to, "\n      %s\n", r->about);
    if (r->type != PARAM_WORD && r->type != PARAM_WORDS)
        return;
    fputs("      one of:", to);
    for (int i = 0; r->words[i]; i++)
        fprintf(to, " %s", r->words[i]);
    fputc('\n', to);
}

void catalogue_rows(const struct param *rows, FILE *to)
{
    for (const struct param *r = rows; r && r->key; r++)
        catalogue_row(r, to);
}

void catalogue_body_rows(const struct body_group *groups, FILE *to)
{
    for (const struct body_group *g = groups; g && g->name; g++)
        for (const struct param *r = g->params; r->key; r++) {
            char key[GROUP_KEY];
            struct param row = *r;
            row.key = group_key(g, r->key, key);
            catalogue_row(&row, to);
        }
}
