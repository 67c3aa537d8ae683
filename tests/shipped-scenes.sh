#!/bin/sh
# shipped-scenes.sh -- every scene of data/scenes is checked and run for a moment: its
# books close, its files have the columns that scripts read, and the same scene ends in
# the same bits however it is run.
#
# Run by `make check`; each scene takes a few seconds.
scenes=${top_srcdir:-.}/data/scenes
. "${top_srcdir:-.}/tests/lib.sh"
asking
# What a second run shows is no matter of memory; `check' is tried under a sanitizer by tests/cli.sh.
sanitized=$(grep -l __asan_init "$top_builddir/stiffwater-2d")
part=3 # of the time of a scene; a sanitizer makes each step ten times as slow
[ -z "$sanitized" ] || part=12
[ -z "${STIFFWATER_LONG-}" ] || part=1

# at_most NAME NUMBER LIMIT
at_most()
{
    awk -v x="$2" -v most="$3" 'BEGIN { if (x == "") exit 1; if (x < 0) x = -x
                                        exit !(x <= most) }' ||
        complain "$1 is $2, at most $3 is expected"
}

# run NAME SCENE OPTION ...
run()
{
    name=$1
    shift
    "$STIFFWATER" run "$@" -q -o "$name" >"said" 2>&1 ||
        complain "$name: exit status $?"
}

# table FILE PATTERN: names in the first line without #, as many fields in each row, no
# number that is none
table()
{
    grep -q '^# units: ' "$1" || complain "$1 has no line of units"
    grep -v '^#' "$1" | head -n 1 | grep -q -x -E "$2" ||
        complain "$1: $(grep -v '^#' "$1" | head -n 1) is not $2"
    awk -F, '/^#/ { next }
        { gsub(/"[^"]*"/, "text") }
        !n { n = NF; next }
        NF != n { print FILENAME ":" FNR ": " NF " fields instead of " n; bad = 1 }
        /nan|inf/ { print FILENAME ":" FNR ": " $0; bad = 1 }
        { rows++ }
        END { exit bad || !rows }' "$1" || complain "$1 is no table"
}

tables()
{
    axes=xy
    [ "$(value "$1" dimension)" = 3 ] && axes=xyz
    momentum=$(echo $axes | sed 's/\(.\)/,momentum_\1/g')
    force=$(echo $axes | sed 's/\(.\)/,[a-z]+\\.f\1/g')$(echo $axes | sed 's/\(.\)/,[a-z]+\\.i\1/g')
    table "$1/book.csv" \
        "t,kinetic,potential,internal,elastic(,[-a-z0-9.]+)*,pressure_defect,total,defect,mass$momentum"
    table "$1/steps.csv" 't,h,limiter,where,rejected'
    [ "$(value "$1" fluid)" = 0 ] || grep -q '^ *periodic = \["' "$1/scene.used" ||
        table "$1/front.csv" 't,x,height'
    [ "$(value "$1" fluid)" = 0 ] || table "$1/pairing.csv" 't,pairing,nearest_mean,nearest_least'
    [ "$(value "$1" wall)" = 0 ] || table "$1/forces.csv" "t($force)+"
    grep -q '^beam ' "$1/scene.used" && table "$1/beam.csv" \
        't(,[a-z]+\.tip_x,[a-z]+\.tip_y,[a-z]+\.mid_x,[a-z]+\.mid_y,[a-z]+\.tip_angle,[a-z]+\.root_force,[a-z]+\.root_moment)+'
    grep -q '^probe ' "$1/scene.used" && table "$1/probes.csv" 't(,[a-zA-Z0-9]+)+'
    [ -z "$(find "$1" -size 0)" ] || complain "$1 holds an empty file"
}

books()
{
    [ "$(value "$1" status)" = "done" ] || complain "$1: status $(value "$1" status)"
    for key in message scene version method table norm tol threads t_end state_size steps rejected \
        rhs_explicit rhs_implicit pair_passes rebuilds cpu_s wall_s threads_mean mean_step error stability \
        output escaped energy_initial energy_defect energy_defect_max momentum_defect density_min \
        density_max peak_rss_kb state_hash; do
        grep -q "\"$key\":" "$1/run.json" || complain "$1/run.json has no $key"
    done
    at_most "$1: time of the end" "$(value "$1" t_end)" "$2"
    at_most "$1: escaped" "$(value "$1" escaped)" 0
    energy=$(awk -F, '/^#/ { next } { e = $2 + $3 + $4 + $5 } e > most { most = e }
                      END { print most }' "$1/book.csv")
    at_most "$1: energy defect of $energy J" "$(value "$1" energy_defect_max)" \
        "$(awk -v e="$energy" 'BEGIN { print 1e-3 * e }')"
    at_most "$1: momentum defect [N s]" "$(value "$1" momentum_defect)" "$lost"
}

# same RUN OTHER WHAT
same()
{
    [ "$(value "$1" state_hash)" = "$(value "$2" state_hash)" ] ||
        complain "$1: $3 changes the final state"
}

# shorter NAME UNTIL: a part of the time has the same steps to look at; but what falls without
# water has to land, a flow from rest to get some energy, and the momentum of beams does not close
# in their first steps.
shorter()
{
    case $1 in
    block-* | rolling-disc | couette) echo "$2" ;;
    beam-alone | elastica | elastic-obstacle | soft-gate) in_parts "$2" $((part < 3 ? part : 3)) ;;
    *) in_parts "$2" $part ;;
    esac
}

in_parts()
{
    awk -v t="$1" -v parts="$2" 'BEGIN { printf "%.2g", t / parts }'
}

# spared NAME: a sanitizer sees nothing in it that it does not see in flood-six-cubes
spared()
{
    case $1 in
    flood-one-cube | flood-three-cubes) [ $part = 12 ] ;;
    *) false ;;
    esac
}

# scene NAME UNTIL INTERVAL KEY=VALUE...
scene()
{
    base=$1
    until=$2
    interval=$3
    shift 3
    tried=$((tried + 1))
    if spared "$base"; then
        mkdir "$base"
        return
    fi
    [ "$sanitized" ] || "$STIFFWATER" check "$scenes/$base.scene" "$@" >"said" 2>&1 ||
        complain "check $base.scene: exit status $?"
    until=$(shorter "$base" "$until")
    run "$base" "$scenes/$base.scene" "$@" --until "$until" --threads 2
    books "$base" "$until"
    tables "$base"
    [ -z "$sanitized" ] || return
    run "$base.again" "$base/scene.used" --threads 1 output.interval="$interval" \
        output.fields="$until" output.snapshots=3
    same "$base" "$base.again" "its own scene.used, one thread, or the rhythm of outputs"
}

# fails NAME: a scene that is there to fail ends so, with a reason and all its files
fails()
{
    tried=$((tried + 1))
    "$STIFFWATER" check "$scenes/$1.scene" >"said" 2>&1 ||
        complain "check $1.scene: exit status $?"
    "$STIFFWATER" run "$scenes/$1.scene" -q -o "$1" >"said" 2>&1
    code=$?
    [ "$code" = 1 ] || complain "$1: exit status $code, 1 is expected"
    [ "$(value "$1" status)" = failed ] || complain "$1 has not failed"
    [ "$(value "$1" message)" ] || complain "$1 fails without a message"
    tables "$1"
}

# A flume of 1 m of water instead of 3.5 m does for a moment.
near='domain.from=[-1,0,0] fluid.water.from=[-1,0,0]'
lost=1e-9
scene dam-break 0.03 1.7e-3
scene still-water 0.1 3.3e-3
scene toth-beam 0.03 7e-4
scene light-plate 0.03 1.1e-3
scene closed-tank 0.05 1.1e-3
scene floating-box 0.05 1.1e-3
scene block-stack 0.3 1e-3
scene block-heap 0.4 1e-3
scene rolling-disc 0.3 1e-3
scene floating-disc 0.05 1.1e-3
scene floating-wedge 0.05 1.1e-3
scene floating-boat 0.01 1.1e-3 spacing=3.3333333333333333e-2
scene box-in-waves 0.05 1.1e-3 spacing=0.025
scene moored-box 0.05 1.1e-3
lost=1e-6 # momentum follows from an angle, so that it closes as steps do, not to rounding
scene pendulum-gate 0.05 1.1e-3
lost=1e-9
scene sinking-block 0.02 1.1e-3
scene rising-block 0.01 1.1e-3 spacing=0.004 'domain.to=[0.12,0.112,0.06]' 'fluid.water.to=[0.12,0.112,0.036]'
scene seed-003-blocks 0.03 1.1e-3
scene flood-one-cube 0.01 1.1e-3 spacing=0.05 $near
scene flood-three-cubes 0.01 1.1e-3 spacing=0.05 $near
scene flood-six-cubes 0.01 1.1e-3 spacing=0.05 $near
scene dam-break-3d 0.03 1.1e-3 spacing=0.0555
scene beam-alone 0.01 3.1e-5
scene elastica 0.3 1.7e-3
scene soft-gate 0.03 7e-4
scene toth-dam-break 0.03 1.7e-3 spacing=5e-3 tol=1e-3
scene toth-pcisph 0.05 2e-3 spacing=5e-3 method=pcisph@0.1
scene toth-fsi 0.05 2e-3 spacing=5e-3 method=pcisph@0.1
lost=8.4 # N s/m, the weight's: forces of its gradient, by the least pressure around, are not mutual
scene mps-dam-break 0.02 2e-3
lost=1e-9
scene toth-standard-sph 0.01 5e-4 spacing=5e-3 tol=1e-3
scene tank-sizes 0.01 3.3e-4
scene gate 0.12 1.7e-3 spacing=0.01
scene sloshing-tank 0.15 3.3e-3 spacing=0.02
scene wave-maker 0.1 3.3e-3 spacing=0.03
scene taylor-green 0.1 3.3e-3
scene poiseuille 0.1125 3.3e-3
scene couette 0.1125 3.3e-3
scene oscillating-drop 0.1 3.3e-3
scene elliptic-drop 5e-4 1.7e-5
scene rotating-square 0.1 3.3e-3
scene standing-wave 0.05 3.3e-3 spacing=0.05
scene driven-cavity 0.03 1.7e-3 spacing=0.04 'wall.lid.from=[-0.12,1]' 'wall.lid.to=[1.12,1.12]'
scene elastic-obstacle 0.03 7e-4
scene clustering 0.01 7e-4 spacing=4e-3 particle_mass=0.0176 tol=1e-3
fails toth-dam-break-literal
for path in "$scenes"/*.scene; do
    [ -d "$(basename "$path" .scene)" ] || complain "$path is not tried here"
done
finish
