#!/bin/sh
# figures-kernels.sh -- draws the kernels: DIR/kernel-{gauss,poly6,spiky,viscosity}.png as
# figures 4, 6, 7 and 8 of Toth 2012, DIR/kernels-all.png compares them all.
#
# Run by `make figures', or by hand in a build tree:  top_srcdir=PATH sh .../figures-kernels.sh DIR
# The tables and the scripts they were drawn with stay in DIR/kernels/.
set -e

scripts=${top_srcdir:-.}/plots
table=$(cd "${top_builddir:-.}" && pwd)/kernel-table
[ -x "$table" ] || { echo "figures-kernels: no $table: run make kernel-table first" >&2; exit 1; }

mkdir -p "$1/kernels"
cp "$scripts/style.gp" "$scripts/kernels.gp" "$1/kernels"
cd "$1/kernels"
echo '# nothing: these figures belong to no run' > constants.gp
for kernel in wendland-c2 wendland-c4 wendland-c6 cubic-spline quintic-spline gauss poly6 spiky \
    viscosity-log; do
    "$table" $kernel > $kernel.csv
done
gnuplot -d kernels.gp
