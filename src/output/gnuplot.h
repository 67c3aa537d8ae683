/* gnuplot.h -- runs gnuplot, without a shell. */
#ifndef OUTPUT_GNUPLOT_H
#define OUTPUT_GNUPLOT_H

/* gnuplot SCRIPT in directory; what it has to say goes to SCRIPT.log there, which
 * is taken away when all went well. STATUS_IO says how it ended, or that there is
 * no gnuplot. */
int gnuplot_run(const char *directory, const char *script);

#endif
