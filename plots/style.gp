# style.gp -- what the other scripts share: the scene, colours, lines, and a way to find columns
# by their names.  Colours after Okabe and Ito, told apart by colour-blind readers as well.
#
# A script is run in the folder figures/ of a run:  gnuplot forces.gp
load 'constants.gp'
set encoding utf8
set datafile separator ','
set datafile missing 'nan'

array colour[7] = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9', '#000000']
pick(i) = colour[1 + (i - 1) % 7]
grey = '#8c8c8c'

set border 3 lw 1.2 lc rgb '#404040'
set tics nomirror out
set grid lt 1 lw 0.8 lc rgb '#d4d4d4'
set key noenhanced

# `eval read_line` leaves the first row of `table` in `line`, with `between` behind each column.  A row
# is put together from columns, as gnuplot cuts long lines without separators.
read_line = "stats table using 0 every ::0::0 nooutput name 'head'; line = ''; \
    do for [at = 1:int(head_columns):40] { \
        joined = ''; \
        do for [n = at:(at + 39 < head_columns ? at + 39 : int(head_columns))] { \
            joined = joined.sprintf('.strcol(%d).between', n) }; \
        eval 'stats table using (line = line'.joined.', 0) every ::0::0 nooutput' }"

# `eval read_names` leaves the names of the columns of `table` in `names`, with blanks between.
# Above the rows stand two lines: units and names.
read_names = "set datafile separator ','; between = ' '; ".read_line."; names = line"

# `eval read_units` leaves the line above them in `units`; unit(c) is then that of column c, and
# say(c) its name with it. To be asked for after read_names.
read_units = "set datafile commentschars ''; between = ','; ".read_line."; units = line; \
    set datafile commentschars '#'"
field(s, n) = n > 1 ? field(s[strstrt(s, ',') + 1:*], n - 1) : \
    strstrt(s, ',') ? s[1:strstrt(s, ',') - 1] : s
unit(c) = strlen(units) > 9 ? field(units[10:*], c) : ''
say(c) = word(names, c).(strlen(unit(c)) ? ' ['.unit(c).']' : '')

# ends_in('left.fx', '.fx') is 1; stem('left.fx') is 'left'
ends_in(word, end) = strlen(word) > strlen(end) && word[strlen(word) - strlen(end) + 1:*] eq end
stem(word) = word[1:strstrt(word, '.') - 1]

# `eval choose` leaves in `columns` the numbers of the columns whose names end in `end`.
choose = "columns = ''; do for [i = 2:words(names)] { \
    if (ends_in(word(names, i), end)) { columns = columns.' '.i } }"
# `column_of(name)` is the number of a column, 0 when there is none.
column_of(name) = sum [i = 1:words(names)] (word(names, i) eq name ? i : 0)

# `eval few_tics` after `stats ... name 'x'`: at most some five on the linear axis of x, so that their
# numbers do not run into each other; on a logarithmic one gnuplot's own.
round_up(r) = r > 5 ? 10 : r > 2 ? 5 : r > 1 ? 2 : 1
decade(r) = 10.0 ** floor(log10(r))
few_tics = "if (x_max > x_min && !(x_min > 0 && x_max > 4 * x_min)) { \
    set xtics decade((x_max - x_min) / 4) * round_up((x_max - x_min) / 4 / decade((x_max - x_min) / 4)) }"
