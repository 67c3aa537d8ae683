#!/bin/sh
# hashes.sh -- proves that a change of structure changed no bit: runs some hundred short
# scenes and compares what their run.json says with tests/hashes.table.
#
#     tests/hashes.sh [OPTION...] [PROGRAM]      program: default $STIFFWATER
#       --few            rows that touch every part once (default), narrow lanes on the last number of threads
#       --quick          all rows, on the widest lanes and one thread
#       --whole          all rows (default with STIFFWATER_LONG)
#       --lanes LIST     of 2, 4 and 8, as in --lanes "2 8"; default: all this machine has
#       --threads LIST   default "1 2"
#       --only TEXT      rows whose scene, method and keys contain TEXT
#       --jobs N         runs at a time, default 2
#       --anew           writes the table instead; all lanes and threads must agree
#       --even-so        compares with a table of another libc, too
#       --table FILE     another table
#
# Every row must come out the same on all lanes and threads.  Bits also depend on libm (pow,
# exp and sin of two glibc, or of processors with and without FMA, may differ in the last)
# and step counts on SUNDIALS, so the table tells in its second line what it was made with.
# Elsewhere lanes and threads are compared with each other only.
#
# Columns, with tabs between them: status (done, failed, refused or an exit status) and what
# run.json calls dimension, method, steps, rhs_explicit, rhs_implicit, rebuilds, state_hash
# and message; `tables` is a checksum of the rows of all CSV files.  `default` asks for the
# scene's own method.  Scenes are those of the tree in which PROGRAM was built.
#
# Exit status: 0 the same, 1 a difference, 99 no result.
set -u
LC_ALL=C
OMP_WAIT_POLICY=passive
GOMP_SPINCOUNT=1 # as good as none, but short loops have threads, too: base/waiting.h
export LC_ALL OMP_WAIT_POLICY GOMP_SPINCOUNT
unset STIFFWATER_LANES
tab=$(printf '\t')
columns="scene${tab}method${tab}keys${tab}status${tab}dimension${tab}ran${tab}steps"
columns="$columns${tab}rhs_explicit${tab}rhs_implicit${tab}rebuilds${tab}state_hash"
columns="$columns${tab}tables${tab}message"

die() {
    echo "hashes: $*" >&2
    exit 99
}

# --- what to run ------------------------------------------------------------------------

# row LEVEL SCENE METHOD KEY=VALUE...
row() {
    level=$1 scene=$2 method=$3
    shift 3
    [ $# -gt 0 ] || set -- -
    printf '%s\t%s\t%s\t%s\n' "$level" "$scene" "$method" "$*"
}

# ship LEVEL SCENE KEY=VALUE...: with the scene's own method
ship() {
    level=$1 name=$2
    shift 2
    row "$level" "data/scenes/$name.scene" default "$@"
}

shipped_rows() {
    ship all dam-break until=0.2
    ship all still-water until=0.3
    ship all toth-beam until=0.25
    ship all light-plate until=0.02
    ship all closed-tank until=0.05
    ship all floating-box until=0.2
    ship all block-stack until=0.3
    ship all block-heap until=0.4
    ship few rolling-disc until=0.3
    ship all floating-disc until=0.1
    ship few floating-wedge until=0.1
    ship few floating-boat spacing=3.3333333333333333e-2 until=0.02
    ship all moored-box until=0.1
    ship few box-in-waves spacing=0.025 until=0.1
    ship few pendulum-gate until=0.1
    ship all sinking-block until=0.02
    ship all rising-block spacing=0.004 until=0.005 \
        'domain.to=[0.152,0.14,0.08]' 'fluid.water.to=[0.152,0.14,0.052]'
    ship all seed-003-blocks until=0.02
    ship all flood-one-cube spacing=0.05 until=0.01
    ship all flood-three-cubes spacing=0.05 until=0.01
    ship all flood-six-cubes spacing=0.05 until=0.01
    ship all dam-break-3d spacing=0.0555 until=0.1
    ship few beam-alone until=0.01
    ship all elastica until=0.6
    ship all soft-gate until=0.15
    ship all toth-dam-break spacing=5e-3 tol=1e-3 until=0.05
    ship few toth-pcisph spacing=5e-3 until=0.1
    ship few toth-fsi spacing=5e-3 until=0.16
    ship few toth-standard-sph spacing=5e-3 tol=1e-3 until=0.005
    ship all tank-sizes until=0.02
    ship few gate spacing=0.01 until=0.07
    ship all sloshing-tank spacing=0.02 until=0.3
    ship few mps-dam-break spacing=7.3e-3 until=0.1
    ship few wave-maker spacing=0.03 until=0.1
    ship all taylor-green until=0.2
    ship all poiseuille until=0.1125
    ship all couette until=0.1125
    ship few oscillating-drop until=0.1
    ship all elliptic-drop until=5e-4
    ship all rotating-square until=0.2
    ship all standing-wave spacing=0.05 until=0.2
    ship few driven-cavity spacing=0.04 until=0.03 'wall.lid.from=[-0.12,1]' \
        'wall.lid.to=[1.12,1.12]'
    ship all elastic-obstacle until=0.2
    ship all clustering spacing=4e-3 particle_mass=0.0176 tol=1e-3 until=0.01
    ship few toth-dam-break-literal
}

flat=tests/scenes/small-2d.scene
deep=tests/scenes/small-3d.scene
soft="beam.plate.E=1e5 beam.plate.theory=linear" # so that explicit methods come to the end, too
thick='effects.laminar-viscosity.mu=5 effects.laminar-viscosity.side=implicit'

# every METHOD: where it serves, and where it refuses to
every() {
    row all "$flat" "$1" $soft until=0.06
    row all "$flat" "$1" $soft $thick until=0.01
    row all data/scenes/elastica.scene "$1" until=0.02
    row all "$deep" "$1" until=0.05
    row all data/scenes/dam-break.scene "$1" spacing=0.01 until=0.1
}

method_rows() {
    for method in $("$program" list methods | awk '{ print $1 }'); do
        every "$method"
    done
    for method in leapfrog@0.25 euler-cfl@0.2 staggered@0.2 erk4@2e-5s leapfrog@2e-5s \
        euler-cfl@1e-5s cks43@4e-5s imex3@2e-4s mri@2e-4s; do
        every "$method"
    done
    row few "$flat" imex3 until=0.04
    row few "$flat" mri until=0.01
    row few tests/scenes/block-falls.scene mri-rigid body.block.softness=0.003 until=0.25
    row few "$flat" bdf until=0.01
    row few "$flat" imex3 $thick until=0.01
    row few "$flat" staggered@0.25 until=0.01
    row few "$flat" pcisph walls=own-density until=0.06
    row few "$deep" pcisph walls=own-density until=0.05
    row few "$deep" default
    row few "$deep" adams
    row few "$deep" leapfrog
    row few data/scenes/elastica.scene imex4 until=0.02
}

names() {
    "$program" list "$1" | awk '{ print $1 }'
}

# Each part of a list in a scene that is small.
part_rows() {
    for scene in "$flat" "$deep"; do
        for kernel in $(names kernels); do
            row all "$scene" default "kernel.type=$kernel" until=0.01
        done
        for eos in $(names eos); do row all "$scene" default "eos.type=$eos" until=0.03; done
        for walls in $(names walls | grep -v potential); do row all "$scene" default "walls=$walls" until=0.03; done
        row all "$scene" default walls=potential effects.contact-potential={} until=0.03
        for norm in max p8 wrms; do row all "$scene" default norm=$norm until=0.03; done
        for tol in 1e-1 1e-3; do row all "$scene" default tol=$tol until=0.03; done
        for effect in artificial-stress.strength=0.2 laminar-viscosity.mu=1 \
            stress-viscosity.mu=1 particle-shifting={} xsph={} shepard-filter.steps=10; do
            row all "$scene" default "effects.$effect" until=0.02
        done
        row few "$scene" default precision=single until=0.03
        row few "$scene" default walls=adami kernel.type=wendland-c4 until=0.01
        row few "$scene" default walls=contact kernel.type=wendland-c4 until=0.01
    done
    for key in walls=adami kernel.density=wendland-c4; do
        row all data/scenes/toth-standard-sph.scene default spacing=5e-3 $key until=5e-3
    done
    row few "$flat" dv walls=contact $soft until=0.03
    row few tests/scenes/floating-box.scene default until=0.2 body.it.angle=3.0
    row few tests/scenes/driven-flap.scene default until=0.1
    row few tests/scenes/clumps.scene default until=0.02
    row few data/scenes/gate.scene default walls=contact spacing=0.01 until=0.07
    row all data/scenes/gate.scene default eos.type=look-ahead spacing=0.01 until=0.15
    row all tests/scenes/lowered-box.scene default eos.type=look-ahead until=0.4
    row all tests/scenes/small-2d.scene default eos.type=look-ahead beam.plate.response=predicted until=0.03
    row all "$flat" default beam.plate.theory=elastica until=0.03
    row all "$flat" default beam.plate.theory=elastica beam.plate.E=1e5 until=0.08
    row all "$flat" default $soft until=0.08
}

# --- where this runs --------------------------------------------------------------------

has_flags() {
    for flag in "$@"; do
        grep -q -w -m 1 "$flag" /proc/cpuinfo 2>/dev/null || return 1
    done
}

lanes_here() {
    if has_flags avx512f avx512bw avx512cd avx512dq avx512vl; then echo 2 4 8
    elif has_flags avx2 fma; then echo 2 4
    else echo 2; fi
}

made_with() {
    libc=$(getconf GNU_LIBC_VERSION 2>/dev/null || echo 'unknown libc')
    has_flags fma && fma='with FMA' || fma='without FMA'
    echo "$libc, $(uname -m) $fma, $("$program" --version | grep SUNDIALS)"
}

# --- one run ----------------------------------------------------------------------------

# told DIRECTORY: columns of run.json
told() {
    awk -v names="dimension method steps rhs_explicit rhs_implicit rebuilds state_hash" '
        { at = index($0, "\": ") }
        at { key = substr($0, 1, at - 1); sub(/^ *"/, "", key); v = substr($0, at + 3)
             sub(/,$/, "", v); gsub(/^"|"$/, "", v); gsub(/\t/, " ", v); value[key] = v }
        END {
            n = split(names, name, " ")
            for (i = 1; i <= n; i++)
                printf "%s\t", (name[i] in value) ? value[name[i]] : "-"
            printf "%s\t", ENVIRON["tables"]
            print value["message"] == "" ? "-" : value["message"]
        }' "$1/run.json"
}

# one NUMBER LANES THREADS SCENE METHOD KEYS: its row goes to $out/rows/NUMBER
one() {
    number=$1 lanes=$2 threads=$3 scene=$4 method=$5 keys=$6
    to=$out/run.$number
    [ "$keys" = - ] && set -f -- || set -f -- $keys
    [ "$method" = default ] || set -- "$@" -m "$method"
    [ "$lanes" = "$widest" ] || { STIFFWATER_LANES=$lanes; export STIFFWATER_LANES; }
    "$program" run "$root/$scene" output.fields=100 "$@" -n "$threads" -q -o "$to" \
        >/dev/null 2>&1
    code=$?
    set +f
    unset STIFFWATER_LANES
    case $code in
        0) status='done' ;;
        1) status=failed ;;
        2) status=refused ;;
        *) status="exit $code" ;;
    esac
    if [ -f "$to/run.json" ]; then
        tables=$(find "$to" -name '*.csv' | sort | xargs grep -h '^[-0-9]' | cksum |
            cut -d ' ' -f 1)
        export tables
        rest=$(told "$to")
    else
        rest=$(printf -- '-\t-\t-\t-\t-\t-\t-\t-\t-')
    fi
    printf '%s\t%s\t%s\t%s\t%s\n' "$scene" "$method" "$keys" "$status" "$rest" \
        >"$out/rows/$number"
    rm -rf "$to"
}

# Takes runs that no other worker has taken.
worker() {
    while IFS=$tab read -r number lanes threads scene method keys; do
        mkdir "$out/taken/$number" 2>/dev/null || continue
        one "$number" "$lanes" "$threads" "$scene" "$method" "$keys" </dev/null
    done <"$out/jobs"
}

# --- comparing --------------------------------------------------------------------------

# differences NAME EXPECTED GOT: prints them; fails if there are any
differences() {
    awk -F '\t' -v what="$1" -v columns="$columns" '
        BEGIN { n = split(columns, name, "\t") }
        /^#/ || $1 == "scene" { next }
        { key = $1 "  " $2 "  " $3 }
        FILENAME == ARGV[1] { expected[key] = $0; next }
        !(key in expected) { printf "%s: %s: not in the table\n", what, key; bad = 1; next }
        $0 != expected[key] {
            bad = 1
            split(expected[key], e, "\t")
            for (i = 4; i <= n; i++)
                if ($i "" != e[i] "")
                    printf "%s: %s: %s: expected %s, got %s\n", what, key, name[i], e[i], $i
        }
        END { exit bad }' "$2" "$3"
}

# gone TABLE: rows of the table that are run no more
gone() {
    awk -F '\t' '/^#/ || $1 == "scene" { next }
        { key = $1 "  " $2 "  " $3 }
        FILENAME == ARGV[1] { run[key] = 1; next }
        !(key in run) { print "only in the table: " key; bad = 1 }
        END { exit bad }' "$2" "$1"
}

# --- options ----------------------------------------------------------------------------
mode=few
[ -z "${STIFFWATER_LONG-}" ] || mode=whole
program=${STIFFWATER-}
want_lanes='' threads='1 2' only='' jobs=2 anew='' even_so=''
here=$(cd "$(dirname "$0")" && pwd) || exit 99
table=$here/hashes.table
while [ $# -gt 0 ]; do
    case $1 in
        --few | --quick | --whole) mode=${1#--} ;;
        --lanes) want_lanes=$2; shift ;;
        --threads) threads=$2; shift ;;
        --only) only=$2; shift ;;
        --jobs) jobs=$2; shift ;;
        --table) table=$2; shift ;;
        --anew) anew=1; mode=whole ;;
        --even-so) even_so=1 ;;
        -*) sed -n '2,/^set/s/^#//p' "$0"; exit 99 ;;
        *) program=$1 ;;
    esac
    shift
done
[ -x "$program" ] || die "no program '$program': give one, or set STIFFWATER"
root=$(cd -P "$(dirname "$program")/data/.." 2>/dev/null && pwd) || root=$here/..
[ -f "$root/$flat" ] || die "no scenes in $root"
has=$(lanes_here)
widest=${has##* }
lanes=${want_lanes:-$has}
if [ "$mode" = quick ]; then lanes=${want_lanes:-$widest} threads=1; fi
for l in $lanes; do
    case " $has " in *" $l "*) ;; *) die "no $l lanes on this machine, only: $has" ;; esac
done

# together L T: whether rows are run on these lanes and threads
together()
{
    [ "$mode" != few ] || [ "$1" = "${lanes##* }" ] || [ "$2" = "${threads##* }" ]
}

# --- all of it --------------------------------------------------------------------------
out=$(mktemp -d) || exit 99
trap 'rm -rf "$out"' EXIT
trap 'exit 99' INT TERM HUP
mkdir "$out/rows" "$out/taken"
bad=0
{ shipped_rows; method_rows; part_rows; } | awk -F '\t' -v mode="$mode" -v only="$only" '
    (mode != "few" || $1 == "few") && (only == "" || index($0, only)) &&
    !seen[$2, $3, $4]++ { print $2 "\t" $3 "\t" $4 }' >"$out/list"
count=$(($(wc -l <"$out/list")))
[ "$count" -gt 0 ] || die 'no such rows'
for path in "$root"/data/scenes/*.scene; do
    shipped_rows | grep -q "/$(basename "$path")$tab" ||
        { echo "data/scenes/$(basename "$path") is not run here"; bad=1; }
done
for l in $lanes; do
    for t in $threads; do
        together "$l" "$t" || continue
        awk -v l="$l" -v t="$t" '{ printf "%s.%s.%06d\t%s\t%s\t%s\n", l, t, NR, l, t, $0 }' \
            "$out/list"
    done
done >"$out/jobs"
echo "hashes: $count rows, lanes $lanes (this machine has $has), threads $threads"
k=0
while [ $k -lt "$jobs" ]; do
    worker &
    k=$((k + 1))
done
wait

first=''
for l in $lanes; do
    for t in $threads; do
        together "$l" "$t" || continue
        find "$out/rows" -name "$l.$t.*" | sort | xargs cat >"$out/all.$l.$t"
        [ "$(($(wc -l <"$out/all.$l.$t")))" = "$count" ] ||
            die "$l lanes, $t threads: rows are missing"
        first=${first:-$out/all.$l.$t}
    done
done
with=$(made_with)
expected=$first
against='each other only'
if [ "$anew" ]; then
    against='each other'
elif [ ! -f "$table" ]; then
    echo "hashes: no table $table"
elif [ "$even_so" ] || [ "$(sed -n '2s/^# made with //p' "$table")" = "$with" ]; then
    expected=$table
    against='the table'
else
    echo "hashes: the table was $(sed -n '2s/^# //p' "$table"); here is $with"
fi
for l in $lanes; do
    for t in $threads; do
        together "$l" "$t" || continue
        differences "lanes $l, threads $t" "$expected" "$out/all.$l.$t" || bad=1
    done
done
[ "$expected" != "$table" ] || [ "$mode" = few ] || [ "$only" ] || gone "$table" "$first" || bad=1
if [ "$anew" ] && [ $bad = 0 ]; then
    { echo "# what short runs end with; tests/hashes.sh compares, and tells of the columns"
      echo "# made with $with"
      echo "$columns"
      cat "$first"; } >"$table.new" && mv "$table.new" "$table"
    echo "hashes: wrote $table"
fi
echo "hashes: compared with $against: $([ $bad = 0 ] && echo 'all the same' || echo 'DIFFERENCES')"
exit $bad
