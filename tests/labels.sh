#!/bin/sh
# labels.sh -- points of work-precision figures tell their tolerance, and no label lies on another
# or on a coloured point, however near runs of twelve methods are.  Run by `make check'.
. "${top_srcdir:-.}/tests/lib.sh"
command -v gnuplot >"$out/said" || skip 'no gnuplot'
cd "$out"
"$STIFFWATER" compare "$top_srcdir/tests/scenes/small-2d.scene" until=0.004 -q -M cks43 -T 1e-2 \
    -R bs54:1e-3 -o dam >said 2>&1 || { cat said; exit 1; }

# Columns 4 to 25 of rows that stand within a tenth in cost, a factor of 10 in error.
awk -F, -v OFS=, 'NR <= 2 { print; next }
    { for (i = 1; i <= split("cks43 imex2 imex3 opt53 bs54 ab3 dv adams erk2 erk3 erk4 bdf", name, " "); i++)
        for (k = 1; k <= 3; k++) {
            $1 = name[i]; $2 = "1e-" k; $3 = "done"
            $4 = 0.1 * (1 + (7 * i + 3 * k) % 29 / 290); $11 = int(100 * (1 + (5 * i + 4 * k) % 31 / 310))
            for (c = 13; c <= 19; c++) if ($c != "nan") $c = 1e-4 * 10^((0.618 * i + 0.377 * k + 0.1 * c) % 1)
            print
        } }' dam/compare.csv >many && mv many dam/compare.csv

# The script, which also prints where labels and points of each panel stand.
cd dam/figures
sed 's/eval place_labels;/eval place_labels; eval tell;/' "$top_srcdir/plots/work-precision.gp" |
    awk '/^# A panel of quantity/ {
        print "tell = \"print \\\"panel\\\"; do for [i = 1:runs] { print point_x[i], point_y[i], corner[i], label_x[i], label_y[i], long(i) }\"" }
        { print }' >tells.gp
cp "$top_srcdir/plots/style.gp" "$top_srcdir/plots/comparison.gp" .
gnuplot tells.gp 2>"$out/told" || { tail -n 3 "$out/told"; exit 1; }
grep -E '^(panel|[0-9.e+-]+ [0-9.e+-]+ [0-4] )' "$out/told" >"$out/places"
awk '/^panel/ { n = 0; panels++; next }
    { n++; x[n] = $1; y[n] = $2; c[n] = $3; a[n] = $4; b[n] = $5; w[n] = $6; labels += $3 > 0 }
    n == 36 { for (i = 1; i <= n; i++) if (c[i] > 0) for (j = 1; j <= n; j++) {
        if (i != j && c[j] > 0 && a[i] < a[j] + w[j] && a[j] < a[i] + w[i] && (b[i] - b[j])^2 < 12^2) on_labels++
        if (x[j] > a[i] && x[j] < a[i] + w[i] && y[j] > b[i] && y[j] < b[i] + 12) on_points++ } }
    END { print panels + 0, labels + 0, on_labels + 0, on_points + 0 }' "$out/places" >"$out/counts"
read -r panels labels on_labels on_points <"$out/counts"
claim 'panels have labels' "$panels >= 6 && $labels >= 6 * $panels"
claim 'no label lies on another' "$on_labels == 0"
claim 'no label lies on a coloured point' "$on_points == 0"
finish
