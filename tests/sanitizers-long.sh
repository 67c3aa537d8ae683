#!/bin/sh
# sanitizers-long.sh -- what a sanitizer sees of our code: addresses and undefined behaviour in all that
# `make check-code' runs, in 2D and 3D, and, where there is clang with its OpenMP, races of threads.
#
# Each has a build tree of its own, so that this takes some half an hour; `make check-long' runs it.
# The changes of a day meet the first in 2D, and in 3D what scripts run (.ci/run).
. "$top_srcdir/tests/lib.sh"

# What this is part of must not reach the make of another tree.
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES STIFFWATER STIFFWATER_LONG STIFFWATER_TARBALL
jobs=$(getconf _NPROCESSORS_ONLN)

# tree NAME OPTION...: builds and enters it
tree() {
    mkdir "$out/$1"
    cd "$out/$1"
    shift
    if "$top_srcdir/configure" --disable-dependency-tracking --without-mpi "$@" >said 2>&1 &&
        make -j "$jobs" >>said 2>&1; then
        good "a build with $*"
    else
        wrong "a build with $*"
        tail -n 30 said
        finish
    fi
}

tree addresses --enable-sanitizer CFLAGS='-g1 -O1'
if make -k -j "$jobs" check-code >said 2>&1; then
    good 'addresses and undefined behaviour in check-code'
else
    wrong 'addresses and undefined behaviour in check-code'
    grep -E '^(FAIL|ERROR|XPASS): ' said
fi
claim 'tests that ran there' "$(find tests -name '*.trs' | wc -l) > 100"

if command -v clang >/dev/null && [ -n "$(find /usr/lib/llvm-* -name libarcher.so 2>/dev/null)" ]; then
    tree threads CC=clang --enable-sanitizer=thread CFLAGS='-g1 -O2' sw_cv_v3=no sw_cv_v4=no
    if make check-threads >said 2>&1; then
        good 'no races of threads'
    else
        wrong 'no races of threads'
        tail -n 60 said
    fi
else
    echo 'no clang with its OpenMP here: races of threads are not looked for'
fi
cd "$out"
finish
