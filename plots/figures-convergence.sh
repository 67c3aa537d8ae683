#!/bin/sh
# figures-convergence.sh -- the error of space and the error of time side by side, for water at
# rest, vortices, a drop and a collapsing column: DIR/convergence.png.  doc/convergence.md tells
# what it shows.
#
# Run by `make figures', or by hand in a build tree:
#
#     top_srcdir=PATH sh .../figures-convergence.sh DIR [CASE...]
#
# Cases: rest, vortices, drop, column.  Tables and the script stay in DIR/convergence/, a case
# whose table is there is not run again.  Five CPU minutes.
#
# A table has a row a spacing and tolerance: spacings in the length of the case, tolerance, error of
# space at tol = 1e-6 against what is exact, distance from the run with 1e-6, right-hand sides.
set -e

top=$(cd "${top_srcdir:-.}" && pwd)
stiffwater=${STIFFWATER:-$(cd "${top_builddir:-.}" && pwd)/stiffwater}
mkdir -p "$1/convergence"
cp "$top/plots/style.gp" "$top/plots/convergence.gp" "$1/convergence"
cd "$1/convergence"
shift
echo '# nothing: this figure belongs to no single run' > constants.gp

# go RUN SCENE LENGTH N TOL KEY=VALUE...: N spacings in the length
go()
{
    directory=$1
    scene=$2
    dx=$(awk -v l="$3" -v n="$4" 'BEGIN { printf "%.17g", l / n }')
    tol=$5
    shift 5
    "$stiffwater" run "$top/$scene" -q --threads 1 -o "$directory" spacing="$dx" tol="$tol" \
        output.fields=10 "$@" 2> "$directory.said" || { cat "$directory.said" >&2; exit 1; }
}

# last RUN: its last snapshot
last()
{
    echo "$1/$(tail -n 1 "$1/snapshots.csv" | cut -d, -f2)"
}

# number RUN KEY: of run.json
number()
{
    sed -n "s/^ *\"$2\": \(.*[0-9]\),*\$/\1/p" "$1/run.json"
}

# What a case is: its length, its numbers of spacings; NAME_go RUN N TOL; NAME_space RUN N, the
# error against what is exact; NAME_time RUN, the distance from the run `best'.

# --- water at rest after 4 s: L2 of pressures from those of Tait's water, over rho g H ----------
rest_sizes='10 20 40'
rest_go() { go "$1" data/scenes/still-water.scene 0.2 "$2" "$3" until=4 output.snapshots=2; }
rest_space()
{
    awk -F, '/^[#x]/ || $8 != 0 { next }
        { p = 56057.14 * ((1 + 6 * 9.81 * (0.2 - $2) / 392.4) ^ (7 / 6) - 1)
          s += ($6 - p) ^ 2; n++ }
        END { printf "%.4g", sqrt(s / n) / 1962 }' "$(last "$1")"
}
rest_time()
{
    paste -d, "$(last "$1")" "$(last best)" | awk -F, '/^[#x]/ || $8 != 0 { next }
        { s += ($6 - $14) ^ 2; n++ } END { printf "%.4g", sqrt(s / n) / 1962 }'
}

# --- Taylor-Green vortices: rate of decay to 0.05 s, of 1.579 1/s -------------------------------
vortices_sizes='25 50 100'
vortices_go()
{
    go "$1" data/scenes/taylor-green.scene 1 "$2" "$3" until=0.05 output.snapshots=1
}
rate()
{
    awk -F, '/^t/ { for (i = 1; i <= NF; i++) if ($i == "kinetic") c = i; next } /^#/ { next }
        !e { e = $c } { k = $c; t = $1 } END { printf "%.12g", -log(k / e) / t }' "$1/book.csv"
}
vortices_space() { awk -v r="$(rate "$1")" 'BEGIN { printf "%.4g", r / 1.5791367 - 1 }'; }
vortices_time()
{
    awk -v r="$(rate "$1")" -v s="$(rate best)" 'BEGIN { printf "%.4g", r / s - 1 }'
}

# --- a drop that flies apart: its semi-axes at 0.0076 s, with the support that it wants ---------
drop_sizes='10 20 40'
drop_go()
{
    go "$1" data/scenes/elliptic-drop.scene 1 "$2" "$3" kernel.support=5 output.snapshots=2
}
axes()
{
    awk -F, '/^[#x]/ || $8 != 0 { next } { a += $1 * $1; b += $2 * $2; n++ }
        END { printf "%.12g %.12g %d", 2 * sqrt(a / n), 2 * sqrt(b / n), n }' "$(last "$1")"
}
drop_space()
{
    axes "$1" | awk -v size="$2" '{ r = sqrt($3 / 3.14159265358979) / size
        a = $1 / r / 1.9445172 - 1; b = $2 / r * 1.9445172 - 1
        printf "%.4g", (a * a > b * b ? a : b) }'
}
drop_time()
{
    echo "$(axes "$1") $(axes best)" | awk '{ a = $1 / $4 - 1; b = $2 / $5 - 1
        printf "%.4g", (a * a > b * b ? a : b) }'
}

# --- a column that collapses: T when its front is at Z = 3 ---------------------------------------
column_sizes='20 40 80'
column_go()
{
    go "$1" tests/validation/martin-moyce.scene 0.05715 "$2" "$3" until=0.14 output.interval=1e-3 \
        output.snapshots=1
}
front()
{
    awk -F, -v n="$2" '/^[#t]/ { next } { z = $2 / 0.05715 + 0.5 / n }
        z > 3 { t += (3 - y) / (z - y) * ($1 - t)
            printf "%.12g", sqrt(2 * 9.81 / 0.05715) * t; exit }
        { t = $1; y = z }' "$1/front.csv"
}
column_space() { front "$1" "$2"; }
column_time()
{
    awk -v a="$(front "$1" "$n")" -v b="$(front best "$n")" 'BEGIN { printf "%.4g", a / b - 1 }'
}

# The column has no exact solution: T for ever finer spacings, from the three, takes its place.
column_exact()
{
    awk '{ t[$1] = $3 } END {
        a = t[20] - t[40]; b = t[40] - t[80]; limit = t[80] - b * b / (a - b)
        print limit }' column.csv > column.limit
    awk -v limit="$(cat column.limit)" '{ $3 = $3 / limit - 1; print }' column.csv > column.new
    mv column.new column.csv
}

for case in ${*:-rest vortices drop column}; do
    if [ -f "$case.csv" ]; then continue; fi
    echo "figures-convergence: $case"
    rm -f "$case.rows"
    eval "sizes=\$${case}_sizes"
    for n in $sizes; do
        "${case}_go" best "$n" 1e-6
        space=$("${case}_space" best "$n")
        echo "$n 1e-6 $space 0 $(number best rhs_explicit)" >> "$case.rows"
        for tol in 1e-1 1e-2 1e-3 1e-4; do
            "${case}_go" run "$n" $tol
            echo "$n $tol $space $("${case}_time" run) $(number run rhs_explicit)" >> "$case.rows"
        done
    done
    mv "$case.rows" "$case.csv"
    if [ "$case" = column ]; then column_exact; fi
    rm -r best run
done
if [ -f rest.csv ] && [ -f vortices.csv ] && [ -f drop.csv ] && [ -f column.csv ]; then
    gnuplot -d convergence.gp
fi
