#!/bin/sh
# periodic-flows.sh -- flows that repeat: vortices, and water between plates of which none or
# one moves, against their exact solutions.
#
# Marks: plates, 20 spacings apart, to 2 % (none moves) and 1 % (one moves) of the largest
# speed; the vortices' viscous work until 0.05 s within 3 % (it is 2.4 % low), momentum to
# rounding, the same bits on 1, 2 and 4 threads, no particle lost, particles written where the domain is.
. "$top_srcdir/tests/lib.sh"
scenes=$top_srcdir/data/scenes

# run NAME KEY=VALUE...: a scene into $out/NAME
run() {
    name=$1
    shift
    "$STIFFWATER" run "$scenes/$name.scene" -q -o "$out/$name" "$@"
}

# profile RUN EXACT MARK: largest error of u over the largest speed in every snapshot after the
# start, EXACT awk for u
profile() {
    for file in "$out/$1"/snapshots/*.csv; do
        awk -F, -v name="$1" -v mark="$3" -v L=1e-3 -v nu=1e-6 '
            /^# t/ { split($0, word, " "); t = word[4] }
            !/^[-0-9]/ || $8 != 0 || !t { next }
            { pi = 3.14159265358979; y = $2; u = 0; '"$2"'
              e = ($3 - u) / 1.25e-5; if (e * e > worst * worst) worst = e
              rows++ }
            END { if (!t) exit 0
                  printf "%s at %g s: off by %.2f %%\n", name, t, 100 * worst
                  exit !(rows > 100 && worst * worst < mark ^ 2) }' "$file"
    done
}

run poiseuille
# shellcheck disable=SC2016 # awk, not the shell
profile poiseuille 'u = 1e-4 * y * (L - y) / 2 / nu
    for (n = 1; n < 60; n += 2)
        u -= 4e-4 * L * L / nu / (pi * n) ^ 3 * sin(pi * y * n / L) * exp(-(n * pi / L) ^ 2 * nu * t)' 0.02
run couette
# shellcheck disable=SC2016
profile couette 'u = 1.25e-5 * y / L
    for (n = 1; n < 200; n++)
        u += 2.5e-5 / (n * pi) * (n % 2 ? -1 : 1) * sin(n * pi * y / L) * exp(-(n * pi / L) ^ 2 * nu * t)' 0.01

first=
for threads in 1 2 4; do
    run taylor-green until=0.05 --threads $threads
    now=$(hash taylor-green)
    [ "${first:=$now}" = "$now" ] || { echo "$threads threads: $now, not $first"; exit 1; }
done
awk -F, -v p="$(number taylor-green momentum_defect)" -v lost="$(number taylor-green escaped)" '
    $1 == "t" { for (k = 1; k <= NF; k++) if ($k == "laminar-viscosity") work = k }
    /^[0-9]/ { t = $1; w = $work }
    END { share = -w / (0.25 * (1 - exp(-1.5791367 * t)))
          printf "vortices: viscous work %.4f of the exact, momentum %.2g N s\n", share, p
          exit !(share > 0.97 && share < 1 && p < 1e-13 && lost == 0) }' "$out/taylor-green/book.csv"
awk -F, '/^[-0-9]/ { off += $1 < 0 || $1 > 1 || $2 < 0 || $2 > 1; n++ }
    FNR == 1 { file++ }
    END { print off + 0, "of", n, "stand outside of the domain"; exit off || n != 2500 * file }' \
    "$out"/taylor-green/snapshots/*.csv
