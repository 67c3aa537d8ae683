# front.gp -- how far and how high the water stands against time, in the measures of Martin and
# Moyce (Phil. Trans. R. Soc. A 244 (1952) 312), with what they saw
# needs: front.csv figures/constants.gp
# reference: B01a_martin_moyce_1952_front_n2_2.csv B01b_martin_moyce_1952_front_square.csv B01c_martin_moyce_1952_height_square.csv
#
# Width of the column a, height n^2 a:  T = n t sqrt(g/a),  Z = front / a,  height / (n^2 a).
load 'style.gp'
table = '../front.csv'
if (!(a > 0 && n2 > 0 && g > 0)) { exit }
T(t) = t * sqrt(n2 * g / a)
Z(x) = (x - low_x) / a
tall = abs(n2 - 2) < 0.05
square = abs(n2 - 1) < 0.05
seen(s) = strcol(1) eq s ? 1 : NaN

set terminal pngcairo size 1200, 1050 font 'Sans,18'
set output 'front.png'
set multiplot title title noenhanced
set lmargin 9
set rmargin 3
set xrange [0:T(until)]

set origin 0, 0.38
set size 1, 0.58
set ylabel 'front  Z = x / a'
set yrange [0.8:*]
set key bottom right samplen 2
far = Z(high_x)
set label 1 'far wall' at graph 0.01, first far offset 0, 0.6 tc rgb grey
a_side = sprintf('a = %g mm, n^2 = %.3g', 1e3 * a, n2)
if (tall) {
    data = 'B01a_martin_moyce_1952_front_n2_2.csv'
    plot far lc rgb grey dt '-' lw 1.5 notitle, \
        table using (T($1)):(Z($2)) skip 2 with lines lw 3 lc rgb pick(1) title 'this run, '.a_side enhanced, \
        data using ($2 * seen('a1.125in_pysph')):3 skip 4 with points pt 6 ps 1.6 lw 2 lc rgb pick(2) \
        title 'Martin, Moyce 1952, a = 28.6 mm', \
        data using ($2 * seen('a2.25in_pysph')):3 skip 4 with points pt 4 ps 1.6 lw 2 lc rgb pick(3) \
        title 'Martin, Moyce 1952, a = 57.2 mm'
} else {
    data = square ? 'B01b_martin_moyce_1952_front_square.csv' : '/dev/null'
    plot far lc rgb grey dt '-' lw 1.5 notitle, \
        table using (T($1)):(Z($2)) skip 2 with lines lw 3 lc rgb pick(1) title 'this run, '.a_side enhanced, \
        data using 1:2 skip 3 with points pt 4 ps 1.6 lw 2 lc rgb pick(3) \
        title square ? 'Martin, Moyce 1952, a = 57.2 mm' : ''
}
unset label 1

set origin 0, 0
set size 1, 0.38
set xlabel 'time  T = n t (g/a)^{1/2}'
set ylabel 'height / initial'
set yrange [0:1.1]
set key top right
data = square ? 'B01c_martin_moyce_1952_height_square.csv' : '/dev/null'
plot table using (T($1)):($3 / (n2 * a)) skip 2 with lines lw 3 lc rgb pick(1) title 'this run, at the back wall', \
    data using 1:2 skip 3 with points pt 4 ps 1.6 lw 2 lc rgb pick(3) \
    title square ? 'Martin, Moyce 1952' : ''
unset multiplot
