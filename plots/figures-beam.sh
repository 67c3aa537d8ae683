#!/bin/sh
# figures-beam.sh -- draws DIR/beam-frequency.png: what the beam's options do against elements.
#
# Run by `make figures', or by hand in a build tree:  top_srcdir=PATH sh .../figures-beam.sh DIR
# The table and the scripts it was drawn with stay in DIR/beam-frequency/.
set -e

scripts=${top_srcdir:-.}/plots
table=$(cd "${top_builddir:-.}" && pwd)/beam-table
[ -x "$table" ] || { echo "figures-beam: no $table: run make beam-table first" >&2; exit 1; }

mkdir -p "$1/beam-frequency"
cp "$scripts/style.gp" "$scripts/beam-frequency.gp" "$1/beam-frequency"
cd "$1/beam-frequency"
echo '# nothing: this figure belongs to no run' > constants.gp
"$table" > beam-frequency.csv
gnuplot -d beam-frequency.gp
