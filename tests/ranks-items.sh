#!/bin/sh
# ranks-items.sh -- what `check` tells of the memory of ranks, item by item, is within 10 % of what a run has.
#
# Each array of a run is found by tests/ranks/items.c, some hundred right-hand sides after the start, and put
# to an item by the file of the program that has asked for it.  Items below 1 MB are not judged: pages of 4 kB
# are a part of them.
. "${top_srcdir:-.}/tests/lib.sh"
. "$top_srcdir/tests/mpi.sh"
need_ranks
if grep -q __asan_init "$top_builddir/stiffwater-2d"; then skip "memory is not what it is under a sanitizer"; fi
command -v addr2line >/dev/null || skip "there is no addr2line"
mpicc -O1 -shared -fPIC -o "$out/items.so" "$top_srcdir/tests/ranks/items.c" -ldl 2>"$out/said" ||
    skip "there is no mpicc to build tests/ranks/items.c with"
scenes=$top_srcdir/data/scenes

patience=300

# of FILE PROGRAM: "ITEM MB" of each item of a rank
of() {
    cut -d' ' -f3- "$1" | tr ' ' '\n' | sort -u | sed '/^$/d; s/^/0x/' >"$out/offsets"
    addr2line -f -e "$2" <"$out/offsets" | paste - - >"$out/lines"
    paste "$out/offsets" "$out/lines" | awk -v sizes="$1" '
        { at = $3; sub(/:.*/, "", at); sub(/.*\/src\//, "", at)
          file[substr($1, 3)] = at; name[substr($1, 3)] = $2 }
        function item(n,  i, first, all) {
            all = " "; first = ""
            for (i = 3; i <= n; i++) {
                if (file[$i] == "base/status.c" || name[$i] == "workspace_lines") continue
                if (first == "") { first = file[$i]; by = name[$i] }
                all = all file[$i] " "
            }
            if ($2 ~ /^(libmpi|libopen|mca_|libpmix|libhdf5)/ || first == "" || first == "eval/moment.c") return "rest"
            if (all ~ / solved\//) return "sums"
            if (first ~ /^(algebra\/vector|time\/)/ || first ~ /^run\/(prepare|begin)\.c/ ||
                first == "eval/workspace.c" && by == "take_memory") return "state"
            if (first ~ /^eval\/(share|own|rearrange)/ || first ~ /^ranks\// || all ~ / eval\/own\.c /) return "shared"
            if (first ~ /^state\/particles/) return "particles"
            if (first ~ /^(output|measure)\// || first ~ /^run\/(tables|frames|outputs)/) return "outputs"
            if (first ~ /^space\//) return "list"
            if (first ~ /^(eval|walls|implicit|plan\/solve|effects)/) return "sums"
            return "rest"
        }
        END { while ((getline <sizes) > 0) mb[item(NF)] += $1 / 1e6
              for (i in mb) print i, mb[i] }'
}

# told: "ITEM FIRST OTHERS" of what a check has said [MB]
told() {
    sed -n 's/^  state and vectors like it/state/p; s/^  pair list/list/p; s/^  sums over pairs/sums/p
            s/^  particles/particles/p; s/^  what ranks share, and with whom/shared/p
            s/^  outputs/outputs/p' "$out/told" | sed 's/ MB//g'
}

# items N D UNTIL SCENE KEY=VALUE...: on N ranks, in D directions
items() {
    n=$1
    program=$top_builddir/stiffwater-$2d-mpi
    until=$3
    shift 3
    what="$n ranks: $(basename "$1" .scene)"
    ranks "$n" "$program" check "$@"
    cp "$out/said" "$out/told"
    rm -f "$out"/held.*
    ITEMS=$out/held ITEMS_AT=150
    export ITEMS ITEMS_AT
    ranks "$n" -x LD_PRELOAD="$out/items.so" -x ITEMS -x ITEMS_AT "$program" run "$@" until="$until" \
        output.interval="$(awk -v t="$until" 'BEGIN { print t / 10 }')" \
        output.fields="$(awk -v t="$until" 'BEGIN { print t / 10 }')" output.snapshots=0 -q -f -o "$out/run"
    claim "$what: a run has asked so often" "$code == 0 && $(ls "$out"/held.* 2>/dev/null | wc -l) == $n"
    for rank in "$out"/held.*; do
        of "$rank" "$program" | sed "s/^/${rank##*.} /"
    done >"$out/had"
    told | while read -r item first others; do
        awk -v item="$item" -v first="$first" -v others="$others" '
            $2 == item && $1 == 0 { one = $3 }
            $2 == item && $1 > 0 && $3 > most { most = $3 }
            function good(told, had) { return had < 1 || told > 0.9 * had && told < 1.1 * had }
            END { printf "%s %s: told %.2f and %.2f MB, had %.2f and %.2f\n", good(first, one) && good(others, most) ? "ok" : "no",
                      item, first, others, one, most }' "$out/had"
    done >"$out/judged"
    claim "$what: six items are told, beside the program" "$(wc -l <"$out/judged") == 6"
    while read -r verdict words; do
        if [ "$verdict" = ok ]; then good "$what, $words"; else wrong "$what, $words"; fi
    done <"$out/judged"
}

rest="fluid.back.initial=rest fluid.front.initial=rest"
for n in 2 4 8; do
    items $n 2 3e-3 "$scenes/dam-break.scene" spacing=6.25e-4
    # shellcheck disable=SC2086 # two words
    items $n 3 4e-2 "$scenes/dam-break-3d.scene" spacing=0.0222 $rest
done
items 4 2 3e-3 "$scenes/toth-beam.scene" spacing=8.333333333333333e-4
# shellcheck disable=SC2086
items 4 3 2e-2 "$scenes/dam-break-3d.scene" spacing=0.0222 $rest walls=adami

# pressures that are solved for, whose matrix is told with the sums; vectors of which a method has all rows
items 2 3 0.05 "$top_srcdir/tests/scenes/still-cube.scene" spacing=0.005
items 4 2 0.05 "$scenes/mps-dam-break.scene" spacing=1.825e-3
items 2 2 3e-3 "$scenes/dam-break.scene" spacing=1.25e-3 method=pcisph walls=own-density
for method in leapfrog ab3 gsl-rkf45 dv bdf; do
    items 2 2 3e-3 "$scenes/dam-break.scene" spacing=8.333333333333333e-4 method=$method
done
items 2 2 1e-3 "$scenes/toth-beam.scene" spacing=8.333333333333333e-4 method=mri
finish
