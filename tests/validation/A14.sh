#!/bin/sh
# A14.sh -- blocks, cylinders and spheres on an incline
#
# `data/reference/A14a_incline_sliding_rolling.csv`: dry friction on slopes of 15 to 60 degrees with six coefficients; blocks of 0.15 m and discs
# in 2D, spheres in 3D, side by side and at rest at first. The acceleration is that from 1 to 2 s, when friction has been wound up. *Off by*: of g times
# the sine, the largest of the six. Rubbing as Mindlin (1949) has it, `A14b_mindlin_tangential.csv`: `tests/physics/clumps3`, within 0.02 at all
# of its rows.
. "$(dirname "$0")/lib.sh"
friction='0 0.2 0.3 0.45 0.577 0.7'

# slope NAME DIM KEYS ANGLE UNTIL: the less friction, the further down
slope() {
    awk -v dim="$2" -v keys="$3" -v angle="$4" -v until="$5" -v mu="$friction" '
        function vector(x, y, z) { return dim == 3 ? sprintf("[%.9f, %.9f, %.9f]", x, y, z) : sprintf("[%.9f, %.9f]", x, z) }
        BEGIN {
            turn = angle * 3.14159265358979 / 180
            printf "dimension = %d; until = %s; gravity = %s; output = { interval = 0.5; };", dim, until,
                vector(9.81 * sin(turn), 0, -9.81 * cos(turn))
            printf "domain = { from = %s; to = %s; }; body = {", vector(-50, -50, 0), vector(900, 50, 50)
            n = split(mu, m, " ")
            for (i = 1; i <= n; i++)
                printf "b%d = { at = %s; %s mass = 2.7; softness = 0.05; friction = %s.0; stops = [\"bottom\"]; };\n", i,
                    vector(-2 * i, 2 * i - 7, 0.075), keys, m[i]
            print "};"
        }' | sed 's/\(friction = 0\.[0-9]*\)\.0/\1/' >"$1.scene"
    go "$1" "$1.scene"
}
# worst RUN COLUMN ANGLE: largest difference of accelerations from 1 to 2 s, of g times the sine [%]
worst() {
    column "$1/bodies" b1.vx b2.vx b3.vx b4.vx b5.vx b6.vx | awk -v c="$2" -v angle="$3" -v table="$reference/A14a_incline_sliding_rolling.csv" '
        $1 > 0.99 && $1 < 1.01 { for (i = 1; i <= 6; i++) from[i] = $(i + 1) }
        $1 > 1.99 && $1 < 2.01 { for (i = 1; i <= 6; i++) to[i] = $(i + 1) }
        END {
            while ((getline line <table) > 0) {
                split(line, f, ",")
                if (f[1] == angle) { n++; off = to[n] - from[n] - f[c]
                    if (off < 0) off = -off
                    if (off > most) most = off }
            }
            printf "%.4g", n != 6 ? 100 : 100 * most / (9.81 * sin(angle * 3.14159265358979 / 180))
        }'
}
for angle in 15 20 30 45 60; do
    for kind in 'block 2 3' 'cylinder 2 4' 'sphere 3 5'; do
        # shellcheck disable=SC2086 # three words
        set -- $kind
        case $1 in
        block) keys='size = [0.15, 0.15];' ;;
        cylinder) keys='shape = "disc"; radius = 0.075;' ;;
        *) keys='shape = "sphere"; radius = 0.075;' ;;
        esac
        slope "$1$angle" "$2" "$keys" $angle 2.0
        got=$(worst "$1$angle" "$3" $angle)
        row "$1, $angle degrees, six coefficients: acceleration" 'closed form' "off by $got %" '0.5 %' "$got < 0.5" "$(cost "$1$angle")"
    done
done
slope stay 2 'size = [0.15, 0.15];' 15 10.0
# shellcheck disable=SC2046 # two words
set -- $(column stay/bodies b3.x b6.x | awk 'NR == 1 { a = $2; b = $3 } END { printf "%.3g %.3g\n", $2 - a, $3 - b }')
row 'block, 15 degrees, friction 0.3 (tan 0.268): moved in 10 s' 0 "$1 m" '1e-4 m' "$1 < 1e-4" "$(cost stay)"
row 'friction 0.7: moved in 10 s' 0 "$2 m" '1e-4 m' "$2 < 1e-4" ''
done_here
