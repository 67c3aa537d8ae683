#!/bin/sh
# ranks.sh -- what ranks do together, on 1, 2, 3 and 4 of them (8, too, in check-long), and what
# the programs for many ranks refuse.  Cores are shared: a rank that waits lets others work.
. "${top_srcdir:-.}/tests/lib.sh"
[ -x "$top_builddir/stiffwater-2d-mpi" ] || skip "configure found no Open MPI, or no Zoltan"

OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_mpi_yield_when_idle=1
OMPI_MCA_btl_vader_single_copy_mechanism=none OMP_NUM_THREADS=1
export OMPI_ALLOW_RUN_AS_ROOT OMPI_ALLOW_RUN_AS_ROOT_CONFIRM OMPI_MCA_mpi_yield_when_idle
export OMPI_MCA_btl_vader_single_copy_mechanism OMP_NUM_THREADS
mpirun=$(command -v mpirun.openmpi || command -v mpirun) || skip "there is no mpirun"

# ranks N PROGRAM ARGUMENT...: its words go to $out/said, its status to $code
ranks() {
    n=$1
    shift
    code=0
    timeout 120 "$mpirun" -q --oversubscribe --bind-to none -n "$n" "$@" >"$out/said" 2>&1 || code=$?
}

# programs: each on so many ranks
programs() {
    for n; do
        for program in room; do
            ranks "$n" "$top_builddir/tests/ranks/$program" "$n"
            grep 'NOT SO' "$out/said" || true
            claims=$(grep -c '^ok' "$out/said" || true)
            if [ $code = 0 ] && [ "$claims" -gt 0 ]; then
                good "$program on $n ranks: $claims claims"
            else
                wrong "$program on $n ranks: status $code, $claims claims are true"
                tail -n 5 "$out/said"
            fi
        done
    done
}

programs 1 2 3 4
[ -z "${STIFFWATER_LONG-}" ] || programs 8

# One message, one status, whatever the number of ranks.
refused() {
    words=$1 text=$2
    if [ $code = 2 ] && [ "$(grep -c "$text" "$out/said")" = 1 ]; then
        good "$words"
    else
        wrong "$words: status $code"
        cat "$out/said"
    fi
}

scene=$top_srcdir/tests/scenes/small-2d.scene
refuse() {
    words=$1
    shift
    ranks 2 "$top_builddir/stiffwater-2d-mpi" run "$@" -q -o "$out/two"
    refused "$words" '2 ranks cannot share'
    if [ ! -e "$out/two" ]; then good "and write nothing"; else wrong "and write nothing"; fi
}
scenes=$top_srcdir/data/scenes
refuse "bodies are refused in one message" "$scenes/beam-alone.scene"
refuse "other methods are refused" "$scenes/dam-break.scene" method=imex3
refuse "checkpoints are refused" "$scenes/dam-break.scene" output.checkpoint=0.1
ranks 2 "$top_builddir/stiffwater-2d-mpi" check "$scene"
refused "no other command is shared" "2 ranks share .run. and no other"
code=0
PMI_SIZE=2 PMI_RANK=0 "$top_builddir/stiffwater-2d-mpi" check "$scene" >"$out/said" 2>&1 || code=$?
refused "copies that another mpirun started are refused" 'there are 2 copies'
ranks 2 "$top_builddir/stiffwater" run "$scene" -q -o "$out/copies"
refused "copies of the serial program are refused" 'stiffwater-2d-mpi'
if [ ! -e "$out/copies" ]; then good "and write nothing"; else wrong "and write nothing"; fi
ranks 1 "$top_builddir/stiffwater" check "$scene"
if [ $code = 0 ]; then good "one copy is none too many"; else wrong "one copy: status $code"; fi

# --- the same bits ----------------------------------------------------------------------------
# same NAME DIMENSION SCENE KEY=VALUE...: alone, and on each number of ranks in $numbers, a run
# leaves the same state, counts and tables
same() {
    name=$1 program=$top_builddir/stiffwater-${2}d-mpi file=$scenes/$3.scene
    shift 3
    well "$name" "$file" "$@"
    for n in $numbers; do
        ranks "$n" "$program" run "$file" output.fields=100 output.snapshots=0 -q \
            -o "$out/$name-$n" "$@"
        [ $code = 0 ] || { wrong "$name on $n ranks: status $code"; cat "$out/said"; continue; }
        bits "$name" "$n"
    done
}

# bits NAME N
bits() {
    for key in state_hash steps rejected rhs_explicit rebuilds energy_defect density_max; do
        [ "$(value "$1" $key)" = "$(value "$1-$2" $key)" ] ||
            { wrong "$1 on $2 ranks: $key $(value "$1-$2" $key), not $(value "$1" $key)"; return; }
    done
    for table in "$out/$1"/*.csv; do
        cmp -s "$table" "$out/$1-$2/$(basename "$table")" ||
            { wrong "$1 on $2 ranks: $(basename "$table") differs"; return; }
    done
    good "$1 on $2 ranks: $(value "$1" steps) steps, $(value "$1" rebuilds) lists, $(hash "$1")"
}

# Water that falls, hits a wall and climbs it; the same with a pressure that is solved for, beside a
# piston, and in three dimensions; in a tank that moves; without any wall, all round; in three
# dimensions.
numbers='1 2 3 4'
[ -z "${STIFFWATER_LONG-}" ] || numbers='1 2 3 4 8'
same dam 2 dam-break spacing=0.005 until=0.25
same pressed 2 mps-dam-break spacing=7.3e-3 until=0.1
numbers='3'
same pushed 2 wave-maker until=0.05 method=mps walls=own-density 'wall.piston.from=[-0.06, -0.06]'
same cube 3 ../../tests/scenes/still-cube until=0.02
same tank 2 sloshing-tank until=0.3
same vortex 2 taylor-green until=0.2
same drop 2 elliptic-drop until=0.002
same column 3 dam-break-3d spacing=0.0555 until=0.02

# What one step of a solve refuses, all refuse, and say once.
ranks 2 "$top_builddir/stiffwater-2d-mpi" run "$scenes/mps-dam-break.scene" until=0.001 mps.iterations=1 \
    -q -o "$out/few"
if [ $code = 1 ] && [ "$(grep -c 'no pressure is found' "$out/said")" = 1 ]; then
    good "a solve that fails on all ranks is told once"
else
    wrong "a solve that fails on all ranks is told once: status $code"
    cat "$out/said"
fi

# --- as a user starts them --------------------------------------------------------------------
go three "$scenes/dam-break.scene" spacing=0.005 until=0.25 --ranks 3
if [ $code = 0 ] && [ "$(value three ranks)" = 3 ] && [ "$(hash three)" = "$(hash dam)" ]; then
    good "run --ranks 3 has the hash of one rank"
else
    wrong "run --ranks 3 has the hash of one rank: status $code"
    cat "$out/three.said"
fi
code=0
"$STIFFWATER" run --ranks 2 -q -o "$out/two" - <"$scene" >"$out/said" 2>&1 || code=$?
refused "ranks want a scene that all can read" 'the scene must be a file'

if ldd "$top_builddir/stiffwater-2d" 2>/dev/null | grep -q libmpi; then
    wrong "the serial program links no MPI"
else
    good "the serial program links no MPI"
fi
finish
