# front.gp -- how far and how high the water stands against time, in the measures of Martin and
# Moyce (Phil. Trans. R. Soc. A 244 (1952) 312), with what they saw
# needs: front.csv figures/constants.gp
# reference: B01a_martin_moyce_1952_front_n2_2.csv B01b_martin_moyce_1952_front_square.csv B01c_martin_moyce_1952_height_square.csv
#
# Column of width a and height n^2 a:  T = n t sqrt(g/a),  Z = front / a.  Fronts in
# front.csv are those of particles; the surface is half a spacing further.  They had neither beam nor
# block: what they saw ends where one stands, and is for a column in the low corner only.
load 'style.gp'
table = '../front.csv'
# Nothing to show: no column, or water that fills the tank from side to side.
if (!(a > 0 && n2 > 0 && g > 0 && high_x - low_x > 1.05 * a)) { exit }
# Nor where the first row says that it is no column on the floor at the low end: a drop, a jet.
stats table using ($3 > 0 && abs(($2 + dx / 2 - low_x) / a - 1) < 0.1 ? 1 : NaN) skip 2 every ::0::0 \
    nooutput name 'column'
if (!exists('column_records') || column_records < 1) { exit }
T(t) = t * sqrt(n2 * g / a)
Z(x) = (x + dx / 2 - low_x) / a
is(name) = strcol(1) eq name ? $2 : NaN
far = (high_x - low_x) / a
is_column = exists('falls') ? falls : 1   # an older version did not say
if (!exists('beam_x')) { beam_x = NaN } # of an older version
beam = beam_x == beam_x ? (beam_x - low_x) / a : 1e9
free(z) = z <= beam ? z : NaN

# Until a while after the water has come to the far wall, if it does.
stats table using (Z($2)) skip 2 nooutput name 'reach'
stats table using (Z($2) > 0.97 * far ? T($1) : T(until)) skip 2 nooutput name 'arrival'
last = 1.6 * arrival_min < T(until) ? 1.6 * arrival_min : T(until)
top = reach_max > 0.9 * far ? 1.12 * far : 1.25 * reach_max

run = "table using (T($1)):(Z($2)) skip 2 with lines lw 3 lc rgb pick(1) title 'this run' "
low = "table using (T($1)):($3 / (n2 * a)) skip 2 " \
    ."with lines lw 3 lc rgb pick(1) title 'this run' "
seen = "with points ps 1.6 lw 2 "
if (is_column && abs(n2 - 2) < 0.05) {
    run = run.", 'B01a_martin_moyce_1952_front_n2_2.csv' " \
        ."using (is('a1.125in_pysph')):(free($3)) skip 4 ".seen \
        ."pt 6 lc rgb pick(2) title 'Martin, Moyce 1952, a = 28.6 mm', " \
        ."'' using (is('a2.25in_pysph')):(free($3)) skip 4 ".seen \
        ."pt 4 lc rgb pick(3) title 'Martin, Moyce 1952, a = 57.2 mm'"
}
if (is_column && abs(n2 - 1) < 0.05) {
    run = run.", 'B01b_martin_moyce_1952_front_square.csv' using 1:(free($2)) skip 3 ".seen \
        ."pt 4 lc rgb pick(3) title 'Martin, Moyce 1952, a = 57.2 mm'"
    low = low.", 'B01c_martin_moyce_1952_height_square.csv' using 1:2 skip 3 ".seen \
        ."pt 4 lc rgb pick(3) title 'Martin, Moyce 1952, a = 57.2 mm'"
}

set terminal pngcairo size 1200, 1050 font 'Sans,18'
set output 'front.png'
set multiplot title sprintf("%s: column a = %g mm, n² = %.3g", title, 1e3 * a, n2) noenhanced
set lmargin 11
set rmargin 3
set xrange [0:last]

set origin 0, 0.38
set size 1, 0.58
set ylabel 'front  Z = x / a'
set yrange [0.8:top]
set key bottom right samplen 2
if (far < top) {
    set label 1 'far wall' at graph 0.99, first far right offset 0, 0.7 tc rgb grey
    set arrow 1 from graph 0, first far to graph 1, first far nohead dt '-' lw 1.5 lc rgb grey
}
if (beam < top) {
    set label 2 'beam or block' at graph 0.01, first beam left offset 0, 0.7 tc rgb grey
    set arrow 2 from graph 0, first beam to graph 1, first beam nohead dt '-' lw 1.5 lc rgb grey
}
eval 'plot '.run
unset label
unset arrow

set origin 0, 0
set size 1, 0.38
set xlabel 'time  T = n t √(g/a)'
set ylabel 'height / initial height'
set yrange [0:1.1]
set key bottom left Left reverse
eval 'plot '.low
unset multiplot
