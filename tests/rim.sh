#!/bin/sh
# rim.sh -- a tank whose walls end below the top of the domain: what rises above them falls back and
# is not lost, a warning comes when water can spill, still water stays, and a rim at the top is no
# other tank than one without a lid.
. "$top_srcdir/tests/lib.sh"

# A sanitizer sees walls that end, not what gets over them.
if brief; then until=0.02; else until=0.4; fi

# tank NAME RIM FLUID_WIDTH [TOP]
tank() {
    cat >"$out/$1.scene" <<S
dimension = 2; gravity = [0.0, -9.81]; until = $until; spacing = 0.01;
domain = { from = [0.0, 0.0]; to = [0.4, ${4-0.8}]; lid = false; };
fluid = { water = { type = "box"; from = [0.0, 0.0]; to = [$3, 0.2]; }; };
wall = { tank = { type = "frame"; $2 }; };
eos = { type = "tait"; };
effects = { continuity = { }; pressure = { }; artificial-viscosity = { }; density-diffusion = { }; };
S
}

# highest RUN: y of the highest particle of a solid at the start
highest() {
    awk -F, '!/^[#x]/ && $8 == 1 && $2 > m { m = $2 } END { print m + 0 }' "$out/$1/snapshots/0000.csv"
}

tank still 'rim = 0.25;' 0.4
well still "$out/still.scene" output.snapshots=2
quiet still
claim 'still water stays below its rim' "$(number still escaped) == 0"
claim 'walls end at the rim' "$(highest still) < 0.25 && $(highest still) > 0.24"
tank full 'rim = 0.15;' 0.4
well full "$out/full.scene" output.snapshots=2
prints full 'water may spill: it can rise up to 0.2 m, and the sides of wall.tank end at rim = 0.15 m'
brief || claim 'water above the rim spills' "$(number full escaped) > 10"

tank dam 'rim = 0.3;' 0.1
well dam "$out/dam.scene"
prints dam 'water may spill: it can rise up to 0.6 m'
tank low '' 0.1 0.3
well low "$out/low.scene"
brief || claim 'what rises above the walls and falls back is not lost' \
    "$(number dam escaped) < $(number low escaped)"

tank top 'rim = 0.8;' 0.1
tank open '' 0.1
well top "$out/top.scene"
quiet top
well open "$out/open.scene"
if [ "$(hash top)" = "$(hash open)" ]; then good 'a rim at the top is none'
else wrong 'a rim at the top is none'; fi

go wrong "$out/dam.scene" wall.tank.rim=0.9
claim 'a rim above the domain: refused' "$code == 2"
prints wrong 'wall.tank.rim = 0.9 m lies outside the domain'
go box "$out/dam.scene" wall.post='{ type = "box"; from = [0.3, 0.0]; to = [0.35, 0.1]; rim = 0.1; }'
claim 'a rim of a box: refused' "$code == 2"
prints box 'wall.post.rim is for walls of type "frame"'
finish
