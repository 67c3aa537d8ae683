#!/bin/sh
# side-by-side.sh -- CPU of two commands, run at the same time on one core.
#
#     bench/side-by-side.sh TURNS 'COMMAND A' 'COMMAND B'
#
#     bench/side-by-side.sh 3 "old/stiffwater-3d run my.scene -q -f -o a" \
#         "new/stiffwater-3d run my.scene -q -f -o b"
#
# Each turn prints CPU seconds of both, those of their children too, and B over A.  Whatever slows the core
# slows both alike, so that on a machine that others use a ratio of runs of 20 s scatters by half a per cent,
# of one second by 2, where runs in turn scatter by a third.  Two runs of one program tell how much it is
# on yours.  Both want the same amount of work: the longer one runs its last part alone.
set -eu

[ $# = 3 ] || {
    sed -n '2,/^set/s/^# \{0,1\}//p' "$0" >&2
    exit 2
}
core=${CORE-0} scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# cpu NAME COMMAND: CPU seconds to $scratch/NAME
cpu() {
    (
        taskset -c "$core" sh -c "$2" >"$scratch/$1.said" 2>&1 || {
            echo "command $1 failed:" >&2
            tail -n 5 "$scratch/$1.said" >&2
            exit 1
        }
        times >"$scratch/$1.times" # a pipe would have children of its own
        awk 'NR == 2 { for (i = 1; i <= 2; i++) { split($i, t, "[ms]"); sum += 60 * t[1] + t[2] } print sum }' \
            "$scratch/$1.times" >"$scratch/$1"
    )
}

turn=0
while [ $turn -lt "$1" ]; do
    cpu a "$2" &
    first=$!
    cpu b "$3" &
    second=$!
    wait $first && wait $second || exit 1
    awk -v a="$(cat "$scratch/a")" -v b="$(cat "$scratch/b")" \
        'BEGIN { printf "A %.2f s, B %.2f s, B over A %.3f\n", a, b, b / a }'
    turn=$((turn + 1))
done
