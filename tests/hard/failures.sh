#!/bin/sh
# failures.sh -- runs that cannot go on end as failed within a bounded number of steps, with
# every family of methods: the message names time, particle, place, part and what to try,
# and what was written is whole.
. "$top_srcdir/tests/lib.sh"
tank=$top_srcdir/tests/hard/tank.scene

# fails NAME STEPS KEY=VALUE...: before it has taken so many steps, and leaves whole files
fails() {
    name=$1
    steps=$2
    shift 2
    go "$name" "$tank" output.fields=0.02 output.snapshots=5 "$@"
    claim "$name fails within $steps steps" \
        "$code == 1 && $(number "$name" steps) + $(number "$name" rejected) <= $steps"
    grep -q '"status": "failed"' "$out/$name/run.json" || wrong "$name: status"
    claim 'its last row is where it ended' "$(number "$name" t_end) == 0 || \
        sqrt(($(last "$name" book t) / $(number "$name" t_end) - 1) ^ 2) < 1e-9"
    whole "$name"
}

# tells NAME WORDS: which particle, where, when, which part did most to it (WORDS), what to try
tells() {
    prints "$1" 't = ' ' s' 'particle' ' at (' 'Cause: at t = ' 'the last accepted state, for ' \
        "$2"
    grep -q -E 'Things to try|[Tt]ry |take a higher eos.c0' "$out/$1.said" ||
        { wrong "$1 says what to try"; cat "$out/$1.said"; }
}

# place NAME: where the particle is that its first sentence names
place() {
    sed -n 's/.*Cause: .* particle \([0-9]* ([a-z]*) at ([^)]*)\) m: .*/\1/p' "$out/$1.said"
}

adaptive='cks43 imex3 ark436 erk2 bs54 erk6 ab3 dv adams bdf gsl-rkf45 gsl-rk8pd gsl-msadams'
ruled='leapfrog euler-cfl staggered'

# Sound far too slow for the fall: the column is pressed into the floor.
for method in $adaptive $ruled; do
    fails "soft-$method" 3000 method="$method" eos.c0=0.5
    tells "soft-$method" ' pushes it most, by '
    prints "soft-$method" 'the fluid has run away' 'eos.c0' "at t = $(number "soft-$method" t_end | head -c 6)" \
        "particle $(place "soft-$method") m moves at"
done

# Densities that may vary by 1 %, where the impact asks for 6 %: no step is short enough.
# A wall's density is the first to leave, with some methods in the accepted state itself.
for method in $adaptive $ruled; do
    fails "narrow-$method" 5000 method="$method" eos.lowest=0.99 eos.highest=1.01
    prints "narrow-$method" 'density' 'lies outside 990 to 1010' "particle $(place "narrow-$method") m"
    tells "narrow-$method" 'm: effects.continuity (density that evolves with the flow) changes its density most'
done

# A summed density has no rate: the part that gives it.
sed 's/continuity/summation/; /density-diff/d' "$tank" >"$out/summed.scene"
tank=$out/summed.scene
fails summed 3000 walls=adami eos.tension=false eos.lowest=0.5 eos.highest=1.01
tells summed 'effects.summation (density as a sum over neighbours'
tank=$top_srcdir/tests/hard/tank.scene

# Faster than five times sound at the start.
for method in cks43 adams leapfrog; do
    fails "fast-$method" 10 method="$method" 'fluid.column.velocity=[1000,0]'
    tells "fast-$method" ' pushes it most, by '
done

# Steps longer than any bound of stability.
for method in leapfrog@4 cks43@1e-2s erk4@1e-2s imex3@1e-2s ab3@1e-2s \
    dv@1e-2s gsl-rkf45@1e-2s leapfrog@1e-2s; do
    fails "long-$method" 3000 method="$method"
    tells "long-$method" ' most, by '
done

# No answer at the start: nothing is written.
code=0
"$STIFFWATER" run "$tank" -q until=0.01 eos.c0=1e-3 -o "$out/tight" >"$out/tight.said" 2>&1 || code=$?
claim 'tight: refused' "$code == 1"
prints tight 'the start has no right-hand side' 'particle 0 (column)' 'nothing was written'
[ ! -e "$out/tight" ] || wrong 'tight: something was written'
finish
