#!/bin/sh
# load.sh -- a run under load: more threads than cores, a disk that fills up, a directory
# that cannot be written, a signal at any moment.  What was written before is whole.
. "$top_srcdir/tests/lib.sh"
tank=$top_srcdir/tests/hard/tank.scene

# --- threads -----------------------------------------------------------------------------
# The flagship coarsely, so that beams and tables of all kinds take part.
beam="$top_srcdir/data/scenes/toth-beam.scene"
until=0.15
brief && until=0.03
for threads in 1 2 4 7; do
    code=0
    "$STIFFWATER" run "$beam" spacing=0.01 until=$until -q -n $threads -o "$out/threads$threads" ||
        code=$?
    claim "$threads threads: the same bits" \
        "$code == 0 && \"$(hash threads$threads)\" == \"$(hash threads1)\""
    whole "threads$threads"
done

# --- a disk that fills up ------------------------------------------------------------------
# A file may have so many blocks (of 512 bytes, or 1024): first the particle fields meet
# the limit, then, without them, a table.
full() {
    code=0
    (ulimit -f "$2" && shift 2 && exec "$STIFFWATER" run "$tank" -q "$@") \
        >"$out/$1.said" 2>&1 || code=$?
    claim "$1: status 4" "$code == 4"
    prints "$1" 'cannot be written: File too large'
    whole "$1"
    grep -q '"status": "failed"' "$out/$1/run.json" || wrong "$1: run.json"
}
full fields 60 until=10 -o "$out/fields"
full table 100 until=10 output.fields=100 output.snapshots=0 output.interval=1e-4 -o "$out/table"

# A small disk in a name space of its own, where the system lets us; what it held is copied
# out of it.
code=0
mkdir "$out/disk"
unshare -rm sh -c 'mount -t tmpfs -o size=300k none "$1/disk" || exit 77
    code=0
    "$STIFFWATER" run "$2" -q -o "$1/disk/run" output.fields=0.02 || code=$?
    cp -r "$1/disk/run" "$1/small"
    exit $code' sh "$out" "$tank" >"$out/small.said" 2>&1 || code=$?
if [ -d "$out/small" ]; then
    claim 'a full disk: status 4' "$code == 4"
    prints small 'cannot be written: No space left on device'
    whole small
else
    echo 'skip    a full disk: no mounts here'
fi
if [ -w /dev/full ]; then
    for command in "check $tank" 'list effects' 'explain scene'; do
        code=0
        # shellcheck disable=SC2086 # words
        "$STIFFWATER" $command >/dev/full 2>"$out/print.said" || code=$?
        claim "$command, nowhere to print" "$code == 4"
        prints print 'standard output cannot be written'
    done
fi

# --- a directory that cannot be written ------------------------------------------------------
: >"$out/file"
mkdir "$out/sealed"
for where in "$out/file/below" /proc/results "$out/sealed/below"; do
    if [ "$where" = "$out/sealed/below" ]; then
        chmod a-w "$out/sealed"
        [ ! -w "$out/sealed" ] || continue # root may write anywhere
    fi
    code=0
    "$STIFFWATER" run "$tank" -q until=0.01 -o "$where" >"$out/sealed.said" 2>&1 || code=$?
    claim "$where: status 4" "$code == 4"
    prints sealed "$where"
done

# --- signals ---------------------------------------------------------------------------------
# wait_for FILE: until it is there, 20 s at most
wait_for() {
    waited=0
    until [ -e "$1" ] || [ $waited = 1000 ]; do
        sleep 0.02
        waited=$((waited + 1))
    done
}

# kill_at NAME SIGNAL SECONDS: a run that is signalled; its exit status goes to $code
kill_at() {
    code=0
    # sh starts background jobs with SIGINT ignored
    env --default-signal=INT "$STIFFWATER" run "$tank" -q until=1e3 output.interval=1e-3 \
        output.fields=0.01 output.snapshots=1000 -o "$out/$1" >"$out/$1.said" 2>&1 &
    pid=$!
    wait_for "$out/$1/book.csv"
    sleep "$3"
    kill -s "$2" $pid
    wait $pid || code=$?
}

# Under nohup SIGHUP is ignored from the start, here too: bit 0 of what is.
hup=HUP
case $(sed -n 's/^SigIgn:[[:space:]]*//p' /proc/self/status 2>/dev/null) in
*[13579bdf]) hup= && echo 'load: SIGHUP is ignored here, and not tried' ;;
esac
for signal in INT TERM $hup; do
    kill_at $signal $signal 0.4
    claim "SIG$signal: status 3" "$code == 3"
    grep -q '"status": "stopped"' "$out/$signal/run.json" || wrong "$signal: run.json"
    whole $signal
done
for pause in 0 0.03 0.05 0.08 0.13 0.21 0.34 0.55; do
    kill_at "KILL$pause" KILL $pause
    claim "SIGKILL after $pause s: gone" "$code == 137"
    whole "KILL$pause"
    [ ! -e "$out/KILL$pause/run.json" ] || grep -q '"status": "running"' "$out/KILL$pause/run.json" ||
        wrong "KILL$pause: run.json speaks of its end"
done
# The directory can be used again at once.
cp -r "$out/KILL0.55" "$out/again"
go again "$tank" until=0.02
claim 'a run where another was killed' "$code == 0"
whole again

# Under nohup a run outlives its terminal.
code=0
nohup "$STIFFWATER" run "$tank" -q until=5 -o "$out/nohup" >"$out/nohup.said" 2>&1 &
pid=$!
wait_for "$out/nohup/book.csv"
sleep 0.1
kill -s HUP $pid
wait $pid || code=$?
claim 'nohup: to its end' "$code == 0"
finish
