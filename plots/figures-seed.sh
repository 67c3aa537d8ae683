#!/bin/sh
# figures-seed.sh -- redraws the dam breaks of Toth 2012 (figures 13, 14) and measures what his
# text claims: DIR/seed-13.png, seed-14.png, seed-stiffness.png, seed-tension.png,
# seed-clustering.png.  doc/seed-000.md tells what they show.
#
# Run by `make figures', or by hand in a build tree:  top_srcdir=PATH sh .../figures-seed.sh DIR
# The runs, the tables and the scripts stay in DIR/seed/.  Three to four CPU minutes.
set -e

top=$(cd "${top_srcdir:-.}" && pwd)
stiffwater=${STIFFWATER:-$(cd "${top_builddir:-.}" && pwd)/stiffwater}
mkdir -p "$1/seed"
cp "$top/plots/style.gp" "$top"/plots/seed-*.gp "$1/seed"
cd "$1/seed"
echo '# nothing: these figures belong to no single run' > constants.gp

# run NAME SCENE KEY=VALUE...
run()
{
    directory=$1
    scene=$2
    shift 2
    "$stiffwater" run "$top/data/scenes/$scene.scene" -q --threads 2 output.fields=0.1 \
        -o "$directory" "$@"
}

# value RUN KEY: from run.json, a line each
value()
{
    sed -n "s/^ *\"$2\": *\"\\{0,1\\}\\([^\",]*\\).*/\\1/p" "$1/run.json"
}

# last FILE COLUMN: of the last row
last()
{
    awk -F, -v name="$2" '/^#/ { next } /^t/ { for (i = 1; i <= NF; i++) if ($i == name) c = i }
        { x = $c } END { print x }' "$1"
}

# row RUN WORD...: of a table of dam breaks, after the words
row()
{
    directory=$1
    shift
    for word; do printf '%s,' "$word"; done
    arrival=$(awk -F, '!/^[#t]/ && $2 > 0.39 { print $1; exit }' "$directory/front.csv")
    for key in steps cpu_s density_max escaped energy_initial; do
        printf '%s,' "$(value "$directory" $key)"
    done
    echo "${arrival:-nan},$(last "$directory/book.csv" kinetic),$(
        last "$directory/book.csv" pressure_defect),$(last "$directory/pairing.csv" pairing)"
}
columns=steps,cpu_s,density_max,escaped,energy_initial,front_at_wall,kinetic,energy_made,pairing
small=spacing=3.3333333333333333e-3
one='kernel.density=wendland-c2 kernel.pressure=wendland-c2 kernel.support=3'

# --- figures 13 and 14; stiffness, with the kernels of Toth (2012) and with one ------------------
# stiff NAME C SCENE KEY=VALUE...: with 5,000 particles, and 1,800 of one kernel
stiff()
{
    name=$1
    c=$2
    shift 2
    run "$name" "$@" until=0.6
    row "$name" "$name" "$c" seed >> stiffness.csv
    run "$name-one" "$@" until=0.6 $small $one
    row "$name-one" "$name" "$c" one >> stiffness.csv
}
echo "run,c,kernels,$columns" > stiffness.csv
stiff standard-printed 100 toth-standard-sph
stiff standard-matched 19.8 toth-standard-sph eos.k=392.4
stiff wcsph 19.8 toth-dam-break
stiff wcsph-printed 4 toth-dam-break eos.c0=4
cp "$top/data/reference/B01a_martin_moyce_1952_front_n2_2.csv" .
gnuplot -d seed-stiffness.gp

# figure NUMBER RUN: the program's own picture of six moments in two colours
figure()
{
    "$stiffwater" plot "$2" > plot.log 2>&1 || { cat plot.log >&2; exit 1; }
    cp "$2/figures/dye.png" "../seed-$1.png"
}
figure 13 standard-printed
figure 14 wcsph

# --- tension at the surface, and its cures ---------------------------------------------
echo "run,$columns" > tension.csv
run tension toth-dam-break until=0.1 $small eos.tension=true
run tension-one toth-dam-break until=0.1 $small $one eos.tension=true
run no-tension toth-dam-break until=0.1 $small
run continuity dam-break until=0.1 $small walls=adami
for name in tension tension-one no-tension continuity; do
    row $name $name >> tension.csv
done
gnuplot -d seed-tension.gp

# --- pairs under pressure, by kernel and support -----------------------------------------
echo 'kernel,support,pairing,nearest_mean,nearest_least,energy_made' > clustering.csv
# cluster NAME SUPPORT KEY=VALUE...
cluster()
{
    name=$1
    support=$2
    shift 2
    run "cluster-$name-$support" clustering "kernel.support=$support" "$@"
    echo "$name,$support,$(last "cluster-$name-$support/pairing.csv" pairing),$(
        last "cluster-$name-$support/pairing.csv" nearest_mean),$(
        last "cluster-$name-$support/pairing.csv" nearest_least),$(
        last "cluster-$name-$support/book.csv" pressure_defect)" >> clustering.csv
}
for kernel in poly6 gauss cubic-spline quintic-spline wendland-c2 wendland-c4 wendland-c6 \
    spiky seed; do
    for support in 2.52 3 4 5; do
        case $kernel in
        seed) cluster seed $support kernel.type=spiky kernel.density=poly6 ;;
        *) cluster $kernel $support "kernel.type=$kernel" ;;
        esac
    done
done
gnuplot -d seed-clustering.gp
