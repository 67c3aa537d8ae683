#!/bin/sh
# figures-pcisph.sh -- PCISPH as in Toth 2012: DIR/seed-15.png redraws his figure 15, and
# DIR/seed-pcisph.png shows where the iteration converges, by kernels and gain; DIR/seed-17.png
# redraws his figure 17, water and beam, and DIR/seed-fsi.png has the beam by several methods.
# doc/seed-000.md tells what they show.
#
# Run by `make figures`, or by hand in a build tree after `make pcisph-table`:
#     top_srcdir=PATH sh .../figures-pcisph.sh DIR
# The runs, the tables and the scripts stay in DIR/pcisph/.  Two CPU minutes.
set -e

top=$(cd "${top_srcdir:-.}" && pwd)
build=$(cd "${top_builddir:-.}" && pwd)
stiffwater=${STIFFWATER:-$build/stiffwater}
scene=$top/data/scenes/toth-pcisph.scene
mkdir -p "$1/pcisph"
cp "$top/plots/style.gp" "$top/plots/seed-pcisph.gp" "$top/plots/seed-fsi.gp" "$1/pcisph"
cd "$1/pcisph"
echo '# nothing: these figures belong to no single run' > constants.gp

"$stiffwater" run "$scene" -q -o figure-15
"$stiffwater" plot figure-15 > plot.log 2>&1 || { cat plot.log >&2; exit 1; }
cp figure-15/figures/dye.png ../seed-15.png

# --- water and beam ---------------------------------------------------------------------
for method in pcisph@0.2 pcisph@0.05 staggered imex3; do
    "$stiffwater" run "$top/data/scenes/toth-fsi.scene" -q -o "fsi-$method" "method=$method" \
        2> "fsi-$method.said" || { cat "fsi-$method.said" >&2; exit 1; }
done
"$stiffwater" plot fsi-pcisph@0.2 > plot.log 2>&1 || { cat plot.log >&2; exit 1; }
cp fsi-pcisph@0.2/figures/dye.png ../seed-17.png
gnuplot -d seed-fsi.gp

# --- lattice and runs -------------------------------------------------------------------
"$build/pcisph-table" > lattice.csv
for one in poly6 wendland-c2; do
    grep -E "^density|^$one" lattice.csv > "lattice-$one.csv"
done

# value KEY: of the last run
value()
{
    sed -n "s/^ *\"$1\": *\"\\{0,1\\}\\([^\",]*\\).*/\\1/p" scan/run.json
}

# scan DENSITY PRESSURE: runs to 0.02 s with 30 iterations a step; one that needs a shorter
# step, or fails, does not converge
scan()
{
    echo 'support,gain,converges' > "scan-$1.csv"
    for support in 2.52 3 3.5 4; do
        for factor in 0.3 0.45 0.6 0.8 1 1.1 1.2 1.4 1.6; do
            "$stiffwater" run "$scene" -q -o scan "kernel.type=$1" "kernel.pressure=$2" \
                "kernel.support=$support" pcisph.delta=toth "pcisph.gain=$factor" \
                pcisph.least=30 pcisph.most=100 until=0.02 output.snapshots=0 2> scan.log || :
            converges=0
            if [ "$(value status)" = done ] && [ "$(value rejected)" = 0 ]; then
                converges=1
            fi
            echo "$support,$(value pressure_gain),$converges" >> "scan-$1.csv"
        done
    done
}
scan poly6 spiky
scan wendland-c2 same
gnuplot -d seed-pcisph.gp
