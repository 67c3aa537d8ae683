#!/bin/sh
# D02.sh -- three cubes in a flood: Canelas and others 2016
#
# `flood-three-cubes.scene`, 25 mm: as D01, three cubes in a column, the path of the top one
# (`data/reference/D02_canelas_three_cubes_top.csv`), to 1.6 s. More: [blocks.md](blocks.md).
. "$(dirname "$0")/lib.sh"
go run "$scenes/flood-three-cubes.scene"
for what in x z; do
    awk -F, -v what=$what '$1 == "exp" && $2 == what && $3 >= 0 && $3 <= 1.6 { print $3, $4 }' \
        "$reference/D02_canelas_three_cubes_top.csv" >seen.$what
    column run/bodies top.$what >run.$what
    d=$(awk 'FILENAME == ARGV[1] { t[n] = $1; x[n++] = $2; next }
        { while (i < n - 2 && t[i + 1] < $1) i++
          d = x[i] + ($1 - t[i]) / (t[i + 1] - t[i]) * (x[i + 1] - x[i]) - $2; s += d * d; k++ }
        BEGIN { n = i = 0 } END { printf "%.0f", 1000 * sqrt(s / k) }' run.$what seen.$what)
    case $what in
    x) row 'top cube along the flume, rms' '0' "$d mm" '60 mm' "$d < 60" "$(cost run)" ;;
    z) row 'its height, rms' '0' "$d mm" '50 mm' "$d < 50" '' ;;
    esac
done
draw <<'G'
set datafile separator ' '
set xlabel 't [s]'
set ylabel 'top cube: x - 1.5 m, z [m]'
set xrange [0.4:1.6]
set key top left Left reverse
plot 'seen.x' using 1:($2 - 1.5) with points pt 6 lc rgb grey title 'x, measured', \
    'run.x' using 1:($2 - 1.5) with lines lw 2 lc rgb pick(1) title 'x', \
    'seen.z' using 1:2 with points pt 4 lc rgb grey title 'z, measured', \
    'run.z' using 1:2 with lines lw 2 lc rgb pick(2) title 'z'
G
done_here
