/* report.h -- what a run left as one page that can be sent and read anywhere. */
#ifndef OUTPUT_REPORT_H
#define OUTPUT_REPORT_H

/* Writes DIR/report.html: how the run ended, its numbers, warnings, figures, scene; versions is
 * a text about the program that writes it.  A comparison, sweep or spread has its words and
 * figures. */
int report_write(const char *run, const char *versions);

#endif
