#!/bin/sh
# reading.sh -- what doc/reading.md shows runs as it stands there, and every column that runs leave
# is in its table with the unit that the file says.  Run by `make check'.
. "${top_srcdir:-.}/tests/lib.sh"
set +e
page=$(cd "$top_srcdir" && pwd)/doc/reading.md
python=
for try in python3 /usr/bin/python3; do
    "$try" -c 'import numpy, h5py, matplotlib' 2>/dev/null && { python=$try; break; }
done
cd "$out" || exit 99

# run SCENE NAME KEY=VALUE...
run() {
    scene=$1
    name=$2
    shift 2
    "$STIFFWATER" run "$top_srcdir/$scene" -q -o "$name" "$@" >"$name.said" 2>&1 ||
        { wrong "$name comes to its end"; cat "$name.said"; }
}

# --- columns ------------------------------------------------------------------------------------
run data/scenes/toth-beam.scene beam spacing=0.01 until=0.02 output.checkpoint=0.01 \
    panel.left.of=tank 'panel.left.from=[-1,-1]' 'panel.left.to=[0,1]' 'panel.left.along=[1,0]' \
    'panel.left.about=[0,0]' probe.a.what=pressure 'probe.a.at=[0,0.01]' probe.a.window=0.005
run data/scenes/poiseuille.scene flow until=0.001
run tests/scenes/small-3d.scene deep until=0.001
grep '^| `' "$page" | sed 's/`//g' >table
grep '^| all' "$page" | sed 's/`//g' >>table
# A name of the scene becomes NAME, an axis x; units of 2D lose their metre of depth.
for file in */*.csv */snapshots/0000.csv; do
    name=${file#*/}
    names=$(grep -v '^#' "$file" | head -n 1)
    units=$(sed -n 's/^# units: //p' "$file" | head -n 1)
    echo "$names" | tr , '\n' >names
    echo "$units" | tr , '\n' >units
    paste -d '|' names units | while IFS='|' read -r column unit; do
        plain=$(echo "$column" | sed 's/^[^.]*\./NAME./; s/\(_\|\.f\|\.i\|\.m\)[yz]$/\1x/; s/_mid_/_tip_/
            s/\.mid_x/.tip_x/; s/^u[yz]$/ux/; s/^[yz]$/x/; s/nearest_least/nearest_mean/')
        found=$(grep -F "| $name | $plain |" table || grep -F "| all | $plain |" table ||
            grep -F "| forces.csv | $plain |" table || grep -F "| $name | NAME |" table)
        told=$(echo "$found" | head -n 1 | cut -d '|' -f 4 | sed 's/^ *//; s/ *$//')
        bare=$(echo "$unit" | sed 's/ *$//; s/\/m$//')
        case ", $told, " in
        *", $unit, "* | *", $bare, "* | *" or $unit, "* | *", $unit or "* | ", 1, ") ;;
        *) echo "$file: $column [$unit] is told as '$told'" ;;
        esac
        [ -n "$found" ] || echo "$file: $column is not told"
    done
done >complaints
claim 'every column is told with its unit' "$(wc -l <complaints) == 0"
cat complaints
claim 'there are columns' "$(ls */*.csv | wc -l) > 15"

# --- programs -----------------------------------------------------------------------------------
run data/scenes/dam-break.scene dam-break spacing=0.01 until=0.1
# block WORD: the lines of the page between ```WORD and ```
block() {
    sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/p" "$page" | sed '1d;$d'
}
block python >reading.py
block gnuplot >reading.gp
claim 'ten lines each' "$(wc -l <reading.py) == 10 && $(wc -l <reading.gp) == 10"
missing=
if [ -n "$python" ]; then
    "$python" reading.py >python.said 2>&1 && [ -s reading-python.png ] && good 'Python' ||
        { wrong 'Python'; cat python.said; }
else
    missing='numpy, h5py or matplotlib'
fi
if command -v gnuplot >/dev/null; then
    gnuplot reading.gp >gnuplot.said 2>&1 && [ -s reading-gnuplot.png ] && [ ! -s gnuplot.said ] &&
        good 'gnuplot' || { wrong 'gnuplot'; cat gnuplot.said; }
else
    missing="$missing gnuplot"
fi
[ $bad = 0 ] && [ -n "$missing" ] && skip "there is no $missing"
finish
