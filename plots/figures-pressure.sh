#!/bin/sh
# figures-pressure.sh -- ways to a pressure on the same axes: dam break and still water with an equation
# of state, standard SPH, look-ahead, PCISPH and MPS, at several spacings: DIR/pressure-ways.png; and
# what a stiffer fluid costs with and without looking ahead: DIR/pressure-stiffness.png; and
# products of its solves up to 100,352 particles: DIR/pressure-products.png.
# doc/pressure.md tells what they show.
#
# Run by `make figures`, or by hand in a build tree:
#
#     top_srcdir=PATH sh .../figures-pressure.sh DIR
#
# Tables stay in DIR/pressure/, and so do runs; one that is done is not done again.  Ten CPU minutes.
#
# dam.csv has a row a run: way, spacing [m], particles of water, sums over pairs, CPU seconds, and
#   finest      rms distance of the front from that of the way's finest run, over the way it went
#   experiment  the same from Martin and Moyce's points up to 3.5 widths, without a shift of time
#   energy      largest energy defect over the energy at the start
#   rough       rms of the horizontal force on the tank about its mean over 11 ms, from 0.25 s on,
#               over rho g H^2
# still.csv: way, spacing, particles, sums, CPU seconds, and of the pressure at the bed from 0.25 to
# 1 s its mean and standard deviation over rho g h, h the gauge's depth; kinetic energy over m g H.
# stiff.csv: pressure, c0 [m/s], particles, right-hand sides, products, CPU seconds of the dam break to 0.3 s.
# products.csv: pressure, spacing [m], particles, steps, right-hand sides, products, CPU seconds of the
# dam break and of still water to 0.03 s.
set -e

top=$(cd "${top_srcdir:-.}" && pwd)
stiffwater=${STIFFWATER:-$(cd "${top_builddir:-.}" && pwd)/stiffwater}
scenes=$top/data/scenes
mkdir -p "$1/pressure"
for plot in style pressure-ways pressure-stiffness pressure-products; do
    cp "$top/plots/$plot.gp" "$1/pressure"
done
cd "$1/pressure"
echo '# nothing: these figures belong to no single run' > constants.gp

ways='tait tait-30U standard look-ahead look-ahead-contact pcisph mps mps-enhanced'

# scene WAY SHIPPED: the shipped scene as one of that way; 59.4 m/s are 30 U
scene()
{
    case $1 in
    tait) cat "$2" ;;
    tait-30U) sed 's/^eos = .*/eos = { type = "tait"; c0 = 59.4; tension = false; };/' "$2" ;;
    standard) sed 's/^eos = .*/eos = { type = "linear"; c0 = 19.8; tension = false; };/
        s/^    continuity = /    summation = /; /^    density-/d; $ a\
walls = "ghost";' "$2" ;;
    linear) sed 's/^eos = .*/eos = { type = "linear"; };/; /density-healing/d; $ a\
walls = "own-density";' "$2" ;;
    look-ahead) sed 's/^eos = .*/eos = { type = "look-ahead"; };/; /density-healing/d; $ a\
walls = "own-density";' "$2" ;;
    look-ahead-contact) sed 's/^eos = .*/eos = { type = "look-ahead"; };/; /density-healing/d' "$2" ;;
    no-tension) sed 's/^eos = .*/eos = { type = "look-ahead"; tension = false; };/; $ a\
walls = "own-density";' "$2" ;;
    mps-enhanced) sed '$ a\
walls = "own-density"; method = "mps"; mps = { bundle = "enhanced"; };' "$2" ;;
    *) sed '$ a\
walls = "own-density"; method = "'"$1"'";' "$2" ;;
    esac
}

# go RUN SCENE WAY SPACING UNTIL [KEY=VALUE]: unless it is there and done
go()
{
    if grep -q '"status": "done"' "$1/run.json" 2> /dev/null; then return 0; fi
    echo "figures-pressure: $1" >&2
    scene "$3" "$2" > "$1.scene"
    # shellcheck disable=SC2086 # a word or none
    "$stiffwater" run "$1.scene" -q --threads 1 --until "$5" -o "$1" spacing="$4" output.fields=10 \
        output.snapshots=1 output.interval=1e-3 $6
}

# number RUN KEY: of run.json
number()
{
    sed -n "s/^ *\"$2\": \(.*[0-9]\),*\$/\1/p" "$1/run.json"
}

# spent RUN: particles, sums over pairs, CPU seconds
spent()
{
    products=$(number "$1" operator_products)
    echo "$(number "$1" fluid) $(($(number "$1" pair_passes) + ${products:-0})) $(number "$1" cpu_s)"
}

# front RUN SPACING: t and way of the front, half a spacing before the foremost particle
front()
{
    awk -F, -v half="$2" '/^[#t]/ { next } { print $1, $2 + half / 2 - 0.1 }' "$1/front.csv"
}

# distance SEEN TRUE: rms of seen from true where both are, over the largest of true
distance()
{
    awk 'NR == FNR { t[++m] = $1; v[m] = $2; next }
        $1 > t[m] || $1 < t[1] { next }
        { if (!i) i = 1
          while (i < m - 1 && t[i + 1] < $1) i++
          far = v[i] + ($1 - t[i]) / (t[i + 1] - t[i]) * (v[i + 1] - v[i]) - $2
          s += far * far; n++; if ($2 > most) most = $2 }
        END { if (!n || !most) exit 1; printf "%.4g", sqrt(s / n) / most }' "$1" "$2"
}

# Their points, t [s] and way [m], of a column 0.1 m wide up to 3.5 widths.
experiment()
{
    awk -F, -v a=0.1 -v g=9.81 '/^a/ && $3 <= 3.5 { print $2 * sqrt(a / (2 * g)), ($3 - 1) * a }' \
        "$top/data/reference/B01a_martin_moyce_1952_front_n2_2.csv"
}

# rough RUN: see above
rough()
{
    awk -F, '/^#/ { next }
        /^t,/ { for (i = 1; i <= NF; i++) if ($i == "tank.fx") at = i; next }
        { n++; t[n] = $1; f[n] = $at }
        END { for (i = 6; i <= n - 5; i++) {
                  if (t[i] < 0.25) continue
                  mean = 0
                  for (k = i - 5; k <= i + 5; k++) mean += f[k] / 11
                  s += (f[i] - mean) ^ 2; m++ }
              if (!m) exit 1
              printf "%.4g", sqrt(s / m) / (1000 * 9.81 * 0.04) }' "$1/forces.csv"
}

# dam WAY SPACING FINEST
dam()
{
    run=dam-$1-$2
    front "$run" "$2" > seen
    front "dam-$1-$3" "$3" > true
    echo "$1 $2 $(spent "$run") $(distance seen true) $(distance seen experiment)" \
        "$(awk -v d="$(number "$run" energy_defect_max)" -v e="$(number "$run" energy_initial)" \
            'BEGIN { printf "%.4g", d / e }') $(rough "$run")"
}

# still WAY SPACING
still()
{
    run=still-$1-$2
    column=$(awk -F, '/^t,/ { for (i = 1; i <= NF; i++) if ($i == "bed") print i }' "$run/probes.csv")
    bed=$(awk -F, -v c="$column" -v h=0.185 '/^[#t]/ || $1 < 0.25 { next }
        { p = $c / (1000 * 9.81 * h); s += p; q += p * p; n++ }
        END { printf "%.4g %.4g", s / n, sqrt(q / n - (s / n) ^ 2) }' "$run/probes.csv")
    column=$(awk -F, '/^t,/ { for (i = 1; i <= NF; i++) if ($i == "kinetic") print i }' "$run/book.csv")
    kinetic=$(awk -F, -v c="$column" '/^[#t]/ || $1 < 0.25 { next } { s += $c; n++ }
        END { printf "%.4g", s / n / (40 * 9.81 * 0.2) }' "$run/book.csv")
    echo "$1 $2 $(spent "$run") $bed $kinetic"
}

# --- runs ----------------------------------------------------------------------------------------
experiment | sort -g > experiment
for way in $ways; do
    for dx in 0.0125 0.01 0.005 0.0025; do
        go "dam-$way-$dx" "$scenes/dam-break.scene" "$way" $dx 0.4
    done
    for dx in 0.02 0.01 0.005; do go "still-$way-$dx" "$scenes/still-water.scene" "$way" $dx 1; done
done
{
    echo 'way spacing particles passes cpu finest experiment energy rough'
    for way in $ways; do
        for dx in 0.0125 0.01 0.005 0.0025; do dam "$way" $dx 0.0025; done
    done
} > dam.csv
{
    echo 'way spacing particles passes cpu mean deviation kinetic'
    for way in $ways; do for dx in 0.02 0.01 0.005; do still "$way" $dx; done; done
} > still.csv
gnuplot -d pressure-ways.gp

# --- stiffness, and size ---------------------------------------------------------------------------
# stiff WAY C0 SPACING
stiff()
{
    go "stiff-$1-$2-$3" "$scenes/dam-break.scene" "$1" "$3" 0.3 "eos.c0=$2"
    run=stiff-$1-$2-$3
    echo "$1 $2 $(number "$run" fluid) $(number "$run" rhs_explicit) $(number "$run" operator_products)" \
        "$(number "$run" cpu_s)"
}
{
    echo 'pressure c0 particles rhs products cpu'
    for c0 in 19.8 39.6 59.4 118.8 198 396; do
        for way in linear look-ahead no-tension; do stiff $way $c0 3.3333333333333333e-3; done
    done
    for dx in 5e-3 2e-3 1e-3; do
        for way in look-ahead no-tension; do stiff $way 59.4 $dx; done
    done
} > stiff.csv
gnuplot -d pressure-stiffness.gp

# --- products of a solve against particles ---------------------------------------------------------
# size NAME SCENE SPACING
size()
{
    run=size-$1-$3
    go "$run" "$scenes/$2.scene" look-ahead "$3" 0.03
    echo "$1 $3 $(number "$run" fluid) $(number "$run" steps) $(number "$run" rhs_explicit)" \
        "$(number "$run" operator_products) $(number "$run" cpu_s)"
}
{
    echo 'pressure spacing particles steps rhs products cpu'
    for dx in 3.3333333333333333e-3 2e-3 1e-3 6.25e-4 4.46428571428571428e-4; do
        size look-ahead dam-break $dx
    done
    for dx in 5e-3 2.5e-3 1.25e-3; do size still still-water $dx; done
} > products.csv
gnuplot -d pressure-products.gp
