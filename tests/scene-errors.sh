#!/bin/sh
# scene-errors.sh -- every kind of mistake in a scene is refused with status 2 and a
# message that says where, what and what would be right; and nothing is written.
#
# Each mistake is one edit (by sed) of a good scene of tests/scenes.  Run by `make check`.
scenes=${top_srcdir:-.}/tests/scenes
. "${top_srcdir:-.}/tests/lib.sh"
asking
mkdir empty && cd empty || exit 99

# judge NAME PATTERN ...: what `command' in $status, ../said and this directory left.
judge()
{
    name=$1
    shift
    tried=$((tried + 1))
    [ "$status" = 2 ] || complain "$name: exit status $status instead of 2"
    for pattern in "$@"; do
        grep -q -F -e "$pattern" ../said || complain "$name: the message lacks \"$pattern\""
    done
    [ "$(wc -l <../said)" -le 3 ] || complain "$name: the message is longer than three lines"
    [ -z "$(ls -A)" ] || { complain "$name: something was written"; rm -rf ./*; }
}

# bad BASE NAME EDIT PATTERN ...
bad()
{
    sed -e "$3" "$scenes/$1.scene" >../bad.scene
    cmp -s ../bad.scene "$scenes/$1.scene" && { echo "$script: $2: no edit"; exit 99; }
    "$STIFFWATER" run ../bad.scene -o out >../said 2>&1
    status=$?
    shift 1
    name=$1
    shift 2
    judge "$name" "$@"
}

# bad_key NAME OVERRIDE PATTERN ...: a mistake on the command line.
bad_key()
{
    "$STIFFWATER" run "$scenes/small-2d.scene" "$2" -o out >../said 2>&1
    status=$?
    name=$1
    shift 2
    judge "$name" "$@"
}

# The good scenes are good, or nothing below means anything.
for base in small-2d small-3d; do
    "$STIFFWATER" check "$scenes/$base.scene" >../said 2>&1 || complain "$base.scene is refused"
done
[ -z "$(ls -A)" ] || complain "check writes something"

bad_key 'a word that is no precision' 'precision="half"' precision double single

bad small-2d 'masses too small for single precision' \
    's/^until = /precision = "single"; particle_mass = 1e-16; until = /' \
    bad.scene 1e-32 'precision = "double"'

# --- joints, motion and springs of rigid bodies
bad driven-flap 'a hinge and a slider' 's/bead = {/& hinge = { at = [0.0, 0.0]; };/' \
    body.bead 'a hinge and a slider' 'leave one out'
bad driven-flap 'a direction of no length' 's/along = .1.0, 1.0./along = [0.0, 0.0]/' \
    body.bead.slider 'along has length 0' 'along = [0, 1]'
bad driven-flap 'a velocity across a slider' 's/bead = {/& velocity = [1.0, 0.0];/' \
    body.bead 'velocity leaves the line' along
bad driven-flap 'a turn on a slider' 's/bead = {/& spin = 1.0;/' body.bead 'leave spin out'
bad driven-flap 'a velocity beside a hinge' 's/flap = {/& velocity = [1.0, 0.0];/' body.flap 'set spin'
bad driven-flap 'an axis in the plane' 's/hinge = {/& axis = [1.0, 0.0];/' body.flap.hinge 'leave axis out'
bad driven-flap 'held beside a motion' 's/plunger = {/& held = ["x"];/' body.plunger 'leave it out'
bad driven-flap 'a velocity beside a motion' 's/plunger = {/& velocity = [1.0, 0.0];/' \
    body.plunger motion.velocity
bad driven-flap 'a speed that jumps' 's/ .0.05, 0.0.,//' body.plunger.motion 'jumps by' 'phase = -90'
bad driven-flap 'a motion that does not begin at 0' 's/.0.0, 0.0., .0.05, 0.0./[0.0, 0.1], [0.05, 0.1]/' \
    body.plunger.motion 'must be 0 at t = 0'
bad driven-flap 'a motion of nothing' 's/motion = { direction.*/motion = { }; };/' \
    body.plunger.motion 'nothing moves it'
bad driven-flap 'an unknown key of a motion' 's/phase = -90/phse = -90/' body.flap.motion.phase
bad driven-flap 'a spring of nothing' 's/stiffness = 100.0/stiffness = 0.0/' body.flap.spring.line \
    'neither stiffness nor damping'
bad driven-flap 'a rest length without stiffness' 's/stiffness = 100.0/damping = 1.0; rest = 0.1/' \
    body.flap.spring.line 'a rest length does nothing without stiffness'
bad driven-flap 'a spring without a direction' 's/to = .0.3, 0.0.;/to = [0.3, 0.2]; rest = 0.1;/' \
    body.flap.spring.line 'one point' 'rest = 0'
bad driven-flap 'a spring without a name' 's/spring = { line = \(.*\); }; };/spring = \1; };/' \
    bad.scene 'named groups are expected here'
bad driven-flap 'a spring that is a number' 's/spring = { line = .*/spring = 3; };/' body.flap.spring

# unknown keys, level by level, with the nearest known one
bad small-2d 'key at the top' 's/^until =/untl =/' bad.scene:6 untl until
bad small-2d 'group at the top' 's/^effects =/efects =/' bad.scene:21 efects effects
bad small-2d 'key of domain' 's/to = \[0.2, 0.1\]/too = [0.2, 0.1]/' bad.scene:8 domain.too to
bad small-2d 'key of kernel' 's/support = 3.0/suport = 3.0/' bad.scene:9 kernel.suport support
bad small-2d 'key of eos' 's/rho0 = 1000.0/rho = 1000.0/' bad.scene:10 eos.rho rho0
bad small-2d 'key of a fluid' 's/dye = 1/die = 1/' bad.scene:13 fluid.right.die dye
bad small-2d 'key of a wall' 's/tank = { type/tank = { slipp = true; type/' bad.scene:16 \
    wall.tank.slipp slip
bad small-2d 'key of a beam' 's/thickness =/thicknes =/' bad.scene:19 beam.plate.thicknes thickness
bad small-2d 'effect' 's/pressure = { }/presure = { }/' bad.scene:23 effects.presure pressure
bad small-2d 'key of an effect' 's/alpha = 0.05/alfa = 0.05/' bad.scene:24 \
    effects.artificial-viscosity.alfa alpha
bad small-2d 'key of an effect that has none' 's/pressure = { }/pressure = { alpha = 1.0; }/' \
    bad.scene:23 effects.pressure.alpha
bad small-2d 'key of a probe' 's/what = "pressure"/wat = "pressure"/' bad.scene:28 probe.bed.wat what
bad small-2d 'key of output' 's/interval = 1e-3/intervall = 1e-3/' bad.scene:30 output.intervall \
    interval

# wrong types
bad small-2d 'text for a number' 's/until = 0.02/until = "soon"/' bad.scene:6 until soon number
bad small-2d 'number for a vector' 's/^gravity = .*/gravity = -9.81;/' bad.scene:5 gravity -9.81
bad small-2d 'vector of three in 2D' 's/^gravity = .*/gravity = [0.0, 0.0, -9.81];/' bad.scene:5 \
    gravity 2 3
bad small-2d 'number for a flag' 's/tank = { type/tank = { slip = 3; type/' bad.scene:16 \
    wall.tank.slip true
bad small-2d 'group for a number' 's/^spacing = .*/spacing = { };/' bad.scene:7 spacing
bad small-2d 'number for an effect' 's/pressure = { }/pressure = true/' bad.scene:23 \
    effects.pressure
bad small-2d 'value for an object' 's/tank = { type = "frame"; }/tank = 3.0/' bad.scene:16 wall.tank
bad small-2d 'value for a kind' 's/^domain = .*/domain = 3.0;/' bad.scene:8 domain
bad small-2d 'half an integer' 's/dye = 1/dye = 1.5/' bad.scene:13 fluid.right.dye 1.5

# out of range
bad small-2d 'negative time' 's/until = 0.02/until = -1.0/' bad.scene:6 until -1
bad small-2d 'no spacing at all' 's/spacing = 5e-3/spacing = 0.0/' bad.scene:7 spacing 0
bad small-2d 'support' 's/support = 3.0/support = 0.5/' bad.scene:9 kernel.support 0.5 1.2
bad small-2d 'alpha' 's/alpha = 0.05/alpha = -0.1/' bad.scene:24 effects.artificial-viscosity.alpha \
    -0.1
bad small-2d 'dye' 's/dye = 1/dye = 8/' bad.scene:13 fluid.right.dye 8 7
bad small-2d 'E' 's/E = 1e8/E = 0.0/' bad.scene:19 beam.plate.E Pa
bad small-2d 'not a number' 's/until = 0.02/until = nan/' bad.scene:6

# missing
bad small-2d 'no until' '/^until/d' bad.scene until
bad small-2d 'no spacing' '/^spacing/d' bad.scene spacing
bad small-2d 'no domain' '/^domain/d' bad.scene domain.from 'needed'
bad small-2d 'no E' 's/E = 1e8; //' bad.scene beam.plate E
bad small-2d 'beam without mass' 's/density = 1200.0; //' bad.scene:19 beam.plate density mass
bad small-2d 'nothing that moves' '/^fluid = {/,/^};/d;/^beam = {/,/^};/d;/^probe/,/^};/d' \
    bad.scene fluid
bad small-2d 'no sound without gravity' 's/^gravity.*/gravity = [0.0, 0.0];/' bad.scene eos.c0 \
    gravity
bad small-2d 'pressure without density' '/continuity/d' bad.scene density effects.continuity

# words that no table knows
bad small-2d 'method' 's/^until/method = "erk44"; until/' erk44 erk4
bad small-2d 'kernel' 's/"wendland-c2"/"wendland-c3"/' bad.scene:9 wendland-c3 wendland-c2
bad small-2d 'wall model' 's/^until/walls = "adamy"; until/' bad.scene:6 walls adamy adami \
    own-density
bad small-2d 'kernel of a use' 's/type = "wendland-c2"/density = "poly7"/' bad.scene:9 \
    kernel.density poly7 poly6
bad small-2d 'equation of state' 's/"tait"/"tate"/' bad.scene:10 tate tait
bad small-2d 'shape' 's/type = "box"; from = \[0.05/type = "bocks"; from = [0.05/' bad.scene:13 \
    bocks box
bad small-2d 'dimension' 's/^dimension = 2/dimension = 4/' bad.scene:4 dimension 4 3
bad small-3d 'dimension 3 on paper only' 's/^dimension = 3/dimension = 2/' bad.scene

# geometry
bad small-2d 'overlapping fluids' 's/to = \[0.05, 0.06\]/to = [0.06, 0.06]/' fluid.left \
    fluid.right bad.scene:12 bad.scene:13
bad small-2d 'fluid in a wall' \
    's/tank = { type = "frame"; };/& sill = { type = "box"; from = [0.06, 0.0]; to = [0.12, 0.06]; };/' \
    fluid.right wall.sill bad.scene:16 bad.scene:13
bad small-2d 'fluid outside the domain' 's/to = \[0.1, 0.06\]/to = [0.1, 0.12]/' bad.scene:13 \
    fluid.right domain
bad small-2d 'fluid that is a frame' 's/right = { type = "box"; .*dye/right = { type = "frame"; dye/' \
    bad.scene:13 fluid.right 'for walls'
bad small-2d 'beam in a wall' 's/at = \[0.14, 0.0\]/at = [0.14, -0.01]/' beam.plate wall.tank
bad small-2d 'empty fluid' 's/right = { type = "box"; from = \[0.05, 0.0\]; to = \[0.1, 0.06\]/right = { type = "disc"; centre = [0.0725, 0.05]; radius = 1e-3/' \
    bad.scene:13 fluid.right
bad small-2d 'box inside out' 's/to = \[0.1, 0.06\]/to = [0.04, 0.06]/' bad.scene:13 fluid.right
bad small-2d 'spacing that does not fit' 's/^spacing = .*/spacing = 7e-3;/' fluid.left spacing
bad small-2d 'too many particles' 's/^spacing = .*/spacing = 1e-8;/' particles spacing
bad small-2d 'domain inside out' 's/to = \[0.2, 0.1\]/to = [-0.2, 0.1]/' bad.scene:8 domain.to -0.2

# physics that does not go together
bad small-2d 'ghost walls beside continuity' 's/^until/walls = "ghost"; until/' bad.scene \
    '"ghost"' effects.continuity 'set walls = "contact" or "own-density" or "adami"'
bad small-2d 'density of their own beside summation' \
    's/continuity = { }/summation = { }/;/density-diffusion/d' bad.scene '"contact"' \
    effects.summation 'set walls = "adami" or "ghost"'
bad small-2d 'two densities' 's/continuity = { };/& summation = { };/' bad.scene \
    effects.summation effects.continuity 'leave one'
bad small-2d 'diffusion of a sum' 's/continuity = { }/summation = { }/;s/^until/walls = "ghost"; until/' \
    bad.scene effects.density-diffusion effects.continuity
bad small-2d 'pressure twice' 's/pressure = { };/& pressure-printed = { };/' bad.scene \
    effects.pressure-printed effects.pressure 'leave one'
bad small-2d 'viscosity twice' \
    's/continuity = { };/& laplacian-viscosity = { }; viscosity-printed = { };/;s/type = "wendland-c2"/viscosity = "viscosity-log"/' \
    bad.scene effects.viscosity-printed effects.laplacian-viscosity 'leave one'
bad small-2d 'Laplacian that changes its sign' 's/continuity = { };/& laplacian-viscosity = { };/' \
    bad.scene effects.laplacian-viscosity wendland-c2 'kernel.viscosity = "viscosity-log"'
bad small-2d 'printed Laplacian with another kernel' \
    's/continuity = { };/& viscosity-printed = { };/;s/type = "wendland-c2"/viscosity = "spiky"/' \
    bad.scene effects.viscosity-printed spiky kernel.viscosity
bad small-2d 'sum with a kernel without a value at 0' \
    's/continuity = { }/summation = { }/;/density-diffusion/d;s/^until/walls = "ghost"; until/;s/type = "wendland-c2"/density = "viscosity-log"/' \
    bad.scene effects.summation viscosity-log kernel.density
bad small-2d 'walls that sum with such a kernel' \
    's/^until/walls = "adami"; until/;s/type = "wendland-c2"/type = "viscosity-log"/' \
    bad.scene walls viscosity-log kernel.density
bad small-3d 'printed viscosity in 3D' \
    's/continuity = { };/& viscosity-printed = { };/;s/support/viscosity = "viscosity-log"; &/' \
    effects.viscosity-printed 'two dimensions' laplacian-viscosity
bad small-2d 'k and c0' 's/type = "tait";/type = "linear"; k = 100.0; c0 = 20.0;/' bad.scene:10 \
    'k = 100' 'c0 = 20' 'leave one'
bad small-2d 'k of another equation of state' 's/rho0 = 1000.0/k = 1e4/' bad.scene:10 eos.k
bad small-2d 'gamma of a straight line' 's/type = "tait";/type = "linear"; gamma = 7.0;/' \
    bad.scene:10 eos.gamma
bad small-2d 'negative stiffness' 's/type = "tait";/type = "linear"; k = -1.0;/' bad.scene:10 eos.k -1

# beams
bad small-2d 'beam that nothing holds' 's/density = 1200.0;/& root = "free";/' bad.scene:19 beam.plate \
    free
bad small-2d 'density and mass' 's/density = 1200.0;/& mass = 1.0;/' bad.scene:19 \
    beam.plate density mass
bad small-2d 'thicker than long' 's/thickness = 4e-3/thickness = 0.06/' bad.scene:19 \
    beam.plate thickness length
bad small-3d 'beam in 3D' \
    's/^wall =/beam = { b = { at = [0.15, 0.05, 0.0]; length = 0.05; thickness = 4e-3; E = 1e8; density = 1200.0; }; };\n&/' \
    bad.scene:10 beam.b dimension

# keys that do nothing without another
gate='type = "box"; from = [0.12, 0.02]; to = [0.13, 0.05];'
idle() { # idle NAME KEYS KEY NEEDS: of a wall
    bad small-2d "$1" "s/tank = { type = \"frame\"; };/&\n gate = { $gate $2 };/" bad.scene:17 \
        "wall.gate.$3 does nothing without $4" "leave $3 out"
}
idle 'amplitude alone' 'amplitude = [0.01, 0.0];' amplitude frequency
idle 'swing alone' 'swing = 5.0;' swing frequency
idle 'frequency alone' 'frequency = 5.0;' frequency 'amplitude or swing'
idle 'phase alone' 'velocity = [1.0, 0.0]; phase = 90.0;' phase frequency
idle 'direction alone' 'direction = [0.0, 1.0];' direction path
idle 'pivot of a wall that does not turn' 'velocity = [1.0, 0.0]; pivot = [0.1, 0.0];' pivot \
    'spin or swing or turn'
idle 'start of nothing' 'start = 1.0;' start 'velocity or amplitude or path or spin or swing or turn'
idle 'stop of nothing' 'stop = 1.0;' stop 'velocity or amplitude'
flow() { # flow NAME KEYS KEY: of a fluid
    bad small-2d "$1" "s/dye = 1;/$2/" bad.scene:13 "fluid.right.$3 does nothing" "leave $3 out"
}
flow 'rate of no flow' 'flow_rate = 3.0;' flow_rate
flow 'speed of a rotation' 'flow = "rotation"; flow_rate = 3.0; flow_speed = 1.0;' flow_speed
flow 'size of a shear' 'flow = "shear"; flow_rate = 3.0; flow_size = 1.0;' flow_size
flow 'amplitude of vortices' \
    'flow = "taylor-green"; flow_speed = 1.0; flow_size = 0.1; flow_amplitude = 0.1;' flow_amplitude
flow 'pressure of a rotation' 'flow = "rotation"; flow_rate = 3.0; flow_pressure = 9.0;' flow_pressure
flow 'pressure of a drop without a size' 'flow = "strain"; flow_rate = 3.0; flow_pressure = 9.0;' \
    flow_pressure
flow 'size of a drop without a pressure' 'flow = "strain"; flow_rate = 3.0; flow_size = 0.1;' flow_size
flow 'centre of no flow' 'flow_centre = [0.1, 0.0];' flow_centre
bad small-2d 'surface of a fluid at rest' 's/dye = 1;/initial = "rest"; surface = 0.1;/' bad.scene:13 \
    fluid.right.surface initial
bad small-2d 'follower without a force' 's/density = 1200.0;/& theory = "elastica"; follower = true;/' \
    bad.scene:19 beam.plate.follower 'tip_force or load'
bad small-2d 'bow of a linear beam' 's/density = 1200.0;/& bent = 20.0;/' bad.scene:19 beam.plate bent
bad small-2d 'end of no load' 's/density = 1200.0;/& load_until = 0.1;/' bad.scene:19 beam.plate \
    load_until
bad small-2d 'probe without fluid' '/^fluid = {/,/^};/d;/^effects = {/,/^};/d' bad.scene probe.bed \
    'no fluid'

# probes over areas, panels
at='s/at = \[0.05, 0.015\];/&'
bad small-2d 'area without extent' "$at to = [0.05, 0.015];/" bad.scene:28 probe.bed.to '`at`'
bad small-2d 'disc in 2D' "$at radius = 0.01; normal = [1.0, 0.0];/" bad.scene:28 probe.bed.radius segment
bad small-2d 'normal without a disc' "$at normal = [1.0, 0.0];/" bad.scene:28 probe.bed.normal radius
bad small-2d 'height over an area' "$at to = [0.1, 0.015];/;s/\"pressure\"/\"height\"/" bad.scene:28 \
    probe.bed 'at a point'
bad small-2d 'profile of a point' "$at profile = true;/" bad.scene:28 probe.bed.profile 'to or radius'
bad small-2d 'window below 0' "$at window = -1.0;/" bad.scene:28 probe.bed.window -1
bad small-3d 'area that is no plane' 's/^output/probe = { p = { at = [0.0, 0.0, 0.0]; to = [0.1, 0.1, 0.1]; }; };\n&/' \
    bad.scene probe.p 'all three directions'
bad small-3d 'disc without a normal' 's/^output/probe = { p = { at = [0.0, 0.0, 0.0]; radius = 0.1; }; };\n&/' \
    bad.scene probe.p.normal 'across the'
panel() { printf '%s\n' "s/^output/panel = { p = { $1 }; };\\n&/"; }
bad small-2d 'panel of nothing' "$(panel '')" bad.scene:30 panel.p.of missing
bad small-2d 'panel of what is not there' "$(panel 'of = "tnak";')" bad.scene:30 panel.p tnak tank plate
bad small-2d 'side of what has none' "$(panel 'of = "plate"; side = "left";')" bad.scene:30 panel.p.side \
    plate 'from and to'
bad small-2d 'side that is none' "$(panel 'of = "tank"; side = "back";')" bad.scene:30 panel.p.side back bottom
bad small-2d 'empty panel' "$(panel 'of = "tank"; from = [0.01, 0.01]; to = [0.1, 0.05];')" bad.scene:30 \
    panel.p 'half a spacing behind'
bad small-2d 'key of a panel' "$(panel 'of = "tank"; form = [0.01, 0.01];')" bad.scene:30 panel.p.form from
bad_key 'the same by the command line' 'fluid.right.flow_rate=3' 'command line' fluid.right.flow_rate

# what a pressure that looks ahead does not go with
ahead='s/type = "tait"/type = "look-ahead"/'
bad small-2d 'look-ahead with walls of adami' "$ahead; \$ a\\
walls = \"adami\";" look-ahead 'walls = "contact"'
bad small-2d 'look-ahead with a beam of its own way between walls of contact' "$ahead" look-ahead 'response = "predicted"'

# the command line
bad_key 'override without a key' '=3' '=3'
bad_key 'override of nothing' 'kernel.suport=2' kernel.suport support 'command line'
bad_key 'a misprint of an object' 'fluid.rigth.dye=1' 'the file has right and no rigth' 'a box needs from and to'
bad_key 'override out of range' 'until=-1' until -1 'command line'
bad_key 'override of the wrong type' 'until=soon' until soon 'command line'
bad_key 'override of an unknown body' 'body.mass=3' body 'command line'
bad_key 'override of an object that is not there' 'fluid.middle.dye=1' fluid.middle
bad_key 'a value that the file does not have is off' 'output.checkpoint=off' output.checkpoint 'says nothing of that'
bad_key 'a value that is needed is off' 'beam.plate.E=off' beam.plate.E missing Pa

# files
"$STIFFWATER" run ../there-is-none.scene -o out >../said 2>&1
status=$?
judge 'no such file' there-is-none.scene
"$STIFFWATER" run "$out" -o out >../said 2>&1
status=$?
judge 'a directory' "$out"
printf 'until = 1.0;\nspacing = ;\n' >../bad.scene
"$STIFFWATER" run ../bad.scene -o out >../said 2>&1
status=$?
judge 'syntax' bad.scene:2
: >../bad.scene
"$STIFFWATER" run ../bad.scene -o out >../said 2>&1
status=$?
judge 'empty file' bad.scene empty

[ "$tried" -ge 100 ] || complain "only $tried mistakes are tried"
finish
