/* gnuplot.h -- runs gnuplot, without a shell. */
#ifndef OUTPUT_GNUPLOT_H
#define OUTPUT_GNUPLOT_H

/* gnuplot SCRIPT in directory; what it has to say goes to SCRIPT.log there, which
 * is taken away when all went well. STATUS_IO says how it ended, and that it is told in
 * SCRIPT.log of the directory `shown', or that there is no gnuplot in a directory of PATH that
 * has a whole path. */
int gnuplot_run(const char *directory, const char *script, const char *shown);

#endif
