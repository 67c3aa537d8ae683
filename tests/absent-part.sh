#!/bin/sh
# absent-part.sh -- adding a part to a table changes neither the state size nor the
# instructions of one right-hand side of a scene that does not name it (counted, not timed).
#
# tests/physics/absent has the table of effects as it is, absent-more one effect more.  Both
# count their own instructions with all lanes that there are; valgrind, which knows no eight
# lanes, counts those with two and four once more, in a larger scene.
# Run by `make check`; skipped (77) without valgrind, when the first count is right.
build=${top_builddir:-.}
export OMP_NUM_THREADS=1

as_is=$("$build/tests/physics/absent" steps) && more=$("$build/tests/physics/absent-more" steps) ||
    { echo 'absent-part: the programs do not run'; exit 99; }
echo "absent-part: $as_is"
echo "absent-part: $more"
case $as_is in
-1*) echo 'absent-part: no process may be traced here: not counted with all lanes' ;;
*', as is, '*) # to the instruction
    [ "$as_is" = "$(echo "$more" | sed 's/, more, /, as is, /')" ] ||
        { echo 'absent-part: one effect more in the table is not free'; exit 1; } ;;
*) exit 99 ;;
esac
command -v valgrind >/dev/null ||
    { echo 'absent-part: skipped, there is no valgrind (apt-get install valgrind)'; exit 77; }
directory=$(mktemp -d) || exit 99
trap 'rm -rf "$directory"' EXIT

# instructions PROGRAM N: of N right-hand sides, but for those by which libgomp and malloc keep
# their house, and copies of memory: a team of threads is taken from the heap for every loop,
# which costs by how the heap happens to lie, and copies cost by where they do.  Nor does it
# count how the process starts and ends: libraries such as UCX, which SUNDIALS may bring along,
# calibrate clocks there, never twice alike.
instructions()
{
    valgrind --tool=callgrind --callgrind-out-file="$directory/count" \
        --toggle-collect=tank_rates "$build/tests/physics/$1" "$2" >"$directory/$1.$2" 2>"$directory/said" ||
        { cat "$directory/said" >&2; return 1; }
    awk '
        # names stand where an id is met first: ob=(3) /lib/libgomp.so.1
        function named(kind) {
            id = $1
            sub(/^[a-z]*=/, "", id)
            if (NF > 1)
                name[kind, id] = $2
            return name[kind, id]
        }
        /^cob=/ { named("ob"); next }
        /^cfn=/ { named("fn"); next }
        /^ob=/ { gomp = named("ob") ~ /libgomp/; next }
        /^fn=/ {
            heap = named("fn") ~ /alloc|free|memalign|unlink_chunk|systrim|mem(set|cpy|move)/
            next
        }
        /^calls=/ { callee = 1; next }
        /^[0-9+*-]/ {
            if (!callee && !gomp && !heap)
                sum += $2
            callee = 0
        }
        END { printf "%.0f\n", sum }' "$directory/count"
}

# What is left takes a few instructions more or less by where memory happens to lie, so the
# less of two runs counts.
keep_least()
{
    [ -f "$2" ] && [ "$(cat "$2")" -le "$1" ] || echo "$1" >"$2"
}

status=0
for lanes in 2 4; do
    export STIFFWATER_LANES=$lanes
    rm -f "$directory/absent" "$directory/absent-more"
    for program in absent absent-more absent absent-more; do
        few=$(instructions $program 10) && many=$(instructions $program 40) ||
            { echo 'absent-part: skipped, valgrind does not run these programs'; exit 77; }
        [ -n "$few" ] && [ -n "$many" ] || { echo 'absent-part: nothing is counted'; exit 99; }
        keep_least $((many - few)) "$directory/$program"
    done
    as_is=$(cat "$directory/absent")
    more=$(cat "$directory/absent-more")
    echo "absent-part: up to $lanes lanes: 30 right-hand sides take $as_is instructions;" \
        "with one effect more in the table $more"
    # less than two instructions a right-hand side, which the smallest question costs
    awk -v a="$as_is" -v b="$more" \
        'BEGIN { d = b - a; exit !(a > 1e6 && d < 60 && d > -60) }' || status=1
done
grep -q 'as is' "$directory/absent.40" && grep -q 'more' "$directory/absent-more.40" ||
    { echo 'absent-part: both programs have the same table'; exit 99; }
[ "$(cut -d, -f2 "$directory/absent.40")" = "$(cut -d, -f2 "$directory/absent-more.40")" ] ||
    { echo 'absent-part: the state sizes differ'; status=1; }
exit $status
