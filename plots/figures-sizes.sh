#!/bin/sh
# figures-sizes.sh -- the error of one splash in tanks of 2,208 to 200,208 particles, by the
# three norms of error tests: DIR/sizes.png.  doc/accuracy.md tells what it shows.
#
# Run by `make figures', or by hand in a build tree:  top_srcdir=PATH sh .../figures-sizes.sh DIR
# The table and the script stay in DIR/sizes/.  Three CPU minutes, most of them for the last
# tank; LENGTHS='0.2 0.6 2 6' leaves it out.
set -e

top=$(cd "${top_srcdir:-.}" && pwd)
stiffwater=${STIFFWATER:-$(cd "${top_builddir:-.}" && pwd)/stiffwater}
mkdir -p "$1/sizes"
cp "$top/plots/style.gp" "$top/plots/sizes.gp" "$1/sizes"
cd "$1/sizes"
echo '# nothing: this figure belongs to no single run' > constants.gp

# run NAME LENGTH KEY=VALUE...: particles at its start and end, few other outputs
run()
{
    directory=$1
    length=$2
    shift 2
    "$stiffwater" run "$top/data/scenes/tank-sizes.scene" -q --threads 2 -o "$directory" \
        "domain.to=[$length,0.1]" "fluid.rest.to=[$length,0.04]" \
        output.interval=0.01 output.fields=1 output.snapshots=2 "$@"
}

# value RUN KEY: from run.json, a line each
value()
{
    sed -n "s/^ *\"$2\": *\"\\{0,1\\}\\([^\",]*\\).*/\\1/p" "$1/run.json"
}

# error RUN REFERENCE: rms and largest distance of the particles of drop and corner from
# where the reference has them, in spacings
error()
{
    paste -d, "$1/snapshots/0001.csv" "$2/snapshots/0001.csv" | awk -F, '
        $7 == 1 && $8 == 0 {
            d = ($1 - $9) ^ 2 + ($2 - $10) ^ 2
            sum += d
            n++
            if (d > most) most = d
        }
        END { printf "%.4g,%.4g", sqrt(sum / n) / 2e-3, sqrt(most) / 2e-3 }'
}

# row NORM TOL LENGTH: of the table
row()
{
    run splash "$3" norm="$1" tol="$2"
    echo "$1,$2,$(value splash fluid),$(error splash reference),$(value splash steps),$(
        value splash rhs_explicit),$(value splash stability)" >> rows.csv
}

rm -f splash.csv rows.csv
for length in ${LENGTHS:-0.2 0.6 2 6 20}; do
    run reference "$length" method=bs54 tol=1e-6
    [ -f splash.csv ] || cp reference/snapshots/0001.csv splash.csv
    for norm in max p8 wrms; do
        row $norm 1e-4 "$length"
    done
    row max 1e-2 "$length"
    row wrms 1e-2 "$length"
done
{
    echo 'norm,tol,particles,error,largest,steps,rhs,stability'
    sort -t, -k1,1 -k2,2 -k3,3n rows.csv
} > sizes.csv
rm -r splash reference rows.csv
gnuplot -d sizes.gp
