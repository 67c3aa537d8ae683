#!/bin/sh
# checkpoint.sh -- what resume refuses, and what it does not mind: damaged checkpoints, signals,
# full disks, another scene, version or layout; and runs that would overwrite one that can go on.
. "${top_srcdir:-.}/tests/lib.sh"
scenes=$top_srcdir/tests/scenes
ask=
asking
scene=$scenes/small-2d.scene

# run DIRECTORY KEY=VALUE...: of 20 ms, with checkpoints at 0, 8, 16 and 20 ms
run() {
    dir=$1
    shift
    "$STIFFWATER" run "$scene" -q output.checkpoint=0.008 -o "$dir" "$@" || wrong "$dir does not run"
}

# ends DIRECTORY: where `whole' ended
ends() {
    if [ "$(hash "$1")" = "$(hash whole)" ] && cmp -s "$1/book.csv" whole/book.csv &&
        cmp -s "$1/steps.csv" whole/steps.csv; then good "$1 ends as a run that was left alone"
    else wrong "$1 ends elsewhere"; fi
}

# like NAME: a copy of the whole run
like() {
    rm -rf "$1"
    cp -r whole "$1"
}

run whole
claim 'four checkpoints' "$(number whole checkpoints) == 4 && $(number whole checkpoints_by_clock) == 0"
[ "$(tail -n 4 whole/checkpoints.csv | tr '\n' ' ')" = '0,time 0.008,time 0.016,time 0.02,time ' ] ||
    wrong "checkpoints.csv: $(cat whole/checkpoints.csv)"

echo 'a file of the user' >image # HDF5 looks for one of this name

# --- what is damaged ------------------------------------------------------------------------
like cut
head -c 3000 whole/checkpoint.h5 >cut/checkpoint.h5
expect 0 resume cut -q
says 'cut/checkpoint.h5 is damaged' 'going on from cut/checkpoint-before.h5'
ends cut
like flipped
printf 'x' | dd of=flipped/checkpoint.h5 bs=1 seek=20000 conv=notrunc 2>dd
expect 0 resume flipped -q
says 'damaged' 'going on from'
ends flipped
like both
: >both/checkpoint.h5
echo no checkpoint >both/checkpoint-before.h5
cp -r both both-before
expect 4 resume both -q
says 'both/checkpoint.h5 is damaged' 'the checkpoint before it is damaged, too'
diff -r both both-before >differ || wrong "a refused resume changes files: $(cat differ)"
like none
rm none/checkpoint*.h5
expect 4 resume none -q
says 'no checkpoint to go on from' output.checkpoint
expect 2 resume nowhere -q
says 'nowhere: no run in there'
like short
head -n 8 whole/steps.csv >short/steps.csv
cp -r short short-before
expect 4 resume short -q
says 'short/steps.csv' 'had' 'at the checkpoint'
diff -r short short-before >differ || wrong "a refused resume changes files: $(cat differ)"
like gone
rm gone/forces.csv
expect 4 resume gone -q
says 'gone/forces.csv'

# --- what is another run's ------------------------------------------------------------------
like other
sed -i 's/^tol = .*/tol = 0.1;/' other/scene.used
expect 4 resume other -q
says "scene.used was changed"
run small spacing=0.01
like swapped
cp small/checkpoint.h5 swapped/checkpoint.h5
expect 4 resume swapped -q
says "checkpoint's scene"
cp small/scene.used swapped/scene.used
expect 4 resume swapped -q
says 'swapped/' 'at the checkpoint'
# change DIRECTORY OLD NEW: these letters, as many, in its checkpoints, whose hashes are made anew
change() {
    rm -rf "$1-before"
    for file in "$1/checkpoint.h5" "$1/checkpoint-before.h5"; do
        python3 - "$file" "$2" "$3" <<'END' || wrong "$file cannot be changed"
import sys
path, old, new = sys.argv[1], sys.argv[2].encode(), sys.argv[3].encode()
whole = open(path, "rb").read()
rest = whole[512:].replace(old, new)
assert len(old) == len(new) and rest != whole[512:]
hash = 0xcbf29ce484222325
for byte in rest:
    hash = (hash ^ byte) * 0x100000001b3 % 2**64
head = b"stiffwater checkpoint 1\nbytes %d\nhash %016x\n" % (len(rest), hash)
open(path, "wb").write(head.ljust(512, b"\0") + rest)
END
    done
    cp -r "$1" "$1-before"
}

# refuses DIRECTORY: resume, which changes no file
refuses() {
    expect 4 resume "$1" -q
    diff -r "$1" "$1-before" >differ || wrong "a refused resume changes files: $(cat differ)"
}

if command -v python3 >/dev/null; then
    version=$(value whole version)
    like older
    change older "$version" "$(echo "$version" | tr 0-9 1-90)"
    refuses older
    says "older: version $(echo "$version" | tr 0-9 1-90) wrote the checkpoint, this is $version"
    like blocks
    change blocks ': 240 of ' ': 241 of '
    refuses blocks
    says "blocks: the checkpoint's layout" 'y has other blocks'
    like method
    change method "$(value whole method)" "$(value whole method | tr a-y b-z)"
    refuses method
    says "method: the checkpoint's method" 'another build of this version'
    like paceless # as builds wrote them before a checkpoint told the pace of its run
    change paceless pace pacf
    refuses paceless
    says 'the checkpoint has no pace' 'another build of this version' 'go on with that one'
fi
expect 2 resume whole -q tol=0.1
says tol=0.1 'only until=T'
expect 2 resume whole -q until=0.01
says 'has come to t = 0.02 s already'
expect 2 run "$scene" -q output.checkpoint=1e-9 -o many
says 'output.checkpoint = 1e-09 s' 'more than 100000'
[ ! -e many ] || wrong "a refused run leaves files"

# --- a run over one that can go on ----------------------------------------------------------
like again
sed -i 's/"status": "done"/"status": "running"/' again/run.json
cp -r again again-before
expect 4 run "$scene" -q -o again
says 'a run was interrupted there' '`stiffwater resume again`' '-o'
diff -r again again-before >differ || wrong "a refused run changes files: $(cat differ)"
rm again/run.json
expect 4 run "$scene" -q -o again
says 'interrupted'
expect 0 resume again -q
ends again
expect 0 run "$scene" -q until=0.001 -o again
[ ! -e again/checkpoint.h5 ] || wrong "a checkpoint of an earlier run stays"

# --- signals --------------------------------------------------------------------------------
"$STIFFWATER" run "$scene" -q output.checkpoint=0.004 until=0.4 -o quiet
"$STIFFWATER" run "$scene" -q output.checkpoint=0.004 until=0.4 -o signal >said 2>&1 &
pid=$!
waited=0
until [ "$(cat signal/checkpoints.csv 2>/dev/null | wc -l)" -gt 6 ] || [ $waited = 100 ]; do
    sleep 0.05
    waited=$((waited + 1))
done
grep -q '"status": "running"' signal/run.json || wrong "a run that goes on has no run.json"
[ -s signal/figures/constants.gp ] || wrong "a run that goes on has no constants for figures"
expect 4 resume signal -q
says 'another run is writing there'
kill $pid
wait $pid
[ $? = 3 ] || wrong "SIGTERM does not stop the run"
grep -q 'stiffwater resume' said || wrong "a stopped run does not say how to go on: $(cat said)"
expect 4 run "$scene" -q -o signal
says interrupted
expect 0 resume signal -q -n 1
[ "$(hash signal)" = "$(hash quiet)" ] && cmp -s signal/book.csv quiet/book.csv ||
    wrong "a run that was stopped and goes on ends elsewhere"
if command -v gnuplot >/dev/null; then
    sed -i 's/"status": "done"/"status": "running"/' signal/run.json
    expect 0 plot signal
    says energies.png
fi

# --- where no checkpoint can be written -------------------------------------------------------
mkdir -p full/checkpoint.h5.part
expect 0 run "$scene" -q output.checkpoint=0.008 -o full --force
says 'no checkpoint at t = 0.016 s' 'the run goes on'
ends full

# --- a disk that is full while one is written -----------------------------------------------------
# until 0.008 s there is room; then a checkpoint is the only file for which there is none
run quiet output.fields=100 output.snapshots=0
run half output.fields=100 output.snapshots=0 until=0.008
cp half/checkpoint.h5 kept
blocks=$(($(wc -c <kept) / 1024)) # of 512 bytes: half of it can be written
(ulimit -f $blocks; "$STIFFWATER" resume half -q until=0.02) >said 2>&1 || wrong "resume: $(cat said)"
says 'no checkpoint at t = 0.016 s' 'no checkpoint at t = 0.02 s' 'the checkpoint before stays'
cmp -s half/checkpoint.h5 kept || wrong "a checkpoint that cannot be written loses the one before"
[ -z "$(ls half | grep part)" ] || wrong "a checkpoint that cannot be written leaves its parts: $(ls half)"
expect 0 resume half -q until=0.02
[ "$(hash half)" = "$(hash quiet)" ] && cmp -s half/book.csv quiet/book.csv ||
    wrong "a run whose disk was full ends elsewhere"
[ -z "$(ls half/snapshots)" ] || wrong "a run that is resumed to a later end writes a snapshot"
# and a disk on which nothing else can be written, too, where one may be mounted
if unshare -rm sh -c 'mkdir -p disk && mount -t tmpfs -o size=1m none disk' 2>said; then
    run part output.fields=100 output.snapshots=0 until=0.008
    unshare -rm sh -c 'mount -t tmpfs -o size=1m none disk && cp -r part disk/run && cd disk || exit 99
        head -c $(($(stat -f -c "%a * %S" .) - 30000)) /dev/zero >ballast
        "$0" resume run -q until=0.02
        echo $? >../code
        cp run/checkpoint.h5 ../left
        rm ballast
        "$0" resume run -q until=0.02
        cp -r run ../filled' "$STIFFWATER" >said 2>&1
    says 'No space left on device'
    ! grep -q damaged said || wrong "a full disk damages a checkpoint: $(cat said)"
    cmp -s left part/checkpoint.h5 || wrong "a full disk loses a checkpoint"
    claim 'a full disk is told' "$(cat code) == 4 || $(cat code) == 0"
    [ "$(hash filled)" = "$(hash quiet)" ] && cmp -s filled/book.csv quiet/book.csv ||
        wrong "a run on a disk that was full ends elsewhere: $(cat said)"
fi

# --- what a checkpoint counts is on the disk before it -------------------------------------------
if strace -V >said 2>&1 && strace true 2>said; then
    # leaks cannot be looked for in a program that is watched
    ASAN_OPTIONS=detect_leaks=0 strace -f -y -e trace=fsync -o calls "$STIFFWATER" run "$scene" -q until=0.002 \
        output.checkpoint=0.002 -o synced || wrong "a run that is watched"
    for file in fields/000000.vtkhdf snapshots/0000.csv book.csv; do
        if sed '/checkpoint\.h5/q' calls | grep -q "synced/$file"; then good "$file is on the disk"
        else wrong "$file is on the disk before the checkpoint: $(cat calls)"; fi
    done
fi

# --- what one costs ---------------------------------------------------------------------------
# A segment goes on at the pace of the one before: 508 and 480 right-hand sides, and 773 where each
# began with a short step.
for every in 0 0.03; do
    "$STIFFWATER" run "$top_srcdir/data/scenes/dam-break.scene" -q spacing=0.025 until=0.3 \
        output.fields=1 output.snapshots=0 output.checkpoint=$every -o paced-$every
done
claim 'ten checkpoints cost less than a twentieth of the right-hand sides' \
    "$(number paced-0.03 rhs_explicit) < 1.05 * $(number paced-0 rhs_explicit)"

# --- by the clock -----------------------------------------------------------------------------
run clock output.checkpoint=0 output.checkpoint_minutes=1e-5
claim 'the clock asks for checkpoints' "$(number clock checkpoints_by_clock) > 2 &&
    $(number clock checkpoints) == $(number clock checkpoints_by_clock) + $(grep -c ,time clock/checkpoints.csv)"
claim 'they are told' "$(grep -c ,clock clock/checkpoints.csv) == $(number clock checkpoints_by_clock)"
rm clock/checkpoint.h5
expect 0 resume clock -q

finish
