#!/bin/sh
# threads.sh -- no thread reads what another writes: runs on four threads, watched by
# clang's ThreadSanitizer.
#
# Needs a build tree with CC=clang --enable-sanitizer=thread; skipped in others.  gcc will
# not do: its OpenMP library hides from the sanitizer and looks like races.  clang's tells
# what it does through libarcher.so, which lies beside it.
. "$top_srcdir/tests/lib.sh"
program=$top_builddir/stiffwater-2d

nm "$program" | grep -q __tsan_init || {
    echo 'this build tree has no ThreadSanitizer: see CONTRIBUTING.md'
    exit 77
}
library=$(ldd "$program" | awk '/libomp/ { print $3 }')
[ -n "$library" ] || { echo 'not built with clang and its OpenMP (Debian: libomp-dev)'; exit 77; }
OMP_TOOL_LIBRARIES=$(dirname "$(readlink -f "$library")")/libarcher.so
[ -f "$OMP_TOOL_LIBRARIES" ] || { echo "$OMP_TOOL_LIBRARIES is missing"; exit 77; }
TSAN_OPTIONS='ignore_noninstrumented_modules=1 exitcode=66'
OMP_WAIT_POLICY=passive
GOMP_SPINCOUNT=1 # short loops have threads, too: base/waiting.h
export OMP_TOOL_LIBRARIES TSAN_OPTIONS OMP_WAIT_POLICY GOMP_SPINCOUNT

scenes=$top_srcdir/data/scenes
sed 's/artificial-viscosity = .*/laminar-viscosity = { mu = 500.0; side = "implicit"; };/' \
    "$scenes/dam-break.scene" >"$out/thick.scene"

# runs SCENE METHOD KEY=VALUE...: fine enough that each loop uses its threads, which 4,096 particles and
# vectors of 20,000 numbers do.
runs()
{
    scene=$1 method=$2
    shift 2
    "$STIFFWATER" run "$scene" -m "$method" -n 4 -q -o "$out/run" output.fields=100 \
        output.snapshots=0 "$@" >"$out/said" 2>&1 || {
        echo "$scene with $method: exit status $?"
        head -n 60 "$out/said"
        exit 1
    }
    echo "$(basename "$scene") with $method: no race"
}

runs "$scenes/dam-break.scene" cks43 until=0.01
runs "$scenes/dam-break.scene" bs54 until=0.005
runs "$scenes/dam-break.scene" dv until=0.01
runs "$out/thick.scene" imex3 until=0.003
runs "$scenes/toth-beam.scene" imex3 spacing=2e-3 until=0.01
runs "$scenes/toth-beam.scene" dv spacing=2e-3 until=0.002
runs "$scenes/dam-break-3d.scene" cks43 spacing=0.037 until=4e-3
runs "$scenes/dam-break-3d.scene" dv spacing=0.037 until=4e-3
