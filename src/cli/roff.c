/* roff.c -- characters, paragraphs and keys of a man page. */
#include "cli/roff.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/* What roff would turn into a hyphen, a quotation mark, an accent or a command. */
static const char *escape(char c)
{
    switch (c) {
    case '-': return "\\-";
    case '\\': return "\\e";
    case '^': return "\\(ha";
    case '~': return "\\(ti";
    case '`': return "\\(ga";
    default: return NULL;
    }
}

void roff_text(FILE *to, const char *text, int n)
{
    if (*text == '.' || *text == '\'')
        fputs("\\&", to);
    for (int i = 0; text[i] && i != n; i++)
        if (escape(text[i]))
            fputs(escape(text[i]), to);
        else
            fputc(text[i], to);
}

void roff_heading(FILE *to, const char *before, const char *title)
{
    fputs(".SS ", to);
    roff_text(to, before, -1);
    roff_text(to, title, -1);
    fputc('\n', to);
}

void roff_paragraph(FILE *to, const char *text)
{
    const size_t n = strlen(text);

    roff_text(to, text, -1);
    fputs(n > 0 && text[n - 1] == '.' ? "\n" : ".\n", to);
}

void roff_tag(FILE *to, const char *before, const char *tag, const char *behind)
{
    fputs(".TP\n\\fB", to);
    roff_text(to, before, -1);
    roff_text(to, tag, -1);
    fputs("\\fR ", to);
    roff_text(to, behind, -1);
    fputc('\n', to);
}

static void print_default(FILE *to, const struct param *r)
{
    if (r->required)
        fputs("required", to);
    else if (r->type == PARAM_WORD)
        fprintf(to, "default \"%s\"", r->words[0] ? r->words[0] : "");
    else if (r->type == PARAM_FLAG)
        fprintf(to, "default %s", r->fallback != 0 ? "true" : "false");
    else if (r->type == PARAM_TEXT)
        fputs("default \"\"", to);
    else if (r->type == PARAM_WORDS || r->type == PARAM_PAIRS)
        fputs("default none", to);
    else if (r->type == PARAM_POINTS || isnan(r->fallback))
        fputs("no fixed default", to);
    else
        fprintf(to, "default %g", r->fallback);
}

void roff_facts(FILE *to, const struct param *r)
{
    const bool words = r->type == PARAM_WORD || r->type == PARAM_WORDS;

    if (*r->unit)
        fprintf(to, "[%s] ", r->unit);
    print_default(to, r);
    if ((r->type == PARAM_NUMBER || r->type == PARAM_INTEGER) && r->max > r->min)
        fprintf(to, ", %g to %g", r->min, r->max);
    if (r->type == PARAM_VECTOR)
        fputs("; a vector", to);
    for (int i = 0; words && r->words[i]; i++)
        fprintf(to, "%s%s", i ? ", " : "; ", r->words[i]);
}
