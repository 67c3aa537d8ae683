#!/bin/sh
# figures-mps.sh -- products that a solve for the pressure takes in the method mps, against the
# number of particles, with IC(0) and with multigrid: DIR/mps-iterations.png.  doc/pressure.md
# tells what it shows.
#
# Run by `make figures`, or by hand in a build tree:
#
#     top_srcdir=PATH sh .../figures-mps.sh DIR [SPACINGS...]
#
# SPACINGS: how many in L, default 20 40 80 160 224.  Runs stay in DIR/mps/, and one that is done is
# not done again.  Twenty CPU minutes; without the program with MPI and HYPRE half, and no multigrid.
#
# A table, WHICH-gamma, has a row a run: particles of the fluid, products a step, CPU s.
set -e

top=$(cd "${top_srcdir:-.}" && pwd)
stiffwater=${STIFFWATER:-$(cd "${top_builddir:-.}" && pwd)/stiffwater}
mkdir -p "$1/mps"
cp "$top/plots/style.gp" "$top/plots/mps-iterations.gp" "$1/mps"
cd "$1/mps"
shift
echo '# nothing: this figure belongs to no single run' > constants.gp
scene=$top/data/scenes/mps-dam-break.scene

# number RUN KEY: of run.json
number()
{
    sed -n "s/^ *\"$2\": \(.*[0-9]\),*\$/\1/p" "$1/run.json"
}

# series WHICH GAMMA PROGRAM SPACING...
series()
{
    which=$1 gamma=$2 program=$3
    shift 3
    : > "$which-$gamma.csv"
    for n; do
        run=l$n-$which-$gamma
        if ! grep -q '"status": "done"' "$run/run.json" 2> /dev/null; then
            echo "figures-mps: $run" >&2
            "$program" run "$scene" -q --threads 1 -o "$run" until=0.05 mps.gamma="$gamma" \
                spacing="$(awk -v n="$n" 'BEGIN { printf "%.17g", 0.146 / n }')" \
                mps.preconditioner="$which" output.fields=10 output.snapshots=0 2> "$run.said" ||
                { cat "$run.said" >&2; exit 1; }
        fi
        echo "$(number "$run" fluid) $(number "$run" operator_products) $(number "$run" solves) $(number "$run" cpu_s)" |
            awk '{ print $1, $2 / $3, $4 }' >> "$which-$gamma.csv"
    done
}

[ $# -gt 0 ] || set -- 20 40 80 160 224
most=160 # with gamma = 0.85, whose solves take the longest
few=
for n; do
    [ "$n" -gt $most ] || few="$few $n"
done

# both WHICH PROGRAM SPACING...
both()
{
    which=$1 program=$2
    shift 2
    series "$which" 1 "$program" "$@"
    # shellcheck disable=SC2086 # one word each
    series "$which" 0.85 "$program" $few
}

both ic0 "$stiffwater" "$@"
if "$stiffwater-2d-mpi" run "$scene" -q -o try until=1e-5 mps.preconditioner=multigrid 2> try.said; then
    both multigrid "$stiffwater-2d-mpi" "$@"
else
    echo "figures-mps: no multigrid: $(cat try.said)" >&2
    rm -f multigrid-*.csv
fi
gnuplot mps-iterations.gp
