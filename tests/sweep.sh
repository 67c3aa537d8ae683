#!/bin/sh
# sweep.sh -- `stiffwater sweep' keeps its word: a row for each combination of values, numbers that
# are those of the runs' files, effects and objects that are taken away, mistakes found before
# anything runs, nothing run twice.  Run by `make check'.
scenes=${top_srcdir:-.}/data/scenes
ask=sweep
. "${top_srcdir:-.}/tests/lib.sh"
asking

# field DIR COLUMN WORDS: of the row that begins with these words
field()
{
    awk -F, -v wanted="$2" -v begin="$3," '
        /^#/ { next }
        !column { for (i = 1; i <= NF; i++) if ($i == wanted) column = i; next }
        index($0, begin) == 1 { print $column }' "$1/sweep.csv"
}

# holds CONDITION NUMBER...: awk's condition of a, b, c
holds()
{
    tried=$((tried + 1))
    awk -v a="$2" -v b="$3" -v c="$4" "BEGIN { exit !(a != \"\" && a == a + 0 && ($1)) }" ||
        complain "$what: $1 does not hold for a = $2, b = $3, c = $4"
}

dam="$scenes/dam-break.scene spacing=0.0125 --until 0.3"

# --- mistakes -------------------------------------------------------------------------------
# shellcheck disable=SC2086 # scene and keys are words
{
expect 2 $dam -o wrong
says "over what?" "eos.c0=20,40"
expect 2 $dam eos.c0=20,,40 -o wrong
says "empty word"
[ ! -e wrong ] || complain "a mistake leaves a directory"
expect 2 $dam eos.c0=20,-40 -o refused
says "eos.c0=-40" "eos.c0"
expect 2 $dam effects.density-difusion=on,off -o refused
says density-difusion density-diffusion
expect 2 $dam effects.density-difusion=off,on -o refused
says density-difusion density-diffusion
[ -z "$(find refused -name run.json)" ] || complain "a scene is run before all are checked"

# --- numbers, and an effect ---------------------------------------------------------------------
expect 0 $dam eos.c0=20,30 effects.density-diffusion=on,off probe.low.at=[0.2,0.02] -j 2 -o dam
}
says "| eos.c0 [m/s] | effects.density-diffusion | CPU s | pair passes | energy defect [J/m] | front.x.end [m] |" \
    "| 30 | off |" tank.force.peak
head -n 1 dam/sweep.csv | grep -q '^# units: m/s,,,s,,,,,,J/m,s,m,' || complain "units of sweep.csv: $(head -n 1 dam/sweep.csv)"
[ "$(wc -l <dam/sweep.csv)" = 6 ] || complain "sweep.csv has not a row for each run"
for c0 in 20 30; do
    for effect in on off; do
        run=dam/runs/$(field dam run "$c0,$effect")
        [ -d "$run" ] || complain "the column run names no directory"
        grep -q 'density-diffusion' "$run/scene.used" && used=on || used=off
        [ $used = $effect ] || complain "density diffusion is $used and should be $effect"
        what="$c0 $effect"
        holds "(a - b) ^ 2 < 1e-14" "$(field dam front.x.end "$c0,$effect")" \
            "$(tail -n 1 "$run/front.csv" | cut -d, -f2)"
        holds "a == b" "$(field dam pair_passes "$c0,$effect")" \
            "$(sed -n 's/^ *"pair_passes": \([0-9]*\),*$/\1/p' "$run/run.json")"
        # The mean force over a fiftieth of the time, from the impulse, by awk.
        force=$(awk -F, '/^[#t]/ { next } { n++; t[n] = $1; x[n] = $4; y[n] = $5 }
            END { w = (t[n] - t[1]) / 50
                for (i = 2; i <= n; i++) {
                    k = i - 1
                    while (k > 1 && t[i] - t[k] < w * (1 - 1e-9)) k--
                    f = sqrt((x[i] - x[k]) ^ 2 + (y[i] - y[k]) ^ 2) / (t[i] - t[k])
                    if (f > most) most = f
                }
                printf "%.9g", most }' "$run/forces.csv")
        holds "(a / b - 1) ^ 2 < 1e-10" "$(field dam tank.force.peak "$c0,$effect")" "$force"
    done
done
holds "a != b" "$(field dam front.x.end 20,on)" "$(field dam front.x.end 20,off)"
head -n 1 dam/sweep.csv | awk -F, -v n="$(sed -n 2p dam/sweep.csv | awk -F, '{ print NF }')" \
    '{ exit NF != n }' || complain "not a unit for each column"
if command -v gnuplot >/dev/null; then
    for name in eos.c0 effects.density-diffusion; do
        [ -s "dam/figures/sweep-$name.png" ] || complain "sweep-$name.png is not drawn"
    done
    rm -f dam/figures/*.png
    "$STIFFWATER" plot dam >said 2>&1 || complain "the figures cannot be drawn again"
    says dam/figures/sweep-eos.c0.png
fi
find dam/runs -name run.json -exec ls --full-time {} + | sort >before
# shellcheck disable=SC2086
expect 0 $dam eos.c0=20,30 effects.density-diffusion=on,off probe.low.at=[0.2,0.02] -o dam
find dam/runs -name run.json -exec ls --full-time {} + | sort | cmp -s before - ||
    complain "what is there is run again"

# --- an effect that the scene does not name, an object ---------------------------------------------
# shellcheck disable=SC2086
expect 0 $dam effects.particle-shifting=off,on -q -o added
holds "a != b" "$(field added front.x.end off)" "$(field added front.x.end on)"
# shellcheck disable=SC2086
expect 0 $dam fluid.right=off -u 0.01 eos.c0=20,30 -q -o less
grep -q 'right' less/runs/eos.c0=20/scene.used && complain "an object that is off is there"

finish
