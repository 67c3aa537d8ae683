#!/bin/sh
# starts.sh -- starts that are wrong or strange: a clear error (status 2, the line, nothing
# written), a warning, or an answer that is written down here.
#
# Mistakes of keys and types, fluid in fluid, walls, beams and outside: tests/scene-errors.sh.
. "$top_srcdir/tests/lib.sh"
tank=$top_srcdir/tests/hard/tank.scene

# add NAME GROUP TEXT: the tank with an object more
add() {
    if grep -q "^$2 = {" "$tank"; then sed "s/^$2 = {/& $3/" "$tank" >"$out/$1.scene"
    else { cat "$tank"; echo "$2 = { $3 };"; } >"$out/$1.scene"; fi
}

# refused NAME WORDS...: status 2, says so, leaves nothing
refused() {
    go "$1" "$out/$1.scene"
    claim "$1 is refused" "$code == 2"
    prints "$@"
    [ ! -e "$out/$1" ] || wrong "$1 leaves nothing"
}

# --- refused ---------------------------------------------------------------------------
add twins fluid 'twin = { type = "box"; from = [0.0, 0.0]; to = [0.1, 0.2]; };'
refused twins 'fluid.twin overlaps fluid.column' '0 m apart' twins.scene:8
add point fluid 'twin = { type = "box"; from = [0.05, 0.1]; to = [0.06, 0.11]; };'
refused point 'fluid.twin overlaps fluid.column' '0.7 spacings (0.007 m) is too near'
add sunk wall 'post = { type = "box"; from = [0.0, -0.02]; to = [0.08, 0.2]; };'
refused sunk 'fluid.column lies more than half in solids: they take 160 of its 200 sites' \
    'wall.post (' 'takes 80 %' sunk.scene:8
add drowned wall 'post = { type = "box"; from = [-0.02, -0.02]; to = [0.123, 0.22]; };'
refused drowned 'fluid.column lies wholly in solids' 'wall.post (' 'takes 100 %'
beam='length = 0.1; thickness = 4e-3; E = 1e8; mass = 0.1;'
add rooted beam "plate = { at = [0.25, -0.03]; $beam };"
refused rooted 'beam.plate overlaps wall.tank' rooted.scene:17
add flat-wall wall 'post = { type = "box"; from = [0.2, 0.0]; to = [0.2, 0.1]; };'
refused flat-wall wall.post 'to must lie beyond from' flat-wall.scene:9
add flat-fluid fluid 'drop = { type = "disc"; centre = [0.3, 0.3]; radius = 0.0; };'
refused flat-fluid fluid.drop 'above 0'
add line wall 'post = { type = "polygon"; points = [[0.2, 0], [0.25, 0.1], [0.3, 0.2]]; };'
refused line wall.post 'no area'
post='type = "box"; from = [0.2, 0.0]; to = [0.23, 0.1];'
add late wall "post = { $post path = [[0, 0], [0, 1]]; direction = [1, 0]; };"
refused late 'wall.post.path: time 0 s of pair 2' 'put them in order'
add pathless wall "post = { $post path = [[0, 0], [1, 1]]; };"
refused pathless 'needs a direction'
add single wall "post = { $post path = [[0, 0]]; direction = [1, 0]; };"
refused single 'two at least'
add backwards wall "post = { $post velocity = [1, 0]; start = 2; stop = 1; };"
refused backwards 'does not lie after start'
add aimless fluid \
    'drop = { type = "disc"; centre = [0.3, 0.3]; radius = 0.03; flow = "rotation"; };'
refused aimless 'needs flow_rate'
add weightless fluid ''
sed -i 's/^gravity.*/gravity = [0, 0];/' "$out/weightless.scene"
refused weightless 'eos.c0 is needed'
for number in nan inf -inf 1e999; do
    go number "$tank" "gravity=[0,$number]"
    claim "gravity = [0, $number] is refused" "$code == 2"
    prints number 'command line' gravity
    go number "$tank" "eos.rho0=$number"
    claim "eos.rho0 = $number is refused" "$code == 2"
done

# --- allowed, with a warning -----------------------------------------------------------
add away beam "plate = { at = [0.6, 0.1]; $beam };"
go away "$out/away.scene" until=0.01
claim 'a beam outside the tank runs' "$code == 0"
prints away 'beam.plate reaches out of the domain'
add probes probe 'gauge = { at = [5, 5]; }; level = { at = [5, 0]; what = "height"; };
    speed = { at = [0.5, 0.1]; what = "velocity"; };'
go probes "$out/probes.scene" until=0.05
claim 'probes outside the tank run' "$code == 0"
prints probes 'probe.gauge lies outside' 'probe.level lies outside' 'probe.speed lies outside'
for name in gauge level speed; do
    claim 'and read 0' "$(most probes probes $name) == 0"
done

# Keys that do nothing, and no harm.
idle() {
    name=$1
    words=$2
    shift 2
    go "$name" "$out/$name.scene" until=0.01 "$@"
    claim "$name runs" "$code == 0"
    prints "$name" "$words"
}
add frameless fluid ''
sed -i 's/^wall = .*/wall = { };/; s/to = \[0.4, 0.4\]/& ; lid = false; open = ["left"]/' "$out/frameless.scene"
idle frameless 'frameless.scene:7: domain.open is about walls of type "frame"'
prints frameless 'domain.lid is about'
idle frameless 'walls = "adami" does nothing, as the scene has no solids' walls=adami
add narrow beam "plate = { at = [0.25, 0.0]; $beam nu = 0.45; };"
idle narrow 'narrow.scene:17: beam.plate.nu counts with plane = "strain" only'
add inviscid fluid ''
sed -i '/artificial-viscosity/d' "$out/inviscid.scene"
idle inviscid 'kernel.viscosity does nothing here' kernel.viscosity=viscosity-log
add plain fluid ''
idle plain 'substep is for the methods staggered and mri' substep=1e-3
idle plain 'mps.gamma does nothing without method = "mps"' mps.gamma=0.2
idle plain 'mps.bundle does nothing without' mps.bundle=enhanced method=leapfrog
idle plain 'pcisph.limit does nothing without method = "pcisph"' pcisph.limit=0.02
idle plain 'tol = 1e-05 does nothing with leapfrog' method=leapfrog tol=1e-5
idle plain 'tol = 1e-05 does nothing with steps of a constant length' method=cks43@5e-4s tol=1e-5
go plain "$out/plain.scene" until=0.01 tol=1e-5
quiet plain

# --- allowed, with an answer -----------------------------------------------------------
# The column makes room for what stands in it, on its lattice or not.
# carved NAME SITES SOLID: so many sites are left to it, the run and run.json say so
carved() {
    well "$1" "$out/$1.scene" until=0.02 output.interval=0.02
    claim "$1: $2 sites are left to it" "$(number "$1" carved) == $2 && $(number "$1" fluid) == 200 - $2"
    claim "$1: none is in a solid" "$(number "$1" in_solids_max) == 0"
    "$STIFFWATER" check "$out/$1.scene" >"$out/$1.said"
    prints "$1" "fluid.column makes room: $2 of its 200 sites are left to solids, most of them to $3"
}
add post wall 'post = { type = "box"; from = [0.05, 0.0]; to = [0.08, 0.1]; };'
carved post 30 wall.post
add shifted wall 'post = { type = "box"; from = [0.0537, 0.0]; to = [0.0837, 0.1013]; };'
carved shifted 40 wall.post
add plate beam "plate = { at = [0.05, 0.0]; $beam layers = 2; };"
carved plate 20 beam.plate
add air fluid ''
sed -i 's/from = \[0.0, 0.0\]; to = \[0.1, 0.2\]/from = [0.15, 0.15]; to = [0.25, 0.35]/' "$out/air.scene"
go air "$out/air.scene" until=0.15 output.interval=0.15
# It rings with the sound that its "hydrostatic" density sends through it, no more.
claim 'a column in the air falls freely, to 1e-3' \
    "sqrt(($(last air book kinetic) / (0.5 * 20 * (9.81 * 0.15) ^ 2) - 1) ^ 2) < 1e-3"
claim 'and straight' "$(last air book momentum_y) < -20 * 9.81 * 0.15 * (1 - 1e-9) && \
    $(most air book momentum_x) < 1e-9"
go still "$tank" 'gravity=[0,0]' eos.c0=20 until=0.1
quiet still
claim 'without gravity nothing moves, to 1 mm/s' "$code == 0 && $(most still book kinetic) < 1e-5"
go still "$tank" 'gravity=[0,0]' eos.c0=20 until=0.1 walls=own-density
claim 'or at all' "$code == 0 && $(most still book kinetic) < 1e-20"
add one fluid ''
sed -i 's/from = \[0.0, 0.0\]; to = \[0.1, 0.2\]/from = [0.2, 0.3]; to = [0.21, 0.31]/' "$out/one.scene"
go one "$out/one.scene" eos.c0=20 until=0.2
quiet one
claim 'one particle alone falls' "$code == 0 && sqrt(($(last one book momentum_y) / \
    (-0.1 * 9.81 * 0.2) - 1) ^ 2) < 1e-9"
go one "$out/one.scene" eos.c0=20 until=1
claim 'and bounces in the tank, which does not brake it' \
    "$code == 0 && $(number one escaped) == 0 && $(number one energy_defect_max) < 2e-3 * $(number one energy_initial)"

go plain "$tank" until=0.1
box='type = "box"; from = [0.3, 0.2]; to = [0.35, 0.25];'
add into wall "block = { $box velocity = [1.0, 0.0]; };"
add out wall "block = { $box velocity = [100.0, 0.0]; };"
add lifted wall "block = { $box path = [[0, 0], [0.05, 3]]; direction = [0, 1]; };"
# The end of a path is an event, at which the method starts anew.
for name in into out lifted; do
    go $name "$out/$name.scene" until=0.1
    claim "a wall that moves through walls ($name) changes nothing for the water" \
        "$code == 0 && sqrt(($(last $name book kinetic) / $(last plain book kinetic) - 1) ^ 2) < 1e-5"
done
add press wall 'piston = { type = "box"; from = [0.1, 0.0]; to = [0.15, 0.4]; velocity = [-1.0, 0.0]; };'
go press "$out/press.scene" eos.c0=20
claim 'a piston that presses the water into nothing ends badly' \
    "$code == 1 || $(number press escaped) > 0"
prints press density
finish
