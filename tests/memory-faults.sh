#!/bin/sh
# memory-faults.sh -- a run that gets no memory ends with exit status 1 or 4 and a sentence that
# says so: never by a signal, never with advice about tol or eos.c0.
#
#     CASES=1000 sh tests/memory-faults.sh    so many of each kind (default: 6)
#
# Kinds: one request of malloc() is refused, or all from one on (tests/failing-malloc.c); once
# with those of HDF5 left alone, once with them.  And limits of ulimit -v, in steps.  HDF5 1.10
# crashes over requests that are refused after it was asked whether there is room: such signals
# are counted, and only they.
. "$top_srcdir/tests/lib.sh"
CASES=${CASES:-6}
export OMP_NUM_THREADS=1
if grep -q __asan_init "$top_builddir/stiffwater-2d"; then
    skip "memory is not what it is under a sanitizer"
fi
${CC:-cc} -O1 -shared -fPIC -o "$out/refuse.so" "$top_srcdir/tests/failing-malloc.c" \
    2>"$out/said" || skip "no library that refuses memory: $(cat "$out/said")"

# hurt DIMENSION NAME=VALUE...: a run of the small scene in this environment
hurt() {
    rm -rf "$out/dir"
    small=$1
    code=0
    shift
    timeout 300 env "$@" "$top_builddir/stiffwater-${small}d" run \
        "$top_srcdir/tests/scenes/small-${small}d.scene" -q until=0.002 output.checkpoint=0.002 \
        -o "$out/dir" >"$out/said" 2>&1 || code=$?
}

# judge WORDS: what became of it; adds to the counts
judge() {
    signals=$((signals + (code > 128)))
    case $code in
    0) untouched=$((untouched + 1)); return ;;
    1 | 4) grep -q -i 'memory\|cannot be created\|creation failed\|cannot map\|cannot create' "$out/said" || wrong "$1: no word of memory: $(cat "$out/said")"
        ! grep -q 'smaller tol\|eos\.c0\|Cause: ' "$out/said" ||
            wrong "$1: false advice: $(cat "$out/said")"
        told=$((told + 1)) ;;
    *) [ $code -gt 128 ] && [ "${2-}" = counted ] || wrong "$1: exit status $code: $(cat "$out/said")" ;;
    esac
    [ ! -e "$out/dir" ] || torn=$(torn "$out/dir")
    [ -z "${torn-}" ] || wrong "$1: torn: $torn"
}

# refuse DIMENSION [counted]: CASES refusals of one request, CASES of all from one on; counted:
# those of libraries, too
refuse() {
    for kind in ONCE FROM; do
        signals=0 told=0 untouched=0 i=0
        faults="LD_PRELOAD=$out/refuse.so"
        [ $# = 2 ] || faults="$faults FAIL_BUT=1"
        hurt "$1" $faults FAIL_COUNT=1
        all=$(sed -n 's/^requests: //p' "$out/said")
        while [ $i -lt "$CASES" ]; do
            n=$(awk "BEGIN { print 1 + int(($i + 0.5) * $all / $CASES) }")
            hurt "$1" $faults "FAIL_$kind=$n"
            judge "${1}D, $kind=$n, ${2:-our own}" "${2-}"
            i=$((i + 1))
        done
        claim "${1}D, $kind, $all requests${2:+ with those of libraries}: $CASES refusals" \
            "$told + $untouched + $signals == $CASES && ($signals == 0 || \"${2-}\" == \"counted\")"
        echo "        $told told, $untouched came to their end, $signals signals"
    done
}

# limits DIMENSION: of memory, from what is enough to load the program to what is enough to run it
limits() {
    signals=0 told=0 untouched=0 i=0
    least=20000
    until (ulimit -v $least; "$top_builddir/stiffwater-$1d" --version >/dev/null 2>&1); do
        least=$((least + 2000)) # the loader finds room for libraries
    done
    enough=$least
    until (ulimit -v $enough; hurt "$1" LIMIT=$enough; [ $code = 0 ]); do
        enough=$((enough + 2000))
    done
    while [ $i -lt "$CASES" ]; do
        kb=$(awk "BEGIN { print int($least + ($i + 0.5) * ($enough + 2000 - $least) / $CASES) }")
        (ulimit -v "$kb"; hurt "$1" LIMIT=$kb; echo $code >"$out/code")
        code=$(cat "$out/code")
        judge "${1}D, ulimit -v $kb"
        i=$((i + 1))
    done
    claim "${1}D, $CASES limits of memory up to $enough kB" "$told + $untouched == $CASES"
    echo "        $told told, $untouched came to their end, $signals signals"
}

for dimension in 2 3; do
    refuse $dimension
    refuse $dimension counted
    limits $dimension
done
finish
