# spread-positions.gp -- how far particles of runs that began alike are apart
# needs: spread-positions.csv figures/constants.gp figures/runs.gp
load 'style.gp'
load 'spread-bands.gp'
table = '../spread-positions.csv'
stats table using 2 skip 2 nooutput name 'rms'
if (!(rms_max > 0)) { exit }
set terminal pngcairo size 1200, 700 font 'Sans,18'
set output 'spread-positions.png'
set title title."\n".few noenhanced
set logscale y
set format y '10^{%L}'
set xrange [0:until]
set xlabel 'time [s]'
set ylabel 'standard deviation of positions [spacings]'
set key bottom right samplen 2
set arrow 1 from graph 0, first share to graph 1, first share nohead dt '-' lw 1.5 lc rgb grey
plot table using 1:($3 > 0 ? $3 : NaN) skip 2 with lines lw 2 lc rgb pick(6) title 'worst particle', \
    table using 1:($2 > 0 ? $2 : NaN) skip 2 with lines lw 3 lc rgb pick(1) \
        title 'root mean square', \
    keyentry with lines dt '-' lw 1.5 lc rgb grey title sprintf('%g spacings', share)
