#!/bin/sh
# figures-sticking.sh -- artificial viscosity that sticks to solids or slips along them, with and
# without tension, as particles get smaller: DIR/sticking.png.  doc/walls.md tells what it shows.
#
# Run by `make figures`, or by hand in a build tree:
#
#     top_srcdir=PATH sh .../figures-sticking.sh DIR [CASE...]
#
# Cases: obstacle (peak of the tip, mm), farwall (mean force over rho g H^2 for 2.3 < T < 3.5),
# flagship (peak of the tip, mm).  Runs stay in DIR/sticking/, and one that is done is not done
# again.  Fifteen CPU minutes.
#
# A table has a row a spacing and family: family, spacing [m], result.
set -e

top=$(cd "${top_srcdir:-.}" && pwd)
stiffwater=${STIFFWATER:-$(cd "${top_builddir:-.}" && pwd)/stiffwater}
mkdir -p "$1/sticking"
cp "$top/plots/style.gp" "$top/plots/sticking.gp" "$1/sticking"
cd "$1/sticking"
shift
echo '# nothing: this figure belongs to no single run' > constants.gp

# run NAME FAMILY SCENE KEY=VALUE...: unless it is there and done.  Families: slip, stick, and both
# healed, which is without tension.
run()
{
    directory=$1 family=$2 scene=$3
    shift 3
    if grep -q '"status": "done"' "$directory/run.json" 2> /dev/null; then return 0; fi
    echo "figures-sticking: $directory" >&2
    case $family in
    slip*) set -- "$@" effects.artificial-viscosity.stick=none ;;
    stick*) set -- "$@" effects.artificial-viscosity.stick=particles ;;
    esac
    case $family in
    *-healed) set -- "$@" eos.tension=false 'effects.density-healing={}' ;;
    *) set -- "$@" eos.tension=true effects.density-healing.strength=0 ;;
    esac
    "$stiffwater" run "$top/$scene" -q --threads 1 -o "$directory" output.fields=10 \
        output.snapshots=1 "$@"
}

# peak RUN UNTIL: of the tip [mm]
peak()
{
    awk -F, -v until="$2" '!/^[#t]/ && $1 <= until && $2 > m { m = $2 }
        END { printf "%.4f", 1000 * m }' "$1/beam.csv"
}

# --- the elastic obstacle: spacings in 0.146 m, layers of 12 mm --------------------------------
obstacle_sizes='24:2 36:3 49:4 73:6'
obstacle()
{
    dx=$(awk -v n="${2%:*}" 'BEGIN { printf "%.17g", 0.146 / n }')
    run "obstacle-$1-${2%:*}" "$1" data/scenes/elastic-obstacle.scene until=0.35 spacing="$dx" \
        beam.obstacle.layers="${2#*:}"
    echo "$1 $dx $(peak "obstacle-$1-${2%:*}" 0.3)"
}

# --- a dam break against a far wall, 20 mm further than measured: spacings in H ------------------
farwall_sizes='30 40 60'
farwall()
{
    dx=$(awk -v n="$2" 'BEGIN { printf "%.17g", 0.6 / n }')
    run "farwall-$1-$2" "$1" tests/validation/buchner.scene until=0.88 spacing="$dx" \
        domain.to=[3.42,1.98] 'wall.far={type="box";from=[3.24,0.0];to=[3.42,1.98];}'
    echo "$1 $dx $(awk -F, '
        /^t/ { for (i = 1; i <= NF; i++) if ($i == "far.fx") c = i; next }
        /^#/ { next }
        { T = $1 * sqrt(9.81 / 0.6) } T > 2.3 && T < 3.5 { s += $c; n++ }
        END { printf "%.4f", s / n / 3531.6 }' "farwall-$1-$2/forces.csv")"
}

# --- the flagship: spacings in 0.1 m, layers of 10 mm --------------------------------------------
flagship_sizes='20:2 30:3 40:4 60:6'
flagship()
{
    dx=$(awk -v n="${2%:*}" 'BEGIN { printf "%.17g", 0.1 / n }')
    run "flagship-$1-${2%:*}" "$1" data/scenes/toth-beam.scene until=0.3 spacing="$dx" \
        beam.plate.layers="${2#*:}"
    echo "$1 $dx $(peak "flagship-$1-${2%:*}" 0.3)"
}

for case in ${*:-obstacle farwall flagship}; do
    eval "sizes=\$${case}_sizes"
    for family in slip stick slip-healed stick-healed; do
        for size in $sizes; do $case $family "$size"; done
    done > "$case.new"
    mv "$case.new" "$case.csv"
done
if [ -f obstacle.csv ] && [ -f farwall.csv ] && [ -f flagship.csv ]; then
    gnuplot -d sticking.gp
fi
