#!/bin/sh
# mps-multigrid.sh -- with multigrid as its preconditioner, mps finds the pressure that IC(0) finds,
# in products that do not grow with the particles, and with the same bits on any number of threads
# and ranks; programs without it say so.
. "${top_srcdir:-.}/tests/lib.sh"
. "$top_srcdir/tests/mpi.sh"
dam=$top_srcdir/data/scenes/mps-dam-break.scene
cube=$top_srcdir/tests/scenes/still-cube.scene

unset OMP_NUM_THREADS

# refused WORDS TEXT...: the last run ended so, before there were files, and said all these texts
refused() {
    words=$1
    shift
    for text; do
        grep -q -F -e "$text" "$out/refused.said" && [ "$code" = 2 ] && [ ! -e "$out/refused" ] ||
            { wrong "$words: status $code, says $text"; cat "$out/refused.said"; return; }
    done
    good "$words"
}

go refused "$dam" until=0.001 mps.preconditioner=multigrid
refused 'the serial programs refuse multigrid' 'is HYPRE' 'wants MPI' '--ranks 1' '"ic0"' 'scene:17'
go refused "$dam" until=0.001 mps.preconditioner=multigird
refused 'a name that is none is refused' 'multigird' '"ic0"' '"multigrid"'

[ -x "$top_builddir/stiffwater-2d-mpi" ] || skip "configure found no Open MPI, or no Zoltan"
go refused "$dam" until=0.001 mps.preconditioner=multigrid --ranks 1
if [ "$code" != 0 ]; then
    refused 'without HYPRE it is refused' 'configure did not find' 'libhypre-dev' '"ic0"'
    [ $bad = 0 ] || exit 1
    skip "configure found no HYPRE"
fi

# --- the same pressure ------------------------------------------------------------------------
# Forces on the tank hold all pressures; how far the two are apart [of the largest], after ten steps.
apart() {
    column "$1/forces" tank.fx tank.fy >"$out/one"
    column "$2/forces" tank.fx tank.fy | paste -d ' ' "$out/one" - | awk '
        function size(x) { return x < 0 ? -x : x }
        { for (i = 2; i <= 3; i++) {
            if (size($i - $(i + 3)) > worst) worst = size($i - $(i + 3))
            if (size($i) > most) most = size($i) } }
        END { print (most > 0 ? worst / most : 1) }'
}
short='spacing=7.3e-3 until=0.006 output.interval=0.001 --ranks 1'
for residual in 1e-4 1e-10; do
    for which in ic0 multigrid; do
        # shellcheck disable=SC2086 # words of a command
        well $which-$residual "$dam" $short mps.residual=$residual mps.preconditioner=$which
    done
done
claim 'both find the same forces, to what the solve is asked for' "$(apart ic0-1e-10 multigrid-1e-10) < 1e-8"
claim 'which the measure of it would notice' "$(apart ic0-1e-4 multigrid-1e-4) > 1e-7"
# shellcheck disable=SC2086
well serial "$dam" ${short%--ranks 1} mps.residual=1e-10
[ "$(hash serial)" = "$(hash ic0-1e-10)" ] && good 'IC(0) has the bits of the serial program' ||
    wrong 'IC(0) has the bits of the serial program'

# --- products ---------------------------------------------------------------------------------
# products RUN: of a solve
products() {
    awk "BEGIN { print $(number "$1" operator_products) / $(number "$1" solves) }"
}

# Ten steps on a lattice that is in order still; measured: 26, 92 with IC(0), 8 and 8 with multigrid.
for which in ic0 multigrid; do
    well $which-few "$dam" spacing=4.8666666666666667e-3 until=0.004 mps.preconditioner=$which --ranks 1
    well $which-many "$dam" spacing=1.2372881355932203e-3 until=0.001 mps.preconditioner=$which --ranks 1
done
claim 'with IC(0) products grow with the particles' "$(products ic0-many) > 2.5 * $(products ic0-few)"
claim 'with multigrid they do not' "$(products multigrid-many) < 1.25 * $(products multigrid-few)"
claim 'and are fewer' "$(products multigrid-many) < 0.2 * $(products ic0-many)"
claim 'also where there are few particles' "$(products multigrid-few) < 0.6 * $(products ic0-few)"

# --- the same bits ----------------------------------------------------------------------------
# one NAME SCENE KEY=VALUE...: the hash of one thread is that of two, and of two ranks
one() {
    same=$1 scene=$2
    shift 2
    well "$same" "$scene" mps.preconditioner=multigrid "$@" --ranks 1 --threads 1
    well "$same-threads" "$scene" mps.preconditioner=multigrid "$@" --ranks 1 --threads 2
    well "$same-ranks" "$scene" mps.preconditioner=multigrid "$@" --ranks 2 --threads 1
    if [ "$(hash "$same")" = "$(hash "$same-threads")" ] && [ "$(hash "$same")" = "$(hash "$same-ranks")" ]; then
        good "$same: the same bits on two threads, and on two ranks: $(hash "$same")"
    else
        wrong "$same: the same bits on two threads, and on two ranks"
    fi
}
one plane "$dam" spacing=3.65e-3 until=0.02
one space "$cube" until=0.02
well space-ic0 "$cube" until=0.02
claim '3D: fewer products, too' "$(products space) < $(products space-ic0)"
claim '3D: the same depth of water' "($(last space book potential) / $(last space-ic0 book potential) - 1) ^ 2 < 1e-12"

# --- what it cannot ---------------------------------------------------------------------------
go short "$dam" until=0.001 mps.preconditioner=multigrid mps.iterations=1 --ranks 1
claim 'a solve that is not done in time fails' "$code == 1"
prints short 'no pressure is found: after 1 products' 'mps.iterations'
finish
