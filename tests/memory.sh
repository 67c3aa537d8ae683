#!/bin/sh
# memory.sh -- a run takes the memory that `check` foretells, within 10 %.
#
# Short runs do: a run has taken all by the second file of fields.  What a run asks for is
# measured: left to itself, glibc keeps freed arrays of some megabytes or gives them back, by
# the order in which they happen to come and go (34.0 or 37.7 MB of the same run on Debian 13).
. "$top_srcdir/tests/lib.sh"
scenes=$top_srcdir/data/scenes
export MALLOC_MMAP_THRESHOLD_=131072
if grep -q __asan_init "$top_builddir/stiffwater-2d"; then
    skip "memory is not what it is under a sanitizer"
fi

# holds UNTIL SCENE KEY=VALUE...
holds() {
    until=$1
    shift
    set -- "$@" until="$until" output.interval="$until" output.snapshots=0 \
        output.fields="$(awk -v t="$until" 'BEGIN { print t / 2 }')"
    "$STIFFWATER" check "$@" >"$out/said"
    "$STIFFWATER" run "$@" -q -o "$out/run"
    if words=$(awk -v what="$*" '
        /^memory: about / { told = $3 }
        /"peak_rss_kb":/ { gsub(",", ""); took = 1024e-6 * $2 }
        END {
            good = told > 0.9 * took && told < 1.1 * took
            printf "%.1f MB told, %.1f MB taken (%+.1f %%): %s\n", told, took, 100 * (told / took - 1), what
            exit !good
        }' "$out/said" "$out/run/run.json"); then good "$words"; else wrong "$words"; fi
}

holds 4e-4 "$scenes/dam-break.scene"
holds 1e-4 "$scenes/dam-break.scene" spacing=1.25e-3
holds 1e-4 "$scenes/dam-break.scene" spacing=1.25e-3 method=euler-cfl
holds 4e-4 "$scenes/toth-beam.scene" spacing=1.6666666666666667e-3
sed 's/continuity = { };/summation = { };/; /density-diffusion/d; /density-healing/d; s/^until/walls = "ghost"; until/' \
    "$scenes/dam-break.scene" >"$out/summed.scene"
holds 1e-4 "$out/summed.scene" spacing=1e-3 eos.tension=false
sed 's/^until/walls = "own-density"; until/; /density-healing/d; s/^eos.*/eos = { type = "look-ahead"; };/' \
    "$scenes/dam-break.scene" >"$out/ahead.scene"
holds 1e-4 "$out/ahead.scene" spacing=1e-3
holds 1e-4 "$out/ahead.scene" spacing=1e-3 walls=contact
holds 4e-3 "$scenes/dam-break-3d.scene" spacing=0.037
holds 1e-4 "$scenes/beam-alone.scene"
holds 4e-4 "$scenes/mps-dam-break.scene" spacing=1.825e-3
holds 1e-3 "$scenes/toth-pcisph.scene" spacing=1.25e-3
[ -z "${STIFFWATER_LONG-}" ] || holds 4e-3 "$scenes/dam-break-3d.scene"
[ -z "${STIFFWATER_LONG-}" ] || for fine in 6.25e-4 3.125e-4; do
    holds 1e-4 "$scenes/dam-break.scene" spacing=$fine
done
finish
