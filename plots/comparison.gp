# comparison.gp -- what the figures of a comparison share: its table, which lines there are, how
# they look, and which runs did not come to their end.  Loaded after style.gp.
table = '../compare.csv'
set datafile missing NaN
eval read_names
eval read_units
first_swept = 21                       # before it: method to energy_defect
sweeps = column_of('t_end') - first_swept
c_end = column_of('t_end')
c_run = column_of('run')
c_true = column_of('reference')

# Without particles there are no pairs: right-hand sides of both sides stand for them.
passes(i) = dx > 0 ? column(11) : column(9) + column(10)
say_passes = dx > 0 ? 'pair passes' : 'right-hand sides'

# Errors against the run of the same method with the least spacing: of space as well as of time.
space = 0
stats table using (space = strstrt(strcol(c_true), 'reference-') == 1 ? 0 : 1, 0) skip 2 nooutput

# A line is a method, whatever stands behind its @; fixed steps in seconds are a line of their own.
# Where spacings are points of a line, it is a method with all that stands behind it.
upto(w, sign) = strstrt(w, sign) ? w[1:strstrt(w, sign) - 1] : w
before_at(w) = upto(upto(w, '@'), '~')
case(i) = strcol(1).(strcol(2) eq 'nan' ? '' : '~'.strcol(2))
say_case(c) = upto(c, '~').(strstrt(c, '~') ? ' '.c[strstrt(c, '~') + 1:*] : '')
line_of(c) = space ? c : \
    before_at(c).(strstrt(c, '@') && upto(c, '~')[strlen(upto(c, '~')):*] eq 's' ? '@s' : '')
say_line(l) = space ? say_case(l) : strstrt(l, '@') ? before_at(l).', fixed steps' : l
named(k) = k > sweeps || (space && word(names, first_swept - 1 + k) eq 'spacing') ? '' : \
    ','.word(names, first_swept - 1 + k).'='.strcol(first_swept - 1 + k)
somewhere(w) = strlen(w) ? w[2:*] : 'all'
place(i) = somewhere(named(1).named(2).named(3).named(4))

# Families: colour; their members: mark and dashes.
array family_colour[9] = ['#000000', '#d55e00', '#0072b2', '#56b4e9', '#009e73', '#cc79a7', \
    '#e69f00', '#7b5ea7', '#8c510a']
is_one_of(w, list) = strstrt(' '.list.' ', ' '.w.' ') > 0
begins(w, with) = strstrt(w, with) == 1
family(l) = is_one_of(before_at(l), 'leapfrog euler-cfl staggered') ? 1 : \
    begins(l, 'dv') ? 2 : begins(l, 'imex') ? 5 : begins(l, 'erk') || begins(l, 'ARKODE') ? 4 : \
    is_one_of(before_at(l), 'adams bdf gsl-msadams') || begins(l, 'ab') ? 6 : \
    begins(l, 'gsl') ? 7 : begins(l, 'dirk') || begins(l, 'mri') ? 8 : \
    is_one_of(before_at(l), 'pcisph mps dfsph') ? 9 : 3
mark(i) = word('7 5 9 13 11 6 4 8 12 10', 1 + (i - 1) % 10) + 0
dash(i) = 1 + (i - 1) % 5
dashes = "set dashtype 2 (18,6); set dashtype 3 (6,5); set dashtype 4 (18,5,4,5); \
    set dashtype 5 (3,3)"

# Lines and places in the order of the table, lines then by their families.
add(list, w) = is_one_of(w, list) ? list : list.(strlen(list) ? ' ' : '').w
found = ''
places = ''
stats table using (found = add(found, line_of(case(0))), places = add(places, place(0)), 0) \
    skip 2 nooutput
lines = ''
members = ''
do for [f = 1:9] {
    n = 0
    do for [l in found] {
        if (family(l) == f) { n = n + 1; lines = add(lines, l); members = members.' '.n }
    }
}
member(i) = word(members, i) + 0
is_hull(i) = words(lines) <= 8 || is_one_of(word(lines, i), hull)
look(i) = is_hull(i) ? family_colour[family(word(lines, i))] : '#c8c8c8'
hull = ''
mine(i, p) = line_of(case(0)) eq word(lines, i) && (p eq '' || place(0) eq p)

# Why runs did not come to their end, a line of text each reason.  A text ends at its first comma
# unless quotes separate columns; no other column has any.
stats table using 0 skip 2 nooutput name 'row'
array message[row_records > 0 ? row_records : 1]
set datafile separator '"'
set datafile missing
rows_read = 0
stats table using (rows_read = rows_read + 1, message[rows_read] = strcol(2), 0) \
    skip 2 nooutput
set datafile separator ','
set datafile missing NaN
most_reasons = 6
array method[most_reasons]
array why[most_reasons]
n_reasons = 0
others = 0
one_line(w, n) = strlen(w) > n ? w[1:n - 3].'...' : w
cut(w) = strstrt(w, ' at t = ') && strcol(3) eq 'stopped' ? w[1:strstrt(w, ' at t = ') - 1] : w
asked(i) = strcol(1).(strcol(2) eq 'nan' ? '' : ' '.strcol(2)).(place(0) eq 'all' ? '' : ' '.place(0))
known(w) = sum [i = 1:n_reasons] (why[i] eq w ? i : 0)
first(w) = n_reasons < most_reasons ? (n_reasons = n_reasons + 1, why[n_reasons] = w, \
    method[n_reasons] = asked(0), 0) : (others = others + 1, 0)
again(k) = (method[k] = method[k].', '.asked(0), 0)
reason(w) = known(w) ? again(known(w)) : first(w)
stats table using (strcol(3) ne 'done' ? reason(strcol(3).': '.cut(message[int($0) + 1])) : 0) \
    skip 2 nooutput
reasons = ''
do for [k = 1:n_reasons] {
    reasons = reasons.one_line(one_line(method[k], 60).' '.why[k], 160)."\n"
}
if (others > 0) { reasons = reasons.sprintf("and %d more: see compare.md\n", others) }
reason_lines = n_reasons + (others > 0)

# Quantities with an error, in columns 13 to 20, and whether a row has it.
quantities = 8
array quantity[quantities] = ['position', 'front', 'tip', 'body', 'impulse', 'force', 'probe', 'energy']
array axis[quantities] = ['positions [spacings]', 'front / its way', 'tip / its largest', 'bodies / their way', \
    'impulse / its largest', 'peak force', 'probes / their largest', sprintf('energy defect [%s]', dim == 2 ? 'J/m' : 'J')]
error(q) = abs(column(12 + q))
has_error(q) = strcol(3) eq 'done' && strcol(12 + q) ne 'nan' && strcol(12 + q) ne '0'
shown = ''
do for [q = 1:quantities] {
    stats table using (has_error(q)) skip 2 nooutput name 'has'
    if (has_sum > 0) { shown = shown.' '.q }
}

# `eval empty` leaves a panel with nothing but its key, or its labels.
empty = "unset logscale; unset border; unset tics; unset grid; unset xlabel; unset ylabel; \
    unset title; set format xy ''; set xrange [0:1]; set yrange [0:1]; set y2range [0:1]"
