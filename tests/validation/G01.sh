#!/bin/sh
# G01.sh -- a lid-driven cavity, Re 100
#
# A lid slides over a closed unit box, U = 1 m/s (`data/scenes/driven-cavity.scene`, `adami`
# walls). Velocities on the two centre lines at t = 15 L/U, straight lines through the particles
# around a place, weighted by exp(-(r/dx)^2), against Ghia, Ghia and Shin (1982), `data/reference/G01*.csv`.
#
# The lid stays where it is and slides by its `surface`, and the fluid sticks at the faces of all walls, (W2). With `stick =
# "particles"` drag acts from where the particles of a wall are, 0.6 spacings behind its face: below the lid, where u falls by
# 6 U/L, that is 0.07 U with dx = L/50, and the rest of the flow is as much too slow. A plate that moves along instead of a
# surface opens the corners: some fluid follows it out, and `own-density` walls were 0.46 U off.
. "$(dirname "$0")/lib.sh"
scene=$scenes/driven-cavity.scene

# line RUN DX COLUMN-ALONG COLUMN-VELOCITY FILE: place, reference, here
line() {
    file=$(tail -n 1 "$1/snapshots.csv" | cut -d, -f2)
    awk -F, -v dx="$2" -v along="$3" -v v="$4" '
        /^#/ || /^[xy],/ { next }
        FILENAME == ARGV[1] { if (across($0)) { s[n] = $along; c[n] = $(3 - along); w[n++] = $v } next }
        function across(l,    d) { d = $(3 - along) - 0.5; return $8 == 0 && d < 3 * dx && d > -3 * dx }
        { a = b = e = f = h = 0 # least squares: value + slope (s - $1), across the line even
          for (i = 0; i < n; i++) { r = (s[i] - $1) ^ 2 + (c[i] - 0.5) ^ 2
              if (r < 9 * dx * dx) { q = exp(-r / (dx * dx)); z = s[i] - $1
                  a += q; b += q * z; e += q * z * z; f += q * w[i]; h += q * z * w[i] } }
          if ($1 > dx / 2 && $1 < 1 - dx / 2) print $1, $2, (f * e - h * b) / (a * e - b * b) }
        BEGIN { n = 0 }' "$1/$file" "$5"
}
worst() { awk '{ d = $3 - $2; if (d * d > m * m) m = d } END { printf "%.3f", m < 0 ? -m : m }'; }
: >by-spacing
for walls in adami own-density; do
    for n in 25 50; do
        dx=$(awk -v n=$n 'BEGIN { print 1 / n }')
        wide=$(awk -v n=$n 'BEGIN { print 3 / n }')
        run=$walls$n
        go $run "$scene" walls=$walls spacing="$dx" "wall.lid.from=[-$wide,1]" \
            "wall.lid.to=[$(calc "1 + $wide"),$(calc "1 + $wide")]"
        line $run "$dx" 2 3 "$reference/G01a_ghia_1982_u_vertical.csv" >$run.u
        line $run "$dx" 1 4 "$reference/G01b_ghia_1982_v_horizontal.csv" >$run.v
        u=$(worst <$run.u)
        v=$(worst <$run.v)
        why=
        [ $run = adami25 ] && why='too coarse: L/50 meets it'
        row "u on x = 1/2, v on y = 1/2: $walls, dx = L/$n" 'Ghia (1982)' "off by $u U, $v U at most" '0.03 U' \
            "$u < 0.03 && $v < 0.03" "$(cost $run)" "$why"
    done
done
draw <<'G'
set datafile separator ' '
set multiplot layout 1, 2
set xtics 0.4
set key bottom right
set xlabel 'u on x = 1/2 [U]'
set ylabel 'y [L]'
plot 'adami50.u' using 2:1 with points pt 6 lc rgb grey title 'Ghia 1982', \
    'adami25.u' using 3:1 with linespoints pt 7 ps 0.5 lc rgb pick(2) title 'dx = L/25', \
    'adami50.u' using 3:1 with linespoints pt 7 ps 0.5 lc rgb pick(1) title 'dx = L/50'
set xtics 0.2
set key top right
set xlabel 'x [L]'
set ylabel 'v on y = 1/2 [U]'
plot 'adami50.v' using 1:2 with points pt 6 lc rgb grey title 'Ghia 1982', \
    'adami25.v' using 1:3 with linespoints pt 7 ps 0.5 lc rgb pick(2) title 'dx = L/25', \
    'adami50.v' using 1:3 with linespoints pt 7 ps 0.5 lc rgb pick(1) title 'dx = L/50'
unset multiplot
G
done_here
