# marin.sh -- what E01 and E01fine judge of a run of marin.scene; read with `.` behind lib.sh
grep -v '^[#t]' "$reference/E01_kleefsman_spheric2.csv" | tr , ' ' >seen
side=0.064883 # of the face [m^2]

# over20 COLUMN: of the experiment, mean over 20 ms that end there; its rows are 5 ms apart
over20() {
    awk -v c="$1" '{ x[NR] = $c } NR > 4 { print $1, (x[NR] + x[NR - 4]) / 8 + (x[NR - 1] + x[NR - 2] + x[NR - 3]) / 4 }' seen
}
# load RUN: force on the front half of the box along x, mean over 20 ms that end there
load() {
    column "$1/panels" front.ix | awk '{ t[NR] = $1; x[NR] = $2; while (t[NR] - t[k + 1] > 0.02 + 1e-9) k++
        if (k) print t[NR], (x[NR] - x[k]) / (t[NR] - t[k]) } BEGIN { k = 0 }'
}
# four FILE-OF-FIVE-COLUMNS: t, mean of P1 to P4 times the face
four() { awk -v a=$side '{ print $1, ($2 + $3 + $4 + $5) / 4 * a }' "$@"; }
# rms RUN PROBE COLUMN UNTIL: distance of a level from the experiment: rms, largest
rms() {
    column "$1/probes" "$2" >level
    awk -v c="$3" -v to="$4" 'NR == FNR { t[n] = $1; x[n++] = $2; next } $1 > to { next }
        { while (i < n - 2 && t[i + 1] < $1) i++; d = x[i] + ($1 - t[i]) / (t[i + 1] - t[i]) * (x[i + 1] - x[i]) - $c
          s += d * d; k++; if (d < 0) d = -d; if (d > m) m = d }
        BEGIN { n = i = 0 } END { printf "%.3f %.3f", sqrt(s / k), m }' level seen
}
# within WHAT EXPERIMENT GOT UNIT PERCENT COST [WHY]
within() {
    row "$1" "$2 $4" "$(calc "$3") $4" "$5 %" "sqrt(($3 / $2 - 1) ^ 2) < $5 / 100" "$6" "${7-}"
}
# impact RUN NAME WHY-LOAD WHY-PEAK WHY-PROBE WHY-FOUR WHY-SOLIDS: to 0.75 s
impact() {
    t=$(column "$1/probes" H2 | awk '$2 > 0.02 { print $1; exit }')
    row "wave at H2 (20 mm), $2" '0.370 s' "$t s" '0.36 s +- 0.03 s' "sqrt(($t - 0.36) ^ 2) < 0.03" "$(cost "$1")"
    f=$(load "$1" | mean 0.47 0.7)
    within "load on the face, 0.45 to 0.70 s, $2" "$(awk '{ print $1, $2, $3, $4, $5 }' seen | four | mean 0.45 0.7 |
        awk '{ printf "%.0f", $1 }')" "$f" N 25 '' "$3"
    q=$(column "$1/probes" P1 P2 P3 P4 | four | mean 0.45 0.7)
    within "the same by P1 to P4 times the face, as the experiment has it, $2" 317 "$q" N 25 '' "$6"
    p=$(column "$1/probes" face | awk -v a=$side '{ print $1, a * $2 }' | mean 0.45 0.7)
    row "load by a probe over the face, $2" "on its particles $(calc "$f") N" "$(calc "$p") N" '15 %' \
        "sqrt(($p / $f - 1) ^ 2) < 0.15" '' "$5"
    m=$(column "$1/probes" P1.mean | most | cut -d' ' -f1)
    row "P1, largest over 20 ms, $2" "$(over20 2 | most | awk '{ printf "%.1f", $1 / 1000 }') kPa" "$(calc "$m / 1000") kPa" \
        '6 to 16 kPa' "$m > 6000 && $m < 16000" '' "$4"
    n=$(number "$1" in_solids_max)
    row "particles in solids at any time, lost, $2" '0, 0' "$n, $(number "$1" escaped)" '0, 0' \
        "$n + $(number "$1" escaped) == 0" '' "$7"
}
