/* figures.h -- draws the figures of a run (or comparison) with gnuplot.
 *
 * Each script says in comment lines at its top what it wants:
 *
 *     # needs: front.csv figures/constants.gp      (in the run's directory)
 *     # reference: B01a_martin_moyce_1952_front_n2_2.csv
 *
 * A script whose needs are there (a .csv: with at least one row) is drawn in a room of its own,
 * output/figures-room.h, together with its reference data, NAME.gp making NAME.png, NAME-*.png or,
 * when it finds nothing to show, none; scripts without `needs` (style.gp) are for others to load;
 * needs in figures/ are read as data.  All of it is then put into RUN/figures, so that each figure
 * can be changed and redrawn by hand: cd RUN/figures && gnuplot front.gp.  What is in RUN/figures
 * is not carried out. */
#ifndef OUTPUT_FIGURES_H
#define OUTPUT_FIGURES_H

/* What scripts are told of a scene, as gnuplot variables of the same names. */
struct figures_constants {
    const char *title;
    int dim;
    double a, n2;        /* width of the fluid at t = 0 [m], its height / width;
                            NAN: there is none                                   */
    double g;            /* size of gravity                              [m/s^2] */
    double until;        /* [s]                                                  */
    double low[3], high[3]; /* domain: low_x, low_y, low_z, high_x, ...  [m]     */
    int rings;           /* 1: water begins under hydrostatic pressure, else 0   */
    int moves;           /* 1: some wall moves, else 0                           */
    int column;          /* 1: a block in the low corner that falls, else 0      */
    double beam_x;       /* left face of the first beam or wall within the domain at t = 0 [m];
                            NAN: there is none                                   */
    double dx;           /* spacing, or what pictures take for it        [m]     */
    double rho0, c0;     /* [kg/m^3], [m/s]                                      */
    const char *beams;   /* their names, with blanks between; NULL: none         */
    const char *sections; /* heights of their sections at the root [m], likewise; 0: it
                            has none                                             */
    const char *bodies;   /* names of rigid bodies, likewise                        */
    const char *masses;   /* of rigid bodies [kg, 2D: kg/m], likewise               */
    double E0;           /* energy at t = 0                     [J, 2D: J/m]     */
};

/* Writes RUN/figures/constants.gp. */
int figures_constants(const char *run, const struct figures_constants *c);

/* Draws all that can be drawn and prints the name of each figure.  Scripts that
 * gnuplot refuses do not keep the others from being drawn, but make STATUS_IO in
 * the end; so does a missing gnuplot. */
int figures_draw(const char *run, const char *scripts, const char *reference);

#endif
