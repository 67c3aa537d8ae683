# spread-bands.gp -- for figures of a spread: mean and band of a column over time, and when the
# band has grown wide.  Loaded after style.gp.
#
#     table = '../spread-front.csv'
#     eval read_names
#     what = 'x'; scale = 1; tone = pick(1); eval draw_band
load 'runs.gp'
few = sprintf('%d runs, %g spacings apart at the start', runs, size)
legend = sprintf('line: mean, band: least to largest, dashed: the band is wider than %g %% of the largest mean', \
    100 * share)
is_number(text) = strlen(text) > 0 && text ne 'nan'
# `eval read_told`: when the band of the column `what' is lost, and its unit, as spread.csv has it.
read_told = "when = ''; unit = ''; set datafile missing; \
    stats '../spread.csv' using (strcol(2) eq what ? (when = strcol(11), unit = strcol(4), 0) : 0) \
        skip 2 nooutput; set datafile missing 'nan'"
# `eval names_of_means` leaves in `means` the columns that have bands, without ".mean".
names_of_means = "means = ''; do for [i = 2:words(names)] { if (ends_in(word(names, i), '.mean')) { \
    means = means.' '.word(names, i)[1:strlen(word(names, i)) - 5] } }"
size_of = "stats table using (abs(column(column_of(what.'.mean')))) skip 2 nooutput name 'own'; \
    largest = own_max"
# Least to largest as a band, the mean as a line, and a dashed line where one run means no more.
draw_band = "at = column_of(what.'.mean'); \
    eval read_told; \
    unset arrow 9; \
    if (is_number(when)) { \
        set arrow 9 from first real(when), graph 0 to first real(when), graph 1 nohead dt '-' lw 1.5 \
            lc rgb grey }; \
    plot 0 lc rgb grey lw 1 notitle, \
        table using 1:(scale * column(at + 1)):(scale * column(at + 2)) skip 2 \
            with filledcurves fs transparent solid 0.35 noborder lc rgb tone notitle, \
        table using 1:(scale * column(at)) skip 2 with lines lw 2 lc rgb tone notitle"
