/* sample.h -- what a few numbers that differ by chance say. */
#ifndef STUDY_SAMPLE_H
#define STUDY_SAMPLE_H

struct sample {
    int n;            /* numbers that are finite; of none all below is NAN         */
    double mean, low, high;
    double sd;        /* standard deviation, with n - 1; NAN of one                */
    double half;      /* the mean is uncertain by +- this, with 95 % certainty     */
};

/* Of value[0..n), which keep their order; what is not finite does not count.
 * half = t sd/sqrt(n), t the 97.5 % point of Student's distribution with n - 1 degrees of
 * freedom: Student, Biometrika 6 (1908) 1-25; exact for numbers that are normally
 * distributed. */
void sample_make(struct sample *s, int n, const double *value);
double sample_mean(int n, const double *value); /* the mean alone */

/* Share of further numbers like these n that fall between the least and the largest of them,
 * in the mean, whatever their distribution: (n - 1)/(n + 1). */
double sample_inside(int n);

/* How uncertain sd itself is, as a share of it: 1/sqrt(2 (n - 1)). */
double sample_doubt(int n);

#endif
