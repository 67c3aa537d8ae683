/* page.h -- one page of HTML that stands alone: pictures are in it, nothing is fetched.  It is
 * well-formed XML, too.
 *
 *     TRY(page_open(&p, "out/report.html", "Dam break"));
 *     page_heading(&p, "Figures");
 *     page_picture(&p, "out/figures/front.png", "the front");
 *     TRY(page_close(&p));
 *
 * Only opening and closing can fail: writes that went wrong are told there. */
#ifndef OUTPUT_PAGE_H
#define OUTPUT_PAGE_H

#include "output/aside.h"

#include <stdbool.h>

struct page {
    struct aside file;
};

int page_open(struct page *p, const char *path, const char *title);
void page_heading(struct page *p, const char *text);
void page_paragraph(struct page *p, const char *class, const char *text); /* class NULL: none */

void page_table(struct page *p, const char *const *names, int n); /* its head, n columns */
void page_row(struct page *p, const char *class, const char *const *cells, int n);
void page_table_end(struct page *p);

/* A file of text as it is, folded behind `what`; nothing if it cannot be read. */
void page_text_file(struct page *p, const char *what, const char *path);

/* A PNG with words below it; false: it cannot be read. */
bool page_picture(struct page *p, const char *path, const char *words);

/* Ends the page and puts it in its place. */
int page_close(struct page *p);

#endif
