#!/bin/sh
# figures-search.sh -- what a search for neighbours costs: DIR/seed-search.png, that of Toth (2012)
# beside the list of this program.  doc/seed-000.md tells what it shows.
#
# Run by `make figures`, or by hand in a build tree:  top_srcdir=PATH sh .../figures-search.sh DIR
# The table stays in DIR/search/.  One CPU minute.
set -e

scripts=${top_srcdir:-.}/plots
table=$(cd "${top_builddir:-.}" && pwd)/search-table
[ -x "$table" ] || { echo "figures-search: no $table: run make search-table first" >&2; exit 1; }

mkdir -p "$1/search"
cp "$scripts/style.gp" "$scripts/seed-search.gp" "$1/search"
cd "$1/search"
echo '# nothing: this figure belongs to no run' > constants.gp
OMP_NUM_THREADS=1 "$table" > search.csv
gnuplot seed-search.gp
