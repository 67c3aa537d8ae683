#!/bin/sh
# fuzz.sh -- libFuzzer (clang) on what reads the files of others: scenes, KEY=VALUE, checkpoints,
# tables.  In a build tree of its own, below the one it is called in.
#
#     make fuzz                            20,000 inputs each, some minutes; the first time it builds
#     RUNS=1000000 TARGETS=scene make fuzz
#
# An input that crashes, hangs for 120 s or takes 4 GB is kept as fuzz/crash-... and the like:
# `fuzz/scene-fuzz fuzz/crash-...` does it again.
set -eu
sources=$(cd "${top_srcdir:-.}" && pwd)
RUNS=${RUNS:-20000}
flags='-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined'
TARGETS=${TARGETS:-scene setting checkpoint table}
command -v clang >/dev/null || { echo "fuzz: skipped, there is no clang"; exit 77; }
mkdir -p fuzz
cd fuzz
[ -e Makefile ] || "$sources/configure" CC=clang CFLAGS="-O1 -g $flags" >configured 2>&1 ||
    { cat configured; exit 99; }
make -j2 fuzz-targets >made 2>&1 || { tail -n 20 made; exit 99; }

bad=0
for target in $TARGETS; do
    mkdir -p "found/$target"
    if ASAN_OPTIONS=allocator_may_return_null=1 OMP_NUM_THREADS=1 "./$target-fuzz" -runs="$RUNS" \
        -timeout=120 -rss_limit_mb=4096 -max_len=4096 -close_fd_mask=3 -print_final_stats=1 \
        "found/$target" "$sources/tests/fuzz/corpus/$target" >"$target.said" 2>&1; then
        echo "fuzz: $target: $(sed -n 's/^stat::number_of_executed_units: *//p' "$target.said") inputs, no complaint"
    else
        bad=1
        echo "fuzz: $target: $(grep -m 1 'ERROR\|runtime error' "$target.said")"
        grep 'Test unit written' "$target.said" || :
    fi
done
exit $bad
