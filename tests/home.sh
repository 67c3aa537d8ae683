#!/bin/sh
# home.sh -- a run's directory: what of others is in it stays, links are not followed, and files of
# an earlier run go before the next one writes.
. "${top_srcdir:-.}/tests/lib.sh"
scenes=$top_srcdir/tests/scenes
ask=
asking
scene=$scenes/small-2d.scene

# run DIRECTORY KEY=VALUE...: 2 ms of it
run() {
    dir=$1
    shift
    "$STIFFWATER" run "$scene" -q until=0.002 -o "$dir" "$@" || wrong "$dir does not run"
}

# same WORDS DIRECTORY: nothing in it differs from DIRECTORY-before
same() {
    if diff -r --no-dereference "$2" "$2-before" >differ 2>&1; then good "$1"
    else wrong "$1: $(cat differ)"; fi
}

# --- the mark ---------------------------------------------------------------------------------
run plain
grep -q '^scene small-2d.scene$' plain/.stiffwater && grep -q '^version ' plain/.stiffwater ||
    wrong "the mark does not say whose: $(cat plain/.stiffwater)"

# --- directories of others ----------------------------------------------------------------------
mkdir theirs
echo mine >theirs/book.csv
echo mine >theirs/notes
cp -r theirs theirs-before
expect 4 run "$scene" -q until=0.002 -o theirs
says 'theirs: there are files' 'book.csv' '-o' '--force'
same 'a refused run changes nothing' theirs
expect 0 run "$scene" -q until=0.002 -o theirs --force
[ "$(cat theirs/notes)" = mine ] || wrong "--force loses a file"
cmp -s theirs/book.csv plain/book.csv || wrong "--force writes another book.csv"
expect 0 run "$scene" -q until=0.002 -o theirs
[ "$(cat theirs/notes)" = mine ] || wrong "a second run loses a file"
mkdir hollow
expect 0 run "$scene" -q until=0.002 -o hollow

# --- files of an earlier run ----------------------------------------------------------------------
run again until=0.004 output.fields=1e-4 output.snapshots=9 output.checkpoint=0.001
mkdir again/fields/mine again/mine
echo mine >again/mine/book.csv
echo mine >again/fields/notes
echo mine >again/snapshots/mine.csv
: >again/fields/000099.vtkhdf.part
run again output.snapshots=2 "beam.plate.length=0.05"
[ "$(ls again/fields | tr '\n' ' ')" = "$(ls plain/fields | tr '\n' ' ')mine notes " ] ||
    wrong "fields of two runs: $(ls again/fields)"
[ "$(ls again/snapshots | tr '\n' ' ')" = '0000.csv 0001.csv mine.csv ' ] ||
    wrong "snapshots of two runs: $(ls again/snapshots)"
[ "$(cat again/mine/book.csv again/fields/notes again/snapshots/mine.csv | grep -c mine)" = 3 ] ||
    wrong "a run loses files of others"
for file in again/checkpoint.h5 again/checkpoint-before.h5 again/checkpoints.csv; do
    [ ! -e $file ] || wrong "$file of an earlier run stays"
done
rm -r again/mine again/fields/mine again/fields/notes again/snapshots/mine.csv
diff -r -x run.json plain again >differ || wrong "a second run is not as a first one: $(cat differ)"
sed '/^beam/,/^};/d; s/method = .*//' "$scene" >no-beam.scene
"$STIFFWATER" run no-beam.scene -q until=0.002 -o again || wrong "a run without its beam"
[ ! -e again/beam.csv ] || wrong "beam.csv of an earlier run stays"

# --- figures --------------------------------------------------------------------------------------
if command -v gnuplot >/dev/null; then
    run drawn
    expect 0 plot drawn
    [ -s drawn/figures/deflection.png ] || wrong "no figure of a beam: $(ls drawn/figures)"
    echo mine >drawn/figures/steps.png
    echo '# mine' >>drawn/figures/front.gp
    "$STIFFWATER" run no-beam.scene -q until=0.002 -o drawn
    [ ! -e drawn/figures/deflection.png ] || wrong "a figure of an earlier run stays"
    [ "$(cat drawn/figures/steps.png)" = mine ] || wrong "a run removes a figure that was changed"
    expect 0 plot drawn
    [ "$(cat drawn/figures/steps.png.mine)" = mine ] || wrong "plot loses a figure that was changed"
    tail -n 1 drawn/figures/front.gp.mine | grep -q mine || wrong "plot loses a script that was changed"
fi

# --- links ------------------------------------------------------------------------------------------
echo theirs >victim
mkdir elsewhere
run linked output.checkpoint=0.001
sed -i 's/"status": "done"/"status": "failed"/' linked/run.json
for name in $(cd linked && ls) checkpoint.h5.part figures/constants.gp; do
    rm -rf linked-before
    mv linked/$name kept 2>moved || :
    case $name in
    fields | snapshots | figures) ln -s "$PWD/elsewhere" linked/$name ;;
    *) ln -s "$PWD/victim" linked/$name ;;
    esac
    cp -r linked linked-before
    case $name in
    *.part | figures/*) expect 0 run "$scene" -q until=0.002 output.checkpoint=0.001 -o linked ;;
    *)
        expect 4 run "$scene" -q until=0.002 -o linked
        [ $name = run.json ] || says "linked/$name is a symbolic link"
        expect 4 run "$scene" -q until=0.002 -o linked --force
        same "a link in place of $name" linked
        [ $name = scene.used ] || expect 4 resume linked -q ;; # which is read, and no scene
    esac
    [ "$(cat victim)" = theirs ] || wrong "a run writes through linked/$name"
    [ -z "$(ls elsewhere)" ] || wrong "a run writes through linked/$name"
    rm -f linked/$name
    [ ! -e kept ] || mv kept linked/$name
done

# --- where nothing can be written -----------------------------------------------------------------
if [ "$(id -u)" != 0 ]; then
    run sealed
    chmod a-w sealed
    cp -r sealed sealed-before
    expect 4 run "$scene" -q until=0.002 -o sealed
    says 'sealed/.stiffwater.part: cannot be opened for writing: Permission denied'
    chmod u+w sealed sealed-before
    same 'a directory that cannot be written' sealed
fi
code=0
mkdir disk
unshare -rm sh -c 'mount -t tmpfs -o size=4m none disk || exit 77
    "$1" run "$2" -q until=0.002 -o disk/run || exit 77
    mount -o remount,ro disk || exit 77
    "$1" run "$2" -q until=0.002 -o disk/run' sh "$STIFFWATER" "$scene" >said 2>&1 || code=$?
what='a file system that is read only'
if [ $code = 77 ]; then echo "skip    $what: no mounts here"
else
    claim "$what" "$code == 4"
    says 'disk/run/.stiffwater.part' 'Read-only file system'
fi
finish
