#!/bin/sh
# figures-mps.sh -- products that a solve for the pressure takes in the method mps, against the
# number of particles: DIR/mps-iterations.png.  doc/seed-001.md tells what it shows.
#
# Run by `make figures`, or by hand in a build tree:
#
#     top_srcdir=PATH sh .../figures-mps.sh DIR [SPACINGS...]
#
# SPACINGS: how many in L, default 20 40 80 160 224.  Runs stay in DIR/mps/, and one that is done is
# not done again.  Seven CPU minutes.
#
# A table has a row a run: particles of the fluid, products a step, CPU s.
set -e

top=$(cd "${top_srcdir:-.}" && pwd)
stiffwater=${STIFFWATER:-$(cd "${top_builddir:-.}" && pwd)/stiffwater}
mkdir -p "$1/mps"
cp "$top/plots/style.gp" "$top/plots/mps-iterations.gp" "$1/mps"
cd "$1/mps"
shift
echo '# nothing: this figure belongs to no single run' > constants.gp

# number RUN KEY: of run.json
number()
{
    sed -n "s/^ *\"$2\": \(.*[0-9]\),*\$/\1/p" "$1/run.json"
}

[ $# -gt 0 ] || set -- 20 40 80 160 224
: > iterations.csv
for n in "$@"; do
    if ! grep -q '"status": "done"' "l$n/run.json" 2> /dev/null; then
        echo "figures-mps: l$n" >&2
        "$stiffwater" run "$top/data/scenes/mps-dam-break.scene" -q --threads 1 -o "l$n" until=0.05 \
            spacing="$(awk -v n="$n" 'BEGIN { printf "%.17g", 0.146 / n }')" output.fields=10 \
            output.snapshots=0 2> "l$n.said" || { cat "l$n.said" >&2; exit 1; }
    fi
    echo "$(number "l$n" fluid) $(number "l$n" operator_products) $(number "l$n" solves) $(number "l$n" cpu_s)" |
        awk '{ print $1, $2 / $3, $4 }' >> iterations.csv
done
gnuplot mps-iterations.gp
