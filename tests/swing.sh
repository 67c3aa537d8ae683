#!/bin/sh
# swing.sh -- beams that vibrate long: with default settings ten periods leave the amplitude as
# it is to 1 %, however small it is against the thickness.
#
# A cantilever alone, let go from a small load, keeps its first mode; the exact amplitude is
# that of the same run at tol 1e-6, by imex5.
. "$top_srcdir/tests/lib.sh"
data=$top_srcdir/data/scenes

# amplitude RUN COLUMN FROM TO: half of the way between its ends
amplitude() {
    column "$1/beam" "$2" | awk -v from="$3" -v to="$4" '$1 < from || $1 > to { next }
        !n++ { low = high = $2 } { if ($2 < low) low = $2; if ($2 > high) high = $2 }
        END { printf "%.9g", (high - low) / 2 }'
}

# mode RUN FROM: of the part of the tip's way that has the period in water, over two of them;
# beside it is the sound that the water rings with, which is another run's in other steps
mode() {
    column "$1/beam" strip.tip_x | awk -v from="$2" -v T=0.1777 '$1 < from || $1 > from + 2 * T { next }
        { w = 2 * atan2(0, -1) / T * $1; x[++n] = $2; c[n] = cos(w); s[n] = sin(w); mean += $2 }
        END { for (i = 1; i <= n; i++) { a += (x[i] - mean / n) * c[i]; b += (x[i] - mean / n) * s[i] }
            printf "%.9g", 2 / n * sqrt(a * a + b * b) }'
}

# scene FILE: without its method and its tolerance
scene() { sed '/^method/d; /^tol/d' "$data/$1.scene" >"$out/$1.scene"; }
scene beam-alone
scene elastica

# swings NAME SCENE COLUMN FROM TO KEY=VALUE...: default against exact
swings() {
    this=$1 scene=$out/$2.scene of=$3 from=$4 to=$5
    shift 5
    well "$this" "$scene" until="$to" "$@"
    well "$this-exact" "$scene" until="$to" method=imex5 tol=1e-6 "$@"
    a=$(amplitude "$this" "$of" "$from" "$to")
    b=$(amplitude "$this-exact" "$of" "$from" "$to")
    claim "$this: ten periods leave the amplitude to 1 %" \
        "$b > 0 && $a > 0.99 * $b && $a < 1.01 * $b"
    claim "$this: at less than 2,000 right-hand sides" "$(number "$this" rhs_explicit) < 2000"
}
swings thick beam-alone plate.tip_x 0.09 0.105 beam.plate.tip_force=10.0
swings thin beam-alone plate.tip_x 0.09 0.105 beam.plate.tip_force=1e-2
swings far elastica strip.tip_y 9.5 10.6 beam.strip.bent=10.0 output.interval=5e-3
swings slight elastica strip.tip_y 9.5 10.6 beam.strip.bent=0.1 output.interval=5e-3
claim 'the default is imex4 there' "$(value thin method | tr -d a-z) == 4"

# Under water, let go at 0.2 s: some eight periods of 0.178 s (0.055 s in air), of which water
# takes two thirds of the amplitude.
cat >"$out/wet.scene" <<'S'
dimension = 2;
gravity = [0.0, -9.81];
until = 1.8;
spacing = 1e-2;
domain = { from = [0.0, 0.0]; to = [0.41, 0.4]; lid = false; };
fluid = { left = { type = "box"; from = [0.0, 0.0]; to = [0.19, 0.3]; };
          right = { type = "box"; from = [0.22, 0.0]; to = [0.41, 0.3]; };
          above = { type = "box"; from = [0.19, 0.2]; to = [0.22, 0.3]; }; };
wall = { tank = { type = "frame"; }; };
beam = { strip = { at = [0.205, 0.0]; length = 0.2; thickness = 0.01; E = 4e8; density = 2000.0;
                   elements = 10; layers = 3; tip_force = 20.0; load_until = 0.2; }; };
eos = { type = "tait"; rho0 = 1000.0; gamma = 7.0; };
effects = { continuity = { }; pressure = { }; artificial-viscosity = { alpha = 0.005; };
            density-diffusion = { delta = 0.1; }; };
output = { interval = 2e-3; };
S
well wet "$out/wet.scene"
well wet-exact "$out/wet.scene" tol=1e-5
for from in 0.22 1.44; do
    a=$(mode wet $from) b=$(mode wet-exact $from)
    claim "in water as at tol 1e-5, to 1.5 %, from $from s" "$a > 0.985 * $b && $a < 1.015 * $b"
    ratio=$(awk "BEGIN { print $a / $b }")
    : "${first:=$ratio}"
done
claim 'and seven periods take no more of it, to 0.5 %' \
    "$ratio > 0.995 * $first && $ratio < 1.005 * $first"
claim 'in water energy closes to 0.5 %' \
    "$(number wet energy_defect_max) < 5e-3 * $(number wet energy_initial)"
claim 'the default is imex3 there' "$(value wet method | tr -d a-z) == 3"

# What warns of energy that went missing names the method that keeps it.
well damped "$data/elastica.scene" method=imex3 tol=0.1 until=2
prints damped 'take method = "imex4", which hardly damps'
finish
