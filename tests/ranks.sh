#!/bin/sh
# ranks.sh -- what ranks do together, on 1, 2, 3 and 4 of them (8, too, in ranks-long.sh), and what
# the programs for many ranks refuse.
# Each claim is made once here, within a minute of two cores; ranks-long.sh makes the same of longer
# runs, of more scenes and methods, and on more ranks.
. "${top_srcdir:-.}/tests/lib.sh"
. "$top_srcdir/tests/mpi.sh"
need_ranks

long=${RANKS_LONG-}

# at_length COMMAND...: in ranks-long.sh alone
at_length() {
    [ -z "$long" ] || "$@"
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
at_length programs 8

# Where one of them has no memory to wake others in, each sleeps for itself.
if mpicc -O1 -shared -fPIC -o "$out/no-window.so" "$top_srcdir/tests/ranks/no-window.c" 2>"$out/said"; then
    ranks 3 -x LD_PRELOAD="$out/no-window.so" "$top_builddir/tests/ranks/room" 3
    claim "without memory of all, ranks work the same" "$code == 0 && $(grep -c '^ok' "$out/said") > 60"
else
    echo "skipped: there is no mpicc to refuse memory with"
fi

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
scenes=$top_srcdir/data/scenes
ranks 2 "$top_builddir/stiffwater-2d-mpi" explain tait
refused "no other command is shared" "2 ranks share .run., .resume. and .check., and no other"
ranks 2 "$top_builddir/stiffwater-2d-mpi" sweep "$scene" tol=0.1,0.2 -o "$out/many"
refused "many runs are not shared, with advice" '.--jobs N has N runs at a time'
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
# piston, and in three dimensions; in a tank that moves; without any wall, all round; that leaves the
# domain and comes back; in three dimensions.
if [ -n "$long" ]; then numbers='1 2 3 4 8' fall=0.25; else numbers='1 2 3 4' fall=0.05; fi
levels= # whose columns ranks share, and a line of points
for place in 04 08 12 16 20 24 28; do levels="$levels probe.at$place.what=height probe.at$place.at=[0.$place,0]"; done
same dam 2 dam-break spacing=0.005 until=$fall $levels probe.speed.what=velocity 'probe.speed.at=[0.02,0.1]' \
    'probe.speed.to=[0.28,0.1]'
at_length same pressed 2 mps-dam-break spacing=7.3e-3 until=0.1
numbers='3'
[ -n "$long" ] || same pressed 2 mps-dam-break spacing=7.3e-3 until=0.01
at_length same pushed 2 wave-maker until=0.05 method=mps walls=own-density 'wall.piston.from=[-0.06, -0.06]'
at_length same cube 3 ../../tests/scenes/still-cube until=0.02
at_length same tank 2 sloshing-tank until=0.3
same vortex 2 taylor-green until=0.2
same jump 2 ../../tests/scenes/jumping-drops
at_length same drop 2 elliptic-drop until=0.002
if [ -n "$long" ]; then drop=0.02; else drop=0.01; fi
same column 3 dam-break-3d spacing=0.0555 until=$drop

# Bodies, which each rank moves for itself, by the forces of all: beams of both theories, rigid
# bodies with joints and contacts; records in single precision; a method of each family.
small=../../tests/scenes/small
beam="walls=own-density beam.plate.E=1e6 beam.plate.theory=linear"
same beam 2 toth-beam until=0.007
at_length same mri 2 $small-2d until=0.004 $beam method=mri
same box 2 floating-box until=0.01
same cubes 3 flood-six-cubes until=0.003 spacing=0.05 'domain.from=[-1,0,0]' 'fluid.water.from=[-1,0,0]'
at_length same single 2 dam-break until=0.01 spacing=0.01 precision=single
at_length same euler 2 dam-break until=0.02 spacing=0.01 method=euler-cfl@4 # forces, of whichever rank, give its steps
if [ -n "$long" ]; then
    same plate 2 $small-2d until=0.004 $beam
    same contact 2 $small-2d until=0.004 beam.plate.E=1e6 walls=contact
    same elastica 2 $small-2d until=0.004 walls=own-density beam.plate.theory=elastica beam.plate.E=1e6
    same staggered 2 $small-2d until=0.003 $beam method=staggered
    same hinge 2 pendulum-gate until=0.01
    same inner 2 floating-box until=0.003 method=mri-rigid
    for method in ab3 leapfrog euler-cfl adams gsl-rkf45 erk3 imex3; do
        same $method 2 dam-break until=0.01 spacing=0.01 method=$method
    done
fi

# --- particles that change their rank --------------------------------------------------------
# anew HOW NAME N KEY=VALUE...: a run on N ranks that cut anew so often has the bits of run NAME
anew() {
    STIFFWATER_BALANCE=$1 run=$2 n=$3
    export STIFFWATER_BALANCE
    shift 3
    ranks "$n" "$top_builddir/stiffwater-2d-mpi" run "$scenes/dam-break.scene" output.fields=100 \
        output.snapshots=0 -q -f -o "$out/$run-$n" "$@"
    if [ $code = 0 ]; then
        bits "$run" "$n"
        echo "cut anew ($STIFFWATER_BALANCE): $(value "$run-$n" repartitions) times," \
            "$(value "$run-$n" particles_moved) particles moved"
    else wrong "$run, cut anew ($STIFFWATER_BALANCE): status $code"; cat "$out/said"; fi
    unset STIFFWATER_BALANCE
}
if [ -n "$long" ]; then moving="spacing=0.005 until=0.12" cuts="never 7 23" least=50
else moving="spacing=0.005 until=0.05" cuts=7 least=20; fi
well moving "$scenes/dam-break.scene" $moving
STIFFWATER_LANES=2 # which all machines have: how evenly rows can be shared depends on it
export STIFFWATER_LANES
for often in $cuts; do
    anew $often moving 3 $moving
    [ $often = never ] || claim "particles move, work is equal" "$(value moving-3 particles_moved) > $least \
        && $(value moving-3 imbalance_after) <= 1.05"
done
if [ -n "$long" ]; then
    anew 7 moving 4 $moving
    claim "so few particles are shared evenly" "$(value moving-4 imbalance_after) <= 1.05"
fi
unset STIFFWATER_LANES
if [ -n "$long" ]; then # water that runs along the floor: ranks come to own walls far from where theirs were
    far="spacing=0.01 until=0.5 walls=own-density"
    well far "$scenes/dam-break.scene" $far
    anew 1 far 4 $far
fi
at_length claim "ranks whose work is unequal cut anew" "$(value dam-3 repartitions) > 0 && $(value dam-3 imbalance_before) > 1.1 \
    && $(value dam-3 imbalance_after) < $(value dam-3 imbalance_before)"
past="spacing=0.01 until=0.01 method=adams"
well past "$scenes/dam-break.scene" $past
anew 3 past 2 $past
claim "the past of a method goes along" "$(value past-2 particles_moved) > 20"
STIFFWATER_BALANCE=5
export STIFFWATER_BALANCE
ranks 3 "$top_builddir/stiffwater-2d-mpi" run "$scenes/dam-break.scene" spacing=0.002 until=0.002 -q -f \
    output.fields=100 output.snapshots=0 output.interval=1 -o "$out/fine"
unset STIFFWATER_BALANCE
claim "imbalance after a cut" "$(value fine repartitions) > 0 && $(value fine imbalance_after) <= 1.1"
# What reads numbers of all particles: solves, sums over sums, forces beside the weight, filters,
# methods that add up for themselves, other norms; and no fluid, with nothing to share.
if [ -n "$long" ]; then numbers='2 3'; else numbers='2'; fi
same implicit 2 poiseuille until=0.01
same ahead 2 closed-tank until=0.002
at_length same drawn 2 oscillating-drop until=0.005 spacing=0.05 norm=wrms
at_length same shifted 2 standing-wave spacing=0.05 until=0.01
same stuck 2 dam-break spacing=0.025 until=0.01 walls=adami effects.shepard-filter.steps=5 method=bdf \
    norm=p8
same dry 2 beam-alone until=1e-4
numbers='3'
at_length same dv 2 dam-break spacing=0.025 until=0.03 method=dv
for method in pcisph gsl-msadams; do
    at_length same $method 2 dam-break spacing=0.025 until=0.01 method=$method walls=own-density
done
if [ -n "$long" ]; then
    numbers='2 3'
    same thick 2 $small-2d until=0.003 beam.plate.E=1e5 beam.plate.theory=linear \
        effects.laminar-viscosity.mu=5 effects.laminar-viscosity.side=implicit
    same halves 2 $small-2d until=0.01 beam.plate.E=1e5 beam.plate.theory=linear method=dv walls=contact
    same gate 2 gate until=0.02 eos.type=look-ahead spacing=0.01
    same wide 3 $small-3d until=0.01 walls=own-density effects.xsph={} norm=p8 method=gsl-msadams
    same first 3 $small-3d until=0.02 method=adams # its first step is bounded by rates of all rows
    same lid 2 driven-cavity spacing=0.04 until=0.01 'wall.lid.from=[-0.12,1]' 'wall.lid.to=[1.12,1.12]'
    same cluster 2 clustering spacing=4e-3 particle_mass=0.0176 tol=1e-3 until=0.003
fi

# --- checkpoints --------------------------------------------------------------------------------
# on N M: a run on N ranks, killed late, goes on on M
on() {
    rm -rf "$out/parts"
    ranks "$1" "$top_builddir/stiffwater-${d}d-mpi" run "$kept" $keys -o "$out/parts"
    rm "$out/parts/checkpoint.h5"
    [ $code = 0 ] && ranks "$2" "$top_builddir/stiffwater-${d}d-mpi" resume "$out/parts" -q
    if [ $code = 0 ] && diff -r -q -x run.json -x 'checkpoint*.h5' "$out/whole" "$out/parts" &&
        [ "$(hash whole)" = "$(hash parts)" ]; then good "kept by $1 ranks, resumed by $2: all files are those of one"
    else wrong "kept by $1 ranks, resumed by $2: status $code"; cat "$out/said"; fi
}
d=2
kept=$scenes/floating-box.scene
keys="until=0.02 output.checkpoint=0.012 output.interval=0.004 -q"
"$STIFFWATER" run "$kept" $keys -o "$out/whole" >"$out/said" 2>&1 || cat "$out/said"
on 1 3
at_length on 2 1
on 3 2
if [ -n "$long" ]; then # all rows
    cp -R "$out/whole" "$out/kept"
    kept=$scenes/standing-wave.scene
    keys="spacing=0.05 until=0.06 output.checkpoint=0.02 output.interval=0.01 method=imex3 -q"
    rm -rf "$out/whole"
    "$STIFFWATER" run "$kept" $keys -o "$out/whole" >"$out/said" 2>&1 || cat "$out/said"
    on 3 2
    d=3 kept=$scenes/flood-six-cubes.scene # surfaces among points of particles
    keys="until=0.003 output.checkpoint=0.002 spacing=0.05 domain.from=[-1,0,0] fluid.water.from=[-1,0,0] -q"
    rm -rf "$out/whole"
    "$STIFFWATER" run "$kept" $keys -o "$out/whole" >"$out/said" 2>&1 || cat "$out/said"
    on 3 2
    d=2 kept=$scenes/floating-box.scene
    keys="until=0.02 output.checkpoint=0.012 output.interval=0.004 -q"
    rm -rf "$out/whole"
    mv "$out/kept" "$out/whole"
    on 2 3
fi
"$STIFFWATER" resume "$out/parts" until=0.022 --ranks 2 -q >"$out/said" 2>&1 || cat "$out/said"
"$STIFFWATER" resume "$out/whole" until=0.022 -q >"$out/said" 2>&1 || cat "$out/said"
if [ "$(value parts ranks)" = 2 ] && [ "$(hash whole)" = "$(hash parts)" ]; then good "resume --ranks 2"
else wrong "resume --ranks 2"; cat "$out/said"; fi

# A density out of bounds is refused by all: as many short steps, the same end.
narrow="$scenes/dam-break.scene spacing=0.01 until=0.2 tol=10 eos.highest=1.01"
alone=0
"$STIFFWATER" run $narrow output.fields=100 output.snapshots=0 -q -o "$out/narrow" >"$out/said" 2>&1 || alone=$?
ranks 2 "$top_builddir/stiffwater-2d-mpi" run $narrow output.fields=100 output.snapshots=0 -q -f -o "$out/narrow-2"
if [ $alone$code = 11 ] && [ "$(value narrow refused)" -gt 9 ] \
    && [ "$(value narrow refused)" = "$(value narrow-2 refused)" ]; then
    bits narrow 2
    good "a density is refused $(value narrow-2 refused) times on 2 ranks as on one"
else
    wrong "a density that is refused: status $alone alone and $code on 2," \
        "$(value narrow refused) and $(value narrow-2 refused) times"
fi

# --- what ranks say ------------------------------------------------------------------------------
# A right-hand side asks all once: who has to make a list or to refuse, and whether they are at one
# time; once all hear the forces on solids, and with them powers.  Norms of a step ask all once.
# Messages go to those alone whose rows are neighbours.
if mpicc -O1 -shared -fPIC -o "$out/counters.so" "$top_srcdir/tests/ranks/counters.c" 2>"$out/said"; then
    counted() { # SCENE UNTIL KEY=VALUE...
        file=$scenes/$1.scene until=$2
        shift 2
        ranks 3 -x STIFFWATER_BALANCE=never -x LD_PRELOAD="$out/counters.so" "$top_builddir/stiffwater-2d-mpi" run \
            "$file" until="$until" output.interval=1 output.fields=100 output.snapshots=0 -q -f -o "$out/counted" "$@"
        for what in allreduces gathers gathered exchanges messages bytes; do
            eval "$what=\$(sed -n 's/.*$what \([0-9]*\).*/\1/p' \"\$out/said\")"
        done
        steps=$(value counted steps) rhs=$(value counted rhs_explicit) lists=$(value counted rebuilds)
        asking=$((rhs + steps + $(value counted rejected))) # right-hand sides and norms
    }
    counted taylor-green 0.01
    other=$((asking - allreduces))
    counted taylor-green 0.03
    claim "without solids: one allreduce a right-hand side and one a norm, in what the longer of two runs has more" \
        "$asking - $allreduces >= $other"
    counted dam-break 1e-4 spacing=0.005
    let_go=$gathers
    rest="fluid.left.initial=rest fluid.right.initial=rest" # else gathers of its start come, too
    counted dam-break 1e-4 spacing=0.005 $rest
    claim "a start that is let go is shared: sums of its solves come from all ranks" "$let_go > $gathers + 100"
    counted dam-break 0.02 spacing=0.005 $rest
    other=$((asking - allreduces))
    counted dam-break 0.06 spacing=0.005 $rest
    echo "3 ranks, $steps steps, $rhs right-hand sides, $lists lists: $allreduces allreduces," \
        "$gathers gathers of $gathered bytes, $exchanges exchanges, $messages messages, $bytes bytes"
    claim "allreduces: one a right-hand side and one a norm, in what the longer of two runs has more" \
        "$asking - $allreduces >= $other"
    claim "exchanges, one a right-hand side, one where a list may be old, two a list" \
        "$exchanges <= 2 * $rhs + 2 * $lists"
    claim "gathers: forces on solids, limits and extremes of a step, four a list: one when it may first be old" \
        "$gathers <= $rhs + 2 * $steps + 4 * $lists + 30"
    claim "messages" "$messages <= 2 * $exchanges"
else
    echo "skipped: there is no mpicc to count with"
fi

# `check` foretells the memory of the first rank within 10 %, and what a right-hand side sends.
if grep -q __asan_init "$top_builddir/stiffwater-2d"; then
    echo "skipped: memory is not what it is under a sanitizer"
else
    ranks 3 "$top_builddir/stiffwater-2d-mpi" check "$scenes/dam-break.scene"
    told=$(sed -n 's/^memory: about \([0-9.]*\) MB.*/\1/p' "$out/said")
    asked=$(sed -n 's/^ *\([0-9]*\) questions to all.*/\1/p' "$out/said")
    ranks 3 "$top_builddir/stiffwater-2d-mpi" run "$scenes/dam-break.scene" until=2e-4 output.interval=1e-4 \
        output.fields=1e-4 output.snapshots=0 -q -o "$out/taken"
    taken=$(awk -v kb="$(value taken peak_rss_kb)" 'BEGIN { print 1024e-6 * kb }')
    claim "memory of the first rank, told and taken" "$told > 0.9 * $taken && $told < 1.1 * $taken"
    claim "questions of a right-hand side" "$asked == 1"
fi

# So of each rank, where fluid is let go: it has all rows for that, gives back what it took, and has its own
# rows alone afterwards.
if [ -e "$out/counters.so" ] && ! grep -q __asan_init "$top_builddir/stiffwater-3d"; then
    ranks 3 "$top_builddir/stiffwater-3d-mpi" check "$scenes/dam-break-3d.scene" spacing=0.037
    told=$(sed -n 's/^memory: about \([0-9.]*\) MB.*/\1/p' "$out/said")
    others=$(sed -n 's/.*first rank, at most \([0-9.]*\) MB.*/\1/p' "$out/said")
    ranks 3 -x LD_PRELOAD="$out/counters.so" "$top_builddir/stiffwater-3d-mpi" run "$scenes/dam-break-3d.scene" \
        spacing=0.037 until=4e-4 output.fields=100 output.snapshots=0 -q -o "$out/let-go"
    taken=$(awk -v kb="$(value let-go peak_rss_kb)" 'BEGIN { print 1024e-6 * kb }')
    claim "memory of the first rank in 3D, told and taken" "$told > 0.9 * $taken && $told < 1.1 * $taken"
    taken=$(sed -n 's/.*others \([0-9]*\) kB.*/\1/p' "$out/said" | awk '{ print 1024e-6 * $1 }')
    claim "memory of the others" "$others > 0.9 * $taken && $others < 1.1 * $taken"
fi

# What goes to partners is what passes declare to read of neighbours, and no more.
for walls in own-density contact; do
    ranks 3 "$top_builddir/stiffwater-2d-mpi" check "$scenes/dam-break.scene" spacing=0.01 walls=$walls
    sent=$(sed -n 's/.*to partners at most, of at most \([0-9.]*\) kB.*/\1/p' "$out/said")
    read=$(sed -n 's/.*kB a rank together: \([0-9]*\) numbers.*/\1/p' "$out/said")
    claim "bytes to partners, walls = $walls: 8 a number that passes read, and a tenth" \
        "$read > 0 && 1000 * $sent <= 1.1 * 8 * $read"
done

# --- ends that come early ------------------------------------------------------------------------
# under DIRECTORY: a run on 3 ranks that has kept a checkpoint; mpirun is $pid, the last rank $victim
under() {
    begun=$(date +%s)
    timeout 60 "$mpirun" -q --oversubscribe --bind-to none -n 3 "$top_builddir/stiffwater-2d-mpi" run \
        "$scenes/dam-break.scene" until=5 output.checkpoint=0.02 -q -o "$1" >"$out/said" 2>&1 &
    pid=$!
    while [ ! -e "$1/checkpoint.h5" ] && [ $(($(date +%s) - begun)) -lt 20 ]; do sleep 0.2; done
    victim=$(pgrep -P $(pgrep -P $pid) | tail -n 1)
}
under "$out/killed"
sleep 1
begun=$(date +%s)
kill -9 "$victim" || true
code=0
wait $pid || code=$?
claim "a killed rank ends the run, in s" "$code != 0 && $(date +%s) - $begun <= 10"
whole killed
under "$out/stopped"
kill -TERM "$victim" || true
code=0
wait $pid || code=$?
claim "a rank that is told to stop stops all" "$code == 3 && $(grep -c 'stopped by signal 15 at' "$out/said") == 1"
claim "and the run says so" "$(grep -c '"status": "stopped"' "$out/stopped/run.json") == 1"
whole stopped

# Memory that the last rank alone lacks, from reading the scene to the last step: all end with one
# status, and nothing waits for ever.
if ${CC:-cc} -O1 -shared -fPIC -o "$out/refuse.so" "$top_srcdir/tests/failing-malloc.c" 2>"$out/said"; then
    program=$top_builddir/stiffwater-2d-mpi
    lacking() {
        set -- "$1" "$program" run "$scenes/dam-break.scene" spacing=0.025 until=0.01 $more output.fields=100 \
            output.snapshots=0 -q -f -o "$out/lacking"
        request=$1
        shift
        code=0
        timeout 60 "$mpirun" -q --oversubscribe --bind-to none -n 1 "$@" : -n 1 env LD_PRELOAD="$out/refuse.so" \
            FAIL_ONLY=stiffwater FAIL_COUNT=1 FAIL_ONCE="$request" "$@" >"$out/said" 2>&1 || code=$?
    }
    lacks() {
        more=$*
        lacking 100000000
        all=$(sed -n 's/requests: //p' "$out/said")
        for share in $shares; do
            lacking $((all * share / 100))
            if [ $code = 1 ] && [ "$(grep -c 'out of memory' "$out/said")" = 1 ]; then
                good "request $((all * share / 100)) of $all is refused to one rank: all end with status 1"
            else wrong "request $((all * share / 100)) of $all is refused: status $code"; cat "$out/said"; fi
        done
    }
    if [ -n "$long" ]; then shares='12 55 70 83 85 98'; else shares='12 85'; fi
    lacks
    at_length lacks walls=adami method=bdf
else
    echo "skipped: no library that refuses memory"
fi

# Ranks that have not read the same: what differs is told, once.
# differ TEXT PROGRAM ARGUMENT... : ARGUMENT...: of the first rank, and of one more that has these, too
differ() {
    text=$1 first=
    shift
    while [ "$1" != : ]; do
        first="$first $1"
        shift
    done
    shift
    # shellcheck disable=SC2086 # words
    ranks 1 $first : -n 1 $first "$@"
    if [ "$code" = 2 ] && [ "$(grep -c -F -e "$text" "$out/said")" = 1 ]; then good "told once: $text"
    else wrong "told once, status $code: $text"; cat "$out/said"; fi
}
dam="$top_builddir/stiffwater-2d-mpi run $scenes/dam-break.scene spacing=0.025 until=0.01 -q -f -o $out/differ"
differ 'says `spacing = 0.025` where that of rank 1 says `spacing = 0.0125`' $dam : spacing=0.0125
differ 'says `no more settings` where that of rank 1 says `tol = 0.02`' $dam : tol=0.02
at_length differ 'where that of rank 1 says `eos.c0 = 25`' $dam : eos.c0=25
at_length differ 'says `tol = 0.02` where that of rank 1 says `tol = 0.0201`' \
    "$top_builddir/stiffwater-2d-mpi" check "$scenes/dam-break.scene" tol=0.02 : tol=0.0201
claim "none of them has written" "$([ -e "$out/differ" ] && echo 1 || echo 0) == 0"

# A rank that stands elsewhere does not see the directory of results.
if [ -n "$long" ]; then
    mkdir "$out/here" "$out/there"
    set -- "$top_builddir/stiffwater-2d-mpi" run "$(cd "$scenes" && pwd)/dam-break.scene" spacing=0.025 until=0.01 -q -o results
    code=0
    timeout 60 "$mpirun" -q --oversubscribe --bind-to none -n 1 -wdir "$out/here" "$@" : -n 1 -wdir "$out/there" "$@" \
        >"$out/said" 2>&1 || code=$?
    claim "a directory that one rank does not see is told of once" "$code == 4 \
        && $(grep -c 'all must see the directory of results under one path' "$out/said") == 1"
fi

# The disk is full for the last rank alone: a file that all write is there whole or not at all, for all.
if ${CC:-cc} -O1 -shared -fPIC -o "$out/full.so" "$top_srcdir/tests/ranks/full-disk.c" 2>"$out/said"; then
    # full NAME: a run whose last rank cannot write files with this in their path
    full() {
        rm -rf "$out/full"
        set -- "$1" "$top_builddir/stiffwater-2d-mpi" run "$scenes/dam-break.scene" spacing=0.025 until=0.01 \
            output.checkpoint=0.005 output.fields=0.005 -q -o "$out/full"
        name=$1
        shift
        code=0
        timeout 60 "$mpirun" -q --oversubscribe --bind-to none -n 1 "$@" : -n 1 env LD_PRELOAD="$out/full.so" \
            FULL="$name" "$@" >"$out/said" 2>&1 || code=$?
    }
    full 000001.vtkhdf
    claim "a particle file that one rank cannot write ends all" \
        "$code == 4 && $(grep -c '000001.vtkhdf: cannot be written: No space left' "$out/said") == 1"
    claim "those before it are whole, and it is not there" "$(grep -c 'Time Value' "$out/full/fields.xdmf") == 1 \
        && $(find "$out/full/fields" -name '*.vtkhdf' | wc -l) == 1 && $(find "$out/full/fields" -name '*.part' | wc -l) == 0"
    full checkpoint.h5
    claim "a checkpoint that one rank cannot write is missed once a time, and the run goes on" \
        "$code == 0 && $(grep -c 'no checkpoint at t = .*No space left' "$out/said") == 3"
    claim "and none is there" "$(find "$out/full" -name 'checkpoint*.h5*' | wc -l) == 0"
else
    echo "skipped: no library that fills a disk"
fi

# A rank with another libm takes steps of another length, and then all are told, and end.
if ${CC:-cc} -O1 -shared -fPIC -o "$out/libm.so" "$top_srcdir/tests/ranks/other-libm.c" -ldl 2>"$out/said"; then
    set -- "$top_builddir/stiffwater-2d-mpi" run "$scenes/dam-break.scene" spacing=0.025 until=0.02 output.fields=100 \
        output.snapshots=0 -q -f -o "$out/apart"
    code=0
    timeout 60 "$mpirun" -q --oversubscribe --bind-to none -n 1 "$@" : -n 1 env LD_PRELOAD="$out/libm.so" "$@" \
        >"$out/said" 2>&1 || code=$?
    if [ $code = 1 ] && [ "$(grep -c 'ranks have come to different times' "$out/said")" = 1 ]; then
        good "ranks that are not at one time end with one message"
    else wrong "ranks that are not at one time: status $code"; cat "$out/said"; fi
    ${CC:-cc} -DCOUNTS -O1 -shared -fPIC -o "$out/counts.so" "$top_srcdir/tests/ranks/other-libm.c" -ldl
    set -- "$top_builddir/stiffwater-2d-mpi" run "$scenes/wave-maker.scene" until=0.01 -q -f -o "$out/apart"
    ranks 1 "$@" : -n 1 env LD_PRELOAD="$out/counts.so" "$@"
    claim "ranks that place different solids are told so once" "$code == 2 && \
        $(grep -c 'from [0-9]* to [0-9]* particles of solids' "$out/said") == 1"
fi

# What each looks for in its own rows is told as on one rank, in the same words.
run_away="spacing=0.025 until=0.3 eos.fastest=0.1 eos.c0=10 -q"
code=0
"$STIFFWATER" run "$scenes/dam-break.scene" $run_away -o "$out/fast" >"$out/fast.said" 2>&1 || code=$?
ranks 3 "$top_builddir/stiffwater-2d-mpi" run "$scenes/dam-break.scene" $run_away -o "$out/fast-3"
if [ $code = 1 ] && [ "$(sed -n 's/; take a higher.*//p' "$out/fast.said")" = "$(sed -n 's/; take a higher.*//p' "$out/said")" ] &&
    grep -q 'has run away' "$out/said" && [ "$(hash fast)" = "$(hash fast-3)" ]; then
    good "fluid that runs away is told of as on one rank"
else
    wrong "fluid that runs away is told of as on one rank: status $code"
    cat "$out/fast.said" "$out/said"
fi

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
go three "$scenes/dam-break.scene" spacing=0.005 until=$fall --ranks 3
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
