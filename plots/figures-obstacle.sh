#!/bin/sh
# figures-obstacle.sh -- the dam break on an elastic obstacle: what happens, and what it costs.
# Draws DIR/obstacle-*.png, which doc/elastic-obstacle.md tells of.
#
# Run by `make figures', or by hand in a build tree:
#
#     top_srcdir=PATH sh .../figures-obstacle.sh DIR [PART...]
#
# Parts: story (three spacings to 0.7 s), tolerances, spacings, stiffness; all of them unless some
# are named.  Runs and tables stay in DIR/obstacle/; the same command again makes only what is
# missing.  Seven CPU minutes; times mean something on a machine that does nothing else.
set -e

top=$(cd "${top_srcdir:-.}" && pwd)
stiffwater=${STIFFWATER:-$(cd "${top_builddir:-.}" && pwd)/stiffwater}
mkdir -p "$1/obstacle"
cd "$1/obstacle"
shift
wanted=${*:-story tolerances spacings stiffness}
cp "$top/plots/style.gp" "$top/plots/"obstacle-*.gp .
cp "$top/data/reference/C03_dambreak_elastic_obstacle_tip.csv" .
echo '# nothing: these figures belong to no single run' > constants.gp

# run NAME KEY=VALUE...: unless it is there and done
run()
{
    directory=$1
    shift
    if grep -q '"status": "done"' "$directory/run.json" 2> /dev/null; then return 0; fi
    echo "figures-obstacle: $directory" >&2
    "$stiffwater" run "$top/data/scenes/elastic-obstacle.scene" -q --threads 1 -o "$directory" \
        output.interval=2e-4 output.fields=1 output.snapshots=1 "$@"
}

# number RUN KEY: of run.json
number()
{
    sed -n "s/^ *\"$2\": \(.*[0-9]\),*\$/\1/p" "$1/run.json"
}

# results RUN BEST: peak [mm] of the tip to 0.3 s, when [s], impulse on the obstacle at 0.25 s
# [N s/m], largest energy defect over the energy at the start, right-hand sides, CPU seconds, root
# mean square distance of the tip from that of BEST until 0.3 s over its peak
results()
{
    awk -F, '!/^[#t]/ && $1 < 0.3001 && $2 > m { m = $2; t = $1 }
        END { printf "%.4f,%.4f,", 1000 * m, t }' "$1/beam.csv"
    awk -F, '/^t/ { for (i = 1; i <= NF; i++) if ($i == "obstacle.ix") c = i }
        !/^[#t]/ && $1 > 0.24999 { printf "%.5f,", $c; exit }' "$1/forces.csv"
    awk -v d="$(number "$1" energy_defect_max)" -v e="$(number "$1" energy_initial)" \
        -v n="$(number "$1" rhs_explicit)" -v s="$(number "$1" cpu_s)" \
        'BEGIN { printf "%.3g,%d,%.2f,", d / e, n, s }'
    paste -d, "$1/beam.csv" "$2/beam.csv" | awk -F, '/^[0-9]/ && $1 < 0.3001 {
        d = $2 - $(NF / 2 + 2); s += d * d; n++; if ($2 > m) m = $2 }
        END { printf "%.4g\n", sqrt(s / n) / m }'
}
names='peak,when,impulse,defect,rhs,cpu,tip'

# size SPACINGS LAYERS: keys for the column's 0.146 m in so many spacings, the obstacle so thick
size()
{
    awk -v n="$1" -v l="$2" \
        'BEGIN { printf "spacing=%.17g beam.obstacle.layers=%d", 0.146 / n, l }'
}
sizes='73:6 60:5 49:4 36:3 24:2'

# --- what happens ----------------------------------------------------------------------------
story()
{
    for n in 36:3 49:4 73:6; do
        # shellcheck disable=SC2046 # two words
        run "story-${n%:*}" $(size "${n%:*}" "${n#*:}") output.snapshots=36
    done
    for t in 0.1 0.16 0.2 0.24 0.3 0.5; do
        file=$(awk -F, -v t=$t '!/^[#t]/ && $1 > t - 1e-9 { print $2; exit }' \
            story-73/snapshots.csv)
        awk -F, '!/^[#x]/ { print $1, $2, sqrt($3 * $3 + $4 * $4), $6, $8 }' \
            "story-73/$file" > "at-$t"
    done
    gnuplot -d obstacle-snapshots.gp
    gnuplot -d obstacle-history.gp
}

# --- tolerance, spacing, stiffness -----------------------------------------------------------
methods='imex3 imex4 imex5 dv'
tolerances()
{
    run reference method=imex5 tol=1e-7 until=0.3
    {
        echo "method,tol,$names"
        echo "reference,1e-7,$(results reference reference)"
        for seed in 1 2 3 4 5 6; do
            run "chance-$seed" method=imex5 tol=1e-6 until=0.3 disturbance.size=1e-6 \
                disturbance.seed=$seed
            echo "chance,1e-6,$(results "chance-$seed" reference)"
        done
        for method in $methods; do
            for tol in 1e-1 1e-2 1e-3 1e-4 1e-5; do
                run "tol-$method-$tol" method=$method tol=$tol until=0.3
                echo "$method,$tol,$(results "tol-$method-$tol" reference)"
            done
        done
    } > tolerances.csv
}

spacings()
{
    {
        echo "method,dx,$names"
        for n in $sizes; do
            for method in imex3 imex4 dv; do
                # shellcheck disable=SC2046 # two words
                run "dx-${n%:*}-$method" $(size "${n%:*}" "${n#*:}") method=$method until=0.3
                echo "$method,$(awk -v n="${n%:*}" 'BEGIN { print 146 / n }'),$(
                    results "dx-${n%:*}-$method" dx-73-imex3)"
            done
        done
    } > spacings.csv
}

# An explicit method takes the same short steps all along: 2 ms of it, times 150; where the steps
# are shortest 0.2 ms, times 1500.
explicit()
{
    run "E-$1-cks43" method=cks43 "beam.obstacle.E=$1" "until=$2"
    for key in rhs_explicit cpu_s; do
        awk -v n="$(number "E-$1-cks43" $key)" -v t="$2" 'BEGIN { printf "%.6g,", n * 0.3 / t }'
    done
}

stiffness()
{
    {
        echo "method,E,$names"
        for E in 1e6 1e7 1e8 1e9 1e10 2.1e11; do
            for method in $methods; do
                run "E-$E-$method" method=$method beam.obstacle.E=$E until=0.3
                echo "$method,$E,$(results "E-$E-$method" "E-$E-imex3")"
            done
            case $E in *9 | *1?) few=2e-4 ;; *) few=2e-3 ;; esac
            echo "cks43,$E,nan,nan,nan,nan,$(explicit $E $few)nan"
        done
    } > stiffness.csv
}

for part in $wanted; do $part; done
if [ -f tolerances.csv ] && [ -f spacings.csv ] && [ -f stiffness.csv ]; then
    gnuplot -d obstacle-tolerance.gp
    gnuplot -d obstacle-cost.gp
fi
for figure in obstacle-*.png; do cp "$figure" ..; done
