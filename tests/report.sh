#!/bin/sh
# report.sh -- a run ends by saying where its results are and what came out, and `report' makes one
# page of it that needs nothing else: well-formed, with every figure in it, and with the numbers
# that the files hold.  Run by `make check'.
. "${top_srcdir:-.}/tests/lib.sh"
set +e
cd "$out" || exit 99
scene=$top_srcdir/data/scenes/toth-beam.scene
small='until=0.12 spacing=0.01 output.fields=100'

# run NAME KEY=VALUE...: not a quiet one
run() {
    name=$1
    shift
    # shellcheck disable=SC2086 # a word a key
    "$STIFFWATER" run "$scene" $small -o "$name" "$@" >"$name.said" 2>"$name.err"
}

# --- last words -------------------------------------------------------------------------------
run beam || wrong 'the run comes to its end'
prints beam 'results are in beam/' 'energy defect' 'fastest water' 'expected' 'leaks' 'front' \
    'force on plate' 'tip of plate' 'next: stiffwater plot beam'
awk -F, '!/^#/ && ++n > 1 { s = sqrt($2^2 + $3^2); if (s > most) most = s } END { print 1e3 * most }' \
    beam/beam.csv >tip
said=$(sed -n 's/.*tip of plate *\([^ ]*\) mm.*/\1/p' beam.said)
claim 'the tip it tells is that of beam.csv' \
    "${said:-0} > 0 && ($(cat tip) / ${said:-1} - 1)^2 < 1e-6"
said=$(sed -n 's/.*fastest water *\([^ ]*\) m.s, Mach \([^;]*\);.*/\1 \2/p' beam.said)
claim 'Mach is that of eos.c0' "(${said% *} / $(number beam sound) / ${said#* } - 1)^2 < 1e-2"
run beam -q
[ ! -s beam.said ] && good 'a quiet run says nothing' || wrong 'a quiet run says nothing'
scene=$top_srcdir/data/scenes/dam-break.scene
run dam tol=1e-3 method=leapfrog@0.2
prints dam 'warnings:' 'tol = 0.001 does nothing with leapfrog'

# A force on a rigid body is held against its own weight, here 500 kg/m3 x 0.3 m x 0.1 m x 9.81 m/s2.
"$STIFFWATER" run "$top_srcdir/data/scenes/box-in-waves.scene" spacing=0.05 until=0.2 output.interval=0.01 \
    output.fields=100 -o waves >waves.said 2>waves.err
said=$(sed -n 's/.*force on box .*; \(.*\) times its own weight, \(.*\) N.m$/\1 \2/p' waves.said)
claim 'the weight of a box is its own' "(${said#* } + 0 - 147.15)^2 < 1"
claim 'a box that floats is carried by its weight' "${said% *} + 0 > 0.5 && ${said% *} + 0 < 2.5"
prints waves 'times the weight of the fluid'

# --- the page ---------------------------------------------------------------------------------
"$STIFFWATER" report dam >page.said 2>&1
code=$?
if [ $code != 0 ] && ! command -v gnuplot >/dev/null; then
    skip 'there is no gnuplot'
fi
claim 'report ends well' "$code == 0"
page=dam/report.html
for words in 'fastest water' 'tol = 0.001 does nothing with leapfrog' 'particle_mass' 'SUNDIALS' \
    '</html>'; do
    grep -q -F -e "$words" $page && good "the page has: $words" || wrong "the page has: $words"
done
claim 'every figure is in it' \
    "$(ls dam/figures/*.png | wc -l) > 5 && $(ls dam/figures/*.png | wc -l) == $(grep -c 'src="data:image/png;base64,' $page)"
sed 's/"data:image[^"]*"/""/' $page >bare
grep -i -E '(src|href|url|@import|<link|<script)[ =(]*.?.?http' bare &&
    wrong 'it fetches nothing' || good 'it fetches nothing'
sed -n 's/.*base64,\([^"]*\)".*/\1/p' $page | head -n 1 | base64 -d >first.png
cmp -s first.png "$(ls dam/figures/*.png | head -n 1)" && good 'a figure is there to the bit' ||
    wrong 'a figure is there to the bit'
if command -v xmllint >/dev/null; then
    sed 1d $page >page.xml
    xmllint --huge --noout page.xml 2>/dev/null && good 'it is well-formed' || wrong 'it is well-formed'
fi

# Experiments on a column that falls are for such a one only, up to the first solid on its way.
falls() {
    run "$1" output.snapshots=0 until=0.001
    sed -n "s/^$2 = //p" "$1/figures/constants.gp"
}
claim 'a column in the corner falls' "$(falls dam falls) == 1"
scene=$top_srcdir/data/scenes/tank-sizes.scene
claim 'a drop is no column' "$(falls drop falls) == 0"
scene=$top_srcdir/data/scenes/gate.scene
claim 'a gate ends the way' "($(falls gate beam_x) - 0.2)^2 < 1e-12"
scene=$top_srcdir/data/scenes/dam-break.scene

# Texts that look like markup are texts.
run odd 'title=<b>&"x"' || wrong 'a title may be anything'
"$STIFFWATER" report odd >page.said 2>&1
grep -q -F '<h1>&lt;b&gt;&amp;&quot;x&quot;</h1>' odd/report.html && good 'a title is no markup' ||
    wrong "a title is no markup: $(grep h1 odd/report.html)"

# A run that failed has its reason on the page.
run bad eos.fastest=0.1 until=0.4 && wrong 'this run fails'
prints bad 'failed at t ='
"$STIFFWATER" report bad >page.said 2>&1
grep -q '<p class="bad">failed: ' bad/report.html && good 'why it failed' || wrong 'why it failed'
"$STIFFWATER" report nowhere >nowhere.said 2>&1
claim 'no run, no page' "$? == 2"
prints nowhere 'no run in there'
finish
