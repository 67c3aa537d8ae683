#!/bin/sh
# resume.sh -- a run that goes on from a checkpoint ends with the bits, tables and fields of one
# that was never interrupted: every shipped scene, each family of methods, in 2D and 3D.
#
# Each run has checkpoints at its start, after six tenths, and at its end.  In a copy of its
# directory the last one is taken away: so it looks as if the run had been killed late, with
# rows behind the checkpoint; then it goes on.
. "${top_srcdir:-.}/tests/lib.sh"
scenes=$top_srcdir/data/scenes
flat=$top_srcdir/tests/scenes/small-2d.scene
deep=$top_srcdir/tests/scenes/small-3d.scene

# report DIRECTORY: run.json without what clocks say, and without warnings: that the last
# checkpoint was damaged is one
report() {
    sed '/"warnings": \[$/,/^  \]/d; /"warnings"/d' "$1/run.json" |
        grep -v '"cpu_s"\|"wall_s"\|"threads_mean"\|"peak_rss_kb"'
}

# alike WORDS ONE OTHER: all their files, but for checkpoints and clocks
alike() {
    report "$2" >"$out/one"
    report "$3" >"$out/other"
    if diff -r -q -x run.json -x 'checkpoint*.h5' "$2" "$3" >"$out/differ" 2>&1 &&
        diff "$out/one" "$out/other" >>"$out/differ"; then good "$1"
    else wrong "$1"; sed 's/^/    /' "$out/differ"; fi
}

# again WORDS FILE UNTIL KEY=VALUE...
again() {
    words=$1 file=$2 until=$3
    shift 3
    rm -rf "$out/whole" "$out/parts"
    at=$(awk -v t="$until" 'BEGIN { print 0.6 * t }')
    code=0
    "$STIFFWATER" run "$file" -q until="$until" output.checkpoint="$at" -o "$out/whole" "$@" \
        >"$out/said" 2>&1 || code=$?
    [ $code = 0 ] && cp -r "$out/whole" "$out/parts" && rm "$out/parts/checkpoint.h5" &&
        "$STIFFWATER" resume "$out/parts" -q >"$out/said" 2>&1 || code=$?
    if [ $code = 0 ]; then alike "$words" "$out/whole" "$out/parts"
    else wrong "$words: exit status $code"; cat "$out/said"; fi
}

# --- scenes ---------------------------------------------------------------------------------
# ship SCENE UNTIL KEY=VALUE...
ship() {
    name=$1
    shift
    shown="$shown $name"
    again "$name" "$scenes/$name.scene" "$@"
}

near='domain.from=[-1,0,0] fluid.water.from=[-1,0,0]' # a flume of 1 m of water instead of 3.5 m
shown=
ship dam-break 0.05
ship still-water 0.05
ship toth-beam 0.02
ship dam-break-3d 0.02 spacing=0.0555
ship beam-alone 0.01
ship elastica 0.1
ship soft-gate 0.03
ship toth-dam-break 0.01 spacing=5e-3
ship toth-pcisph 0.02 spacing=5e-3
ship toth-fsi 0.16 spacing=5e-3
ship light-plate 0.02
ship closed-tank 0.05
ship floating-box 0.05
ship block-stack 0.3
ship block-heap 0.3
ship rolling-disc 0.3
ship floating-disc 0.03
ship floating-wedge 0.03
ship floating-boat 0.01 spacing=3.3333333333333333e-2
ship moored-box 0.05
ship box-in-waves 0.05 spacing=0.025
ship pendulum-gate 0.05
ship sinking-block 0.01
ship rising-block 0.004 spacing=0.004 'domain.to=[0.12,0.112,0.06]' 'fluid.water.to=[0.12,0.112,0.036]'
ship seed-003-blocks 0.02
if [ -n "${STIFFWATER_LONG-}" ]; then
    ship flood-one-cube 0.01 spacing=0.05 $near
    ship flood-three-cubes 0.01 spacing=0.05 $near
else shown="$shown flood-one-cube flood-three-cubes"; fi # of which six cubes have all
ship flood-six-cubes 0.01 spacing=0.05 $near
ship toth-standard-sph 0.003 spacing=5e-3
ship tank-sizes 0.01
ship gate 0.02 spacing=0.01
ship sloshing-tank 0.05 spacing=0.02
ship mps-dam-break 0.03 spacing=7.3e-3
ship wave-maker 0.1 spacing=0.03
ship taylor-green 0.03
ship poiseuille 0.02
ship couette 0.02
ship oscillating-drop 0.02
ship elliptic-drop 1e-4
ship rotating-square 0.03
ship standing-wave 0.05 spacing=0.05
ship driven-cavity 0.02 spacing=0.04 'wall.lid.from=[-0.12,1]' 'wall.lid.to=[1.12,1.12]'
ship elastic-obstacle 0.03
ship clustering 0.003 spacing=4e-3 particle_mass=0.0176
shown="$shown toth-dam-break-literal" # is there to fail, in its first steps
for file in "$scenes"/*.scene; do
    case "$shown " in
    *" $(basename "$file" .scene) "*) ;;
    *) wrong "no run of $(basename "$file") goes on" ;;
    esac
done

# --- methods --------------------------------------------------------------------------------
for method in imex3 imex4 mri bdf dv staggered leapfrog@0.2 euler-cfl ab3 cks43 opt64 \
    ARKODE_ZONNEVELD_5_3_4 imex3@2e-4s; do
    again "$method" "$flat" 0.01 method="$method" beam.plate.E=1e5
done
for method in adams gsl-rkf45 gsl-rk8pd gsl-msadams leapfrog cks43 bs54 euler-cfl; do
    again "$method in 3D" "$deep" 0.01 method="$method"
done
again 'pcisph in 3D' "$deep" 0.02 method=pcisph walls=own-density
again 'mri with contact walls' "$flat" 0.01 method=mri walls=contact
again 'implicit viscosity with a beam' "$flat" 0.01 effects.laminar-viscosity.mu=5 \
    effects.laminar-viscosity.side=implicit
again 'implicit viscosity in 3D' "$deep" 0.01 effects.laminar-viscosity.mu=5 \
    effects.laminar-viscosity.side=implicit
again 'an elastica in water' "$flat" 0.02 beam.plate.theory=elastica beam.plate.E=1e6
again 'running means' "$flat" 0.02 probe.bed.window=6e-3 'probe.bed.to=[0.05,0.05]' \
    probe.bed.profile=true
again 'pressure ahead in 3D' "$deep" 0.02 eos.type=look-ahead walls=own-density
again 'pressure ahead between contact walls in 3D' "$deep" 0.02 eos.type=look-ahead
again 'pressure ahead beside a wall that moves' "$scenes/gate.scene" 0.12 spacing=0.01 \
    eos.type=look-ahead
again 'pressure ahead with a beam' "$flat" 0.02 eos.type=look-ahead walls=own-density
again 'pressure ahead with a beam between contact walls' "$flat" 0.02 eos.type=look-ahead \
    beam.plate.response=predicted
again 'pressure ahead without tension' "$flat" 0.02 eos.type=look-ahead eos.tension=false \
    walls=own-density
again 'filtered densities' "$flat" 0.02 effects.shepard-filter.steps=5
again 'filtered densities in 3D' "$deep" 0.02 effects.shepard-filter.steps=5
again 'pairs in single precision' "$flat" 0.02 precision=single
again 'pairs in single precision, in 3D' "$deep" 0.02 precision=single
again 'a box that sinks and stops' "$top_srcdir/tests/scenes/floating-box.scene" 0.2 body.it.density=1500.0 \
    body.it.angle=3.0 'body.it.stops=["bottom","left"]'
again 'bodies with joints, driven, on springs' "$top_srcdir/tests/scenes/driven-flap.scene" 0.1
again 'a block that steps by itself' "$top_srcdir/tests/scenes/block-falls.scene" 0.3 method=mri-rigid \
    body.block.softness=0.003
again 'mps in 3D' "$deep" 0.02 method=mps walls=own-density
again 'a contact potential' "$flat" 0.01 walls=potential beam.plate=off effects.contact-potential=on \
    effects.pressure=off effects.density-diffusion=off
again 'pressure ahead in single precision' "$flat" 0.01 eos.type=look-ahead walls=own-density \
    precision=single
again 'particles that shift' "$flat" 0.01 effects.particle-shifting=on
float=$top_srcdir/tests/scenes/floating-box.scene
again 'a polygon with a dent' "$float" 0.2 body.it.shape=polygon body.it.size=off body.it.density=1500.0 \
    'body.it.points=[[-0.05,-0.03],[0.05,-0.03],[0.05,0.03],[0,0],[-0.05,0.03]]' 'body.it.stops=["bottom"]'
cube=$top_srcdir/tests/scenes/falling-cube.scene
again 'a cylinder that falls' "$cube" 0.2 body.it.shape=cylinder body.it.size=off body.it.radius=0.05 \
    body.it.height=0.08
again 'a hull that falls' "$cube" 0.2 body.it.shape=hull body.it.size=off \
    'body.it.points=[[-0.05,-0.05,-0.04],[0.05,-0.05,-0.04],[0,0.05,-0.04],[0,0,0.06]]'
again 'pcisph with a beam' "$flat" 0.02 method=pcisph walls=own-density

# --- twice, and longer ----------------------------------------------------------------------
# A run to 0.03 s in three parts: of which the second is killed late, the third goes further.
for until in 0.03 0.02; do
    "$STIFFWATER" run "$flat" -q until=$until output.checkpoint=0.01 -o "$out/to-$until"
done
claim 'the shorter run has another end' \
    "\"$(hash to-0.02)\" != \"$(hash to-0.03)\" && \"$(hash to-0.02)\" != \"\""
rm "$out/to-0.02/checkpoint.h5"
"$STIFFWATER" resume "$out/to-0.02" -q 2>"$out/said"
"$STIFFWATER" resume "$out/to-0.02" until=0.03 -q -n 1
claim 'a run that was made longer' "\"$(hash to-0.02)\" == \"$(hash to-0.03)\""
for table in book front forces beam probes; do
    if cmp -s "$out/to-0.02/$table.csv" "$out/to-0.03/$table.csv"; then good "$table.csv"
    else wrong "$table.csv of a run that was made longer"; fi
done

finish
