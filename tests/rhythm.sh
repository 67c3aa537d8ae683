#!/bin/sh
# rhythm.sh -- outputs do not change a run: with rows, fields, snapshots and probes or without,
# every method takes the same steps and ends in the same bits, with water alone, with a beam
# that water hits, and in three dimensions; there with a method of each library and of each kind of
# step, with STIFFWATER_LONG with all, and longer.
#
# tests/physics/bits.c has the same for the right-hand side, tests/shipped-scenes.sh for the
# default methods of the shipped scenes.
. "$top_srcdir/tests/lib.sh"
scenes=$top_srcdir/data/scenes

# run NAME SCENE KEY=VALUE...; false when the method cannot serve the scene
run() {
    name=$1
    scene=$2
    shift 2
    rm -rf "${out:?}/$name"
    "$STIFFWATER" run "$scenes/$scene.scene" -q -o "$out/$name" "$@" 2>"$out/said" && return 0
    if grep -q 'cannot serve this scene' "$out/said"; then return 1; fi
    wrong "$name runs"
    cat "$out/said"
    return 1
}

# refused: whether $method may refuse $scene: beams without a bound of stability, or none at all
refused() {
    case "$method $scene" in
    'adams toth-beam' | gsl-*' toth-beam' | 'mri dam-break'*)
        echo "        $method: not $scene" ;;
    *) wrong "$method serves $scene"; cat "$out/said" ;;
    esac
}

# same SCENE UNTIL KEY=VALUE...: quiet and talkative runs of $method
same() {
    scene=$1
    until=$2
    shift 2
    run quiet "$scene" "until=$until" "$@" "method=$method" "output.interval=$until" \
        "output.fields=$until" output.snapshots=0 || { refused; return 0; }
    run talkative "$scene" "until=$until" "$@" "method=$method" \
        "output.interval=$(awk "BEGIN { print $until / 83.7 }")" \
        "output.fields=$(awk "BEGIN { print $until / 11.3 }")" output.snapshots=8 \
        ${near:+"probe.one={at=[$near];}" "probe.two={at=[$near];what=\"height\";}"}
    served=$((served + 1))
    for key in state_hash steps rejected rebuilds; do
        words="$method, $scene: $key is $(value quiet $key) and, with more outputs, $(value talkative $key)"
        if [ "$(value quiet $key)" ] && [ "$(value quiet $key)" = "$(value talkative $key)" ]; then
            good "$words"
        else wrong "$words"; fi
    done
    # The dense output of the last step may want the rates at its end.
    asked=$(($(value talkative rhs_explicit) - $(value quiet rhs_explicit)))
    [ $asked = 0 ] || [ $asked = 1 ] ||
        wrong "$method, $scene: outputs ask $asked right-hand sides"
}

# Each family of methods; what the program does not list is left out.
methods='cks43 erk5 imex3 imex5 dv leapfrog euler-cfl staggered adams bdf gsl-rkf45 gsl-rk8pd
    gsl-msadams ab3 mri'
if [ -n "${STIFFWATER_LONG-}" ]; then deep=$methods fall=0.03
else deep='cks43 imex3 dv leapfrog adams gsl-rkf45 ab3' fall=0.02; fi
"$STIFFWATER" list methods >"$out/listed"
count=0
served=0
for method in $methods; do
    grep -q "^$method " "$out/listed" || continue
    count=$((count + 1))
    near=0.05,0.02
    same dam-break 0.3 spacing=0.025
    same toth-beam 0.16 spacing=0.01 beam.E=5e6 beam.elements=3 beam.theory=linear
    near=0.5,0.5,0.1
    case " $(echo $deep) " in *" $method "*) same dam-break-3d $fall spacing=0.0555 ;; esac
done

# Methods for beams alone, and the solve of a viscosity that is taken implicitly.
for method in imex3 dirk4; do
    grep -q "^$method " "$out/listed" || continue
    near= # no water to measure
    same beam-alone 0.02
done
method=imex3
near=0.05,0.02
same dam-break 0.1 spacing=0.025 'effects.laminar-viscosity={mu=500;side="implicit";}'

echo "rhythm: $count methods, $served pairs of runs"
claim "methods and pairs are many" "$count >= 13 && $served > 2 * $count"
finish
