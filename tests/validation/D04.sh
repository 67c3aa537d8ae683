#!/bin/sh
# D04.sh -- blocks that sink and rise: Wu and others 2014
#
# *A two-way coupled simulation of moving solids in free-surface flows*, as used by Qiu, Liu and Han, Math. Probl. Eng. 2017, 3174904; paths digitised
# by others. A block with a side of 20 mm and 2120 kg/m^3, let go half under water, sinks 0.12 m to the bed of a tank 150 mm long: `sinking-block.scene`, in 2D,
# as what it is across is not told there (`data/reference/D04a_qiu_2017_sinking_block.csv`, whose bed is 4 mm too high). One of 49 x 48 x 24 mm and
# 800.5 kg/m^3 rises from the bed of a tank of 150 x 140 mm, under 52 mm of water: `rising-block.scene`, 3D
# (`data/reference/D04b_qiu_2017_rising_block.csv`). More: [blocks.md](blocks.md).
. "$(dirname "$0")/lib.sh"
go sinking "$scenes/sinking-block.scene"
go rising "$scenes/rising-block.scene"

# beyond HEIGHT UP: the first time at which the second column is above it (1) or below (-1)
beyond() {
    awk -v l="$1" -v up="$2" 'NR > 1 && ($2 - l) * up > 0 {
            printf "%.3f", t + (l - x) / ($2 - x) * ($1 - t); exit } { t = $1; x = $2 }'
}

# seen FILE: its rows
seen() {
    awk -F, '/^[-0-9]/ { print $1, $2 }' "$reference/$1"
}

seen D04a_qiu_2017_sinking_block.csv >a
seen D04b_qiu_2017_rising_block.csv >b
column sinking/bodies block.y >c
column rising/bodies block.z >d
# The computed one lies a contact margin, half a spacing, above the floor at most.
# Between the last row in water and the first on the bed the measured block goes on with the speed it had.
bed=$(awk '$2 < 0.0146 { printf "%.3f", t + (x - $2) / v; exit } { v = (x - $2) / ($1 - t); t = $1; x = $2 }' a)
got=$(beyond 0.01125 -1 <c)
row 'on the bed, plane' "$bed s" "$got s" '10 %' "($got / $bed - 1) ^ 2 < 0.01" "$(cost sinking)"
float=$(beyond 0.0442 1 <b)
got=$(beyond 0.0442 1 <d)
row 'at the height at which it floats, 44.2 mm' "$float s" "$got s" '10 %' "($got / $float - 1) ^ 2 < 0.01" "$(cost rising)"
draw <<'G'
set datafile separator ' '
set xlabel 't [s]'
set ylabel 'height of the centre [mm]'
set xrange [0:0.6]
set key center right
plot 'a' using 1:($2 * 1000 - 4) with points pt 6 lc rgb grey title 'sinks, measured, less 4 mm', \
    'c' using 1:($2 * 1000) with lines lw 2 lc rgb pick(1) title 'sinks, 2D', \
    'b' using 1:($2 * 1000) with points pt 4 lc rgb grey title 'rises, measured', \
    'd' using 1:($2 * 1000) with lines lw 2 lc rgb pick(2) title 'rises, 3D'
G
done_here
