#!/bin/sh
# report-long.sh -- a browser without a network shows the page of `report', pictures and all.  Run by
# `make check-long'.
. "${top_srcdir:-.}/tests/lib.sh"
set +e
command -v gnuplot >/dev/null || skip 'there is no gnuplot'
command -v chromium >/dev/null || skip 'there is no chromium'
cd "$out" || exit 99
"$STIFFWATER" run "$top_srcdir/data/scenes/toth-beam.scene" spacing=0.01 until=0.1 -q -o beam \
    >beam.said 2>&1 || wrong 'the run comes to its end'
"$STIFFWATER" report beam >report.said 2>&1 || wrong 'there is a report'
browse() {
    HOME=$out timeout 120 chromium --headless --no-sandbox --disable-gpu \
        --proxy-server=127.0.0.1:9 "$@" 2>browse.said
}
browse --window-size=1100,5200 --screenshot="$out/shot.png" "file://$out/beam/report.html"
claim 'a screenshot' "$(wc -c <shot.png) > 100000"
# A script of ours, in a copy, counts the pictures that the browser could decode.
sed 's#</body>#<script>onload = function () { var n = 0; for (var i of document.images) \
n += i.complete \&\& i.naturalWidth > 100; document.title = "shown " + n; }</script></body>#' \
    beam/report.html >copy.html
browse --dump-dom "file://$out/copy.html" >dom
shown=$(sed -n 's#.*<title>shown \([0-9]*\)</title>.*#\1#p' dom)
claim 'every picture is shown' "${shown:-0} > 5 && ${shown:-0} == $(ls beam/figures/*.png | wc -l)"
finish
