/* result.h -- what a run cost and how far it is from its reference, from its files. */
#ifndef STUDY_RESULT_H
#define STUDY_RESULT_H

enum result_error {
    RESULT_POSITION, RESULT_FRONT, RESULT_TIP, RESULT_BODY, RESULT_IMPULSE, RESULT_FORCE,
    RESULT_PROBE, RESULT_ERRORS
};

struct result { /* NAN: not known */
    double cpu, wall; /* [s] */
    double steps, rejected, rhs_explicit, rhs_implicit, passes;
    double mean_step;     /* [s] */
    double t_end;         /* time reached [s] */
    double energy_defect; /* [J], 2D: [J/m] */
    double error[RESULT_ERRORS];
};

extern const char *const result_errors[RESULT_ERRORS]; /* "position", ... */

/* Reads DIR/run.json; errors are NAN. */
void result_read(struct result *r, const char *dir);

/* Fills the errors of a run in dir against the one in reference.
 *
 * Positions: root mean square over the fluid's particles of the distance between a
 * particle here and there, in spacings dx, in picture i here and i_reference there:
 *     sqrt(sum |x - x_ref|^2 / N) / dx
 * Front, tip, body, impulse: root mean square in time of the difference, over the largest that the
 * reference shows:  sqrt(mean_t sum_c (v_c - r_c)^2) / max_t sqrt(sum_c r_c^2)
 * with columns c: front.csv x; beam.csv *.tip_x, *.tip_y; bodies.csv *.x, *.y, *.z; forces.csv
 * *.ix, *.iy, *.iz, each without its value at the start.
 * Probe: the same of all columns of probes.csv, of those *.mean where there are such, as they
 * are.
 * Force: |F - F_r| / F_r, F the largest force on an object as a mean over a fiftieth of the
 * time, from its impulse.
 * A quantity that is not there, or not at the same times, is NAN. */
void result_compare(struct result *r, const char *dir, int i, const char *reference,
                    int i_reference, double dx);

#endif
