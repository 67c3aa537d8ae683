/* page.c -- one page of HTML that stands alone. */
#include "output/page.h"

#include "base/status.h"
#include "output/utf8.h"

#include <string.h>

static const char style[]
    = "body { font: 16px/1.45 sans-serif; margin: 2em auto; max-width: 62em; padding: 0 1em; "
      "color: #202020; background: #ffffff }\n"
      "h1, h2 { line-height: 1.2 } h2 { margin-top: 2em; border-bottom: 1px solid #d4d4d4 }\n"
      "table { border-collapse: collapse } th, td { text-align: left; vertical-align: top; "
      "padding: .3em 1.2em .3em 0; border-bottom: 1px solid #e4e4e4 }\n"
      "pre { background: #f5f5f5; padding: 1em; overflow-x: auto; font-size: 13px }\n"
      "img { max-width: 100%; height: auto } figure { margin: 1.5em 0 }\n"
      "figcaption { color: #606060 } summary { cursor: pointer }\n"
      ".wrong { background: #fdf0d5 } .bad { background: #f9d6d0; padding: .6em }\n";

/* A byte that is no UTF-8 becomes U+FFFD; control characters have no place in XML. */
static void escape(FILE *to, const char *text)
{
    const unsigned char *s = (const unsigned char *)text;

    while (*s) {
        const int n = utf8_sequence(s);
        if (n == 0)
            fputs("\xef\xbf\xbd", to);
        else if (*s == '&')
            fputs("&amp;", to);
        else if (*s == '<')
            fputs("&lt;", to);
        else if (*s == '>')
            fputs("&gt;", to);
        else if (*s == '"')
            fputs("&quot;", to);
        else if (*s >= 0x20 || *s == '\n' || *s == '\t')
            fwrite(s, 1, (size_t)n, to);
        else
            fputc('?', to);
        s += n > 0 ? n : 1;
    }
}

static void tagged(FILE *to, const char *tag, const char *class, const char *text)
{
    fprintf(to, class ? "<%s class=\"%s\">" : "<%s>", tag, class);
    escape(to, text);
    fprintf(to, "</%s>\n", tag);
}

int page_open(struct page *p, const char *path, const char *title)
{
    TRY(aside_open(&p->file, path));
    fprintf(p->file.to, "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
            "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
            "<style>\n%s</style>\n", style);
    tagged(p->file.to, "title", NULL, title);
    fputs("</head>\n<body>\n", p->file.to);
    tagged(p->file.to, "h1", NULL, title);
    return STATUS_DONE;
}

void page_heading(struct page *p, const char *text)
{
    tagged(p->file.to, "h2", NULL, text);
}

void page_paragraph(struct page *p, const char *class, const char *text)
{
    tagged(p->file.to, "p", class, text);
}

static void row(FILE *to, const char *class, const char *tag, const char *const *cells, int n)
{
    fprintf(to, class ? "<tr class=\"%s\">" : "<tr>", class);
    for (int i = 0; i < n; i++)
        tagged(to, tag, NULL, cells[i]);
    fputs("</tr>\n", to);
}

void page_table(struct page *p, const char *const *names, int n)
{
    fputs("<table>\n<thead>\n", p->file.to);
    row(p->file.to, NULL, "th", names, n);
    fputs("</thead>\n<tbody>\n", p->file.to);
}

void page_row(struct page *p, const char *class, const char *const *cells, int n)
{
    row(p->file.to, class, "td", cells, n);
}

void page_table_end(struct page *p)
{
    fputs("</tbody>\n</table>\n", p->file.to);
}

void page_text_file(struct page *p, const char *what, const char *path)
{
    FILE *from = fopen(path, "r");
    char line[4096];

    if (!from)
        return;
    fputs("<details><summary>", p->file.to);
    escape(p->file.to, what);
    fputs("</summary>\n<pre>", p->file.to);
    while (fgets(line, sizeof line, from))
        escape(p->file.to, line);
    fputs("</pre>\n</details>\n", p->file.to);
    fclose(from);
}

/* RFC 4648, base 64. */
static void encode(FILE *to, FILE *from)
{
    static const char digits[]
        = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    unsigned char b[3];
    size_t n;

    while ((n = fread(b, 1, 3, from)) > 0) {
        const unsigned bits = (unsigned)b[0] << 16 | (n > 1 ? (unsigned)b[1] << 8 : 0)
                            | (n > 2 ? b[2] : 0u);
        for (int i = 0; i < 4; i++)
            fputc(i <= (int)n ? digits[bits >> (18 - 6 * i) & 63] : '=', to);
    }
}

bool page_picture(struct page *p, const char *path, const char *words)
{
    FILE *from = fopen(path, "r");

    if (!from)
        return false;
    fputs("<figure><img alt=\"", p->file.to);
    escape(p->file.to, words);
    fputs("\" src=\"data:image/png;base64,", p->file.to);
    encode(p->file.to, from);
    fputs("\"/>\n", p->file.to);
    tagged(p->file.to, "figcaption", NULL, words);
    fputs("</figure>\n", p->file.to);
    fclose(from);
    return true;
}

int page_close(struct page *p)
{
    fputs("</body>\n</html>\n", p->file.to);
    return aside_close(&p->file);
}
