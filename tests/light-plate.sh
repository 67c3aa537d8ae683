#!/bin/sh
# light-plate.sh -- beams of any mass under a pressure that looks ahead: the water that moves with a
# plate is that of potential flow, and neither steps nor products grow when the plate is light.
. "$top_srcdir/tests/lib.sh"
scene=$top_srcdir/data/scenes/light-plate.scene

# tip RUN TIME: displacement to the left [m]
tip() {
    awk -F, -v at="$2" '!/^[#t]/ && $1 > at - 5e-4 && $1 < at + 5e-4 { print -$2 }' "$out/$1/beam.csv"
}

# peak RUN: the first largest displacement to the left [mm], and its time [s]
peak() {
    awk -F, '!/^[#t]/ { if (-$2 < w) { print 1000 * w, t; exit } w = -$2; t = $1 }' "$out/$1/beam.csv"
}

# --- the scene: peak and half period of a swing with 8.9 Hz (potential flow), +-10 % -----------
well plate "$scene" until=0.15
set -- $(peak plate)
claim 'the tip turns back at half a period' "$2 > 0.9 * 0.5 / 8.9 && $2 < 1.1 * 0.5 / 8.9"
static=$(awk 'BEGIN { print 1000 * 200 * 0.22^4 / 8 / (4.8e8 * 1e-6 / 12) }')
claim 'at nearly twice the static deflection' "$1 > 1.5 * $static && $1 < 2 * $static"
claim 'energy closes' "$(number plate energy_defect_max) < 1e-5 * $(number plate energy_initial)"
claim 'momentum closes' "$(number plate momentum_defect) < 1e-10"
rhs=$(number plate rhs_explicit)
well lighter "$scene" until=0.15 beam.plate.density=0.5
well heavy "$scene" until=0.15 beam.plate.density=5000
claim 'a hundredth of the mass: 1.5 times the right-hand sides at most' \
    "$(number lighter rhs_explicit) < 1.5 * $rhs"
claim 'and 1.5 times the products at most of one with ten thousand times the mass' \
    "$(number lighter operator_products) < 1.5 * $(number heavy operator_products)"
well steel "$scene" until=0.15 beam.plate.E=210e9 beam.plate.elements=40
claim 'nor does a stiff plate bound the steps' "$(number steel rhs_explicit) < 1.2 * $rhs"

well alone "$scene" until=0.002 beam.plate.response=own
prints alone 'weighs 0.11 kg/m and its skin displaces 3.3 kg/m of water' 'set its response = "predicted"'
well heavy_alone "$scene" until=0.002 beam.plate.response=own beam.plate.density=2000
quiet heavy_alone

# --- what others make of it --------------------------------------------------------------------
sed 's/^eos.*/eos = { type = "linear"; c0 = 59.4; };/; /response/d' "$scene" >"$out/linear.scene"
well short "$scene" until=0.02
well linear "$out/linear.scene" until=0.02
claim 'an equation of state takes ten times the right-hand sides' \
    "$(number linear rhs_explicit) > 10 * $(number short rhs_explicit)"
go turns "$out/linear.scene" until=0.02 method=staggered
claim 'water and plate in turn diverge' "$code == 1 && $(number turns t_end) < 0.01"

# --- added mass: a stiff plate, hinged to the floor, between basins of H = L = 0.2 m, no weight ----
# theory: sum over k = (2 n - 1) pi/(2 H) of rho coth(k L)/k 2/H c^2 a side, c the integral of y cos(k y)
theory=$(awk 'BEGIN { pi = atan2(0, -1); H = L = 0.2
    for (n = 1; n < 2000; n++) {
        k = (2 * n - 1) * pi / 2 / H; e = exp(-2 * k * L)
        c = H * sin(k * H) / k + (cos(k * H) - 1) / k^2
        sum += (1 + e) / (1 - e) / k * 2 / H * c * c
    }
    print 2 * 1000 * sum }')
cat >"$out/hinged.scene" <<'END'
dimension = 2; gravity = [0.0, 0.0]; until = 0.03; spacing = 5e-3; reference = { speed = 2.0; };
domain = { from = [0.0, 0.0]; to = [0.415, 0.26]; };
fluid = { left = { type = "box"; from = [0.0, 0.0]; to = [0.2, 0.2]; };
          right = { type = "box"; from = [0.215, 0.0]; to = [0.415, 0.2]; }; };
wall = { tank = { type = "frame"; }; };
walls = "own-density";
beam = { plate = { at = [0.2075, 0.0]; length = 0.22; thickness = 0.01; E = 2e13; mass = 1.0;
                   elements = 5; root = "pinned"; layers = 3; tip_force = 1.0;
                   response = "predicted"; }; };
eos = { type = "look-ahead"; c0 = 59.4; };
effects = { continuity = { }; pressure = { }; density-diffusion = { }; };
output = { interval = 1e-3; };
END
# added RUN MASS: moment of inertia that the water adds [kg m]: from the tip's second difference
added() {
    awk -v a="$(tip "$1" 0.01)" -v b="$(tip "$1" 0.02)" -v c="$(tip "$1" 0.03)" -v m="$2" \
        'BEGIN { L = 0.22; print L / ((a - 2 * b + c) / 1e-4 / L) - m * L^2 / 3 }'
}
# The push is some 5 Pa, tol = 1e-2 of rho0 U^2 is 40: with it 0.01 kg/m have 0.24 kg m.
masses='0.01 100.0'
[ -z "${STIFFWATER_LONG-}" ] || masses='0.01 1.0 100.0'
for mass in $masses; do
    well "hinged$mass" "$out/hinged.scene" beam.plate.mass=$mass tol=1e-4
    moment=$(added "hinged$mass" $mass)
    claim "added moment of inertia of $mass kg/m, which goes with H^4, 15 %" \
        "$moment > 0.85 * $theory && $moment < 1.15 * $theory"
    [ $mass = 0.01 ] && light=$moment
    claim "the same as of 0.01 kg/m, 5 %" "$moment > 0.95 * $light && $moment < 1.05 * $light"
done
finish
