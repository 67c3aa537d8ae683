#!/bin/sh
# check-large.sh -- check tells the size of scenes that are too large to be made for a look: of 1e7
# and 1e9 particles, in the memory that the program itself takes; its counts are those that a
# smaller spacing gives by the power law, and those of the particles where both can be had.
. "$top_srcdir/tests/lib.sh"
. "$top_srcdir/tests/mpi.sh"
limit=300000 # [kB]
if grep -q __asan_init "$top_builddir/stiffwater-2d"; then limit=unlimited; fi
scenes=$top_srcdir/data/scenes

# look NAME SCENE KEY=VALUE...: a check with 300 MB of addresses; exit status to $code
look() {
    name=$1
    scene=$2
    shift 2
    code=0
    (ulimit -v $limit; OMP_NUM_THREADS=1 "$STIFFWATER" check "$scene" "$@") \
        >"$out/$name.said" 2>&1 || code=$?
}

# count NAME OBJECT: its particles; all: "particles:"
count() {
    sed -n "s/^ *$2:* *\(about \)*\([0-9.e+]*\).*/\2/p" "$out/$1.said" | head -n 1
}

look small "$scenes/dam-break.scene" spacing=5e-4
claim 'a scene of 90,000 particles is made' "$code == 0 && $(count small particles) == 89636"
for spacing in 4e-5 4e-6; do # 1.26e7 and 1.25e9 particles
    look large "$scenes/dam-break.scene" spacing=$spacing
    fluid="0.05 * 0.2 / $spacing ^ 2"
    if [ $spacing = 4e-5 ]; then claim "$spacing: counted" "$code == 0 || $code == 2"
    else claim "$spacing: refused" "$code == 2"; prints large 'more than this program can number'; fi
    prints large 'counted by their shapes' 'This scene is too large for a look'
    claim "$spacing: left" "($(count large left) / ($fluid) - 1) ^ 2 < 1e-4"
    claim "$spacing: right" "($(count large right) / ($fluid) - 1) ^ 2 < 1e-4"
    claim "$spacing: all, and less than a hundredth for the walls" \
        "($(count large particles) / (2 * $fluid) - 1.005) ^ 2 < 0.008 ^ 2"
done

# what a run costs, from fewer particles: right-hand sides as 1/spacing, their time as particles,
# of those that it was measured with
costs() {
    sed -n 's/.*: \([0-9]*\) right-hand sides (smooth flow).* of \([0-9.e+-]*\) ms.*/\1 \2/p
            s/.*from \([0-9]*\) particles at a spacing of [^ ]* m, .* take \([0-9.e+-]*\) ms/\1 \2/p' "$out/$1.said"
}
look fine "$scenes/dam-break.scene" spacing=4e-5
set -- $(costs small) $(costs fine)
[ $# = 6 ] || wrong "costs of a scene that is too large: $(cat "$out/fine.said")"
claim 'right-hand sides as 1/spacing' "($3 / $1 / 12.5 - 1) ^ 2 < 0.02 ^ 2"
claim 'their time as particles' "($4 / $6 / ($(count fine particles) / $5) - 1) ^ 2 < 0.02 ^ 2"
claim 'measured with a tenth of them at most' "$5 < 0.1 * $(count fine particles)"

# a scene that has few particles and takes long to make: 24 CPU s until there was a limit
code=0
(ulimit -t 5; OMP_NUM_THREADS=1 "$STIFFWATER" check "$scenes/flood-six-cubes.scene" \
    spacing=0.0142857142857143) >"$out/slow.said" 2>&1 || code=$?
claim 'within 5 s: a scene that takes long to make' "$code == 0"
claim 'with the size that it has' "($(count slow particles) / 590126 - 1) ^ 2 < 0.02 ^ 2"

# a list of 270,000 points, whose inside takes more than 100 CPU s to find, is refused
awk -v n=270000 'BEGIN { print "dimension = 2; gravity = [0.0, -9.81]; until = 0.01; spacing = 5e-3;"
    print "domain = { from = [0.0, 0.0]; to = [0.4, 0.4]; };"
    print "fluid = { water = { type = \"box\"; from = [0.0, 0.0]; to = [0.4, 0.1]; }; };"
    print "effects = { continuity = { }; pressure = { }; artificial-viscosity = { }; };"
    printf "wall = { tank = { type = \"frame\"; }; roof = { type = \"polygon\"; fill = \"lattice\"; points = ["
    for (i = 0; i < n; i++)
        printf "%s[%.9f, %.9f]", i ? "," : "", 0.2 + 0.05 * cos(6.2831853 * i / n),
            0.3 + 0.05 * sin(6.2831853 * i / n)
    print "]; }; };" }' >"$out/points.scene"
code=0
(ulimit -t 5; OMP_NUM_THREADS=1 "$STIFFWATER" check "$out/points.scene") >"$out/points.said" 2>&1 || code=$?
claim 'within 5 s: a scene that takes long to count' "$code == 2"
prints points 'cannot even be counted within 1 s and 1 GB'

# all that a look holds, where it has most to do
if [ $limit != unlimited ] && command -v python3 >/dev/null; then
    peak=$(OMP_NUM_THREADS=1 python3 -c 'import resource, subprocess, sys
subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)' "$STIFFWATER" check \
        "$scenes/dam-break.scene" spacing=2e-4 walls=adami kernel.support=8)
    claim 'within 1 GB [kB]' "$peak < 1e6"
fi

# programs for many ranks have the same limits
# look_by_ranks N NAME DIM SCENE KEY=VALUE...
look_by_ranks() {
    number=$1 name=$2 program=$top_builddir/stiffwater-${3}d-mpi
    shift 3
    ranks "$number" sh -c 'ulimit -t 5; exec "$@"' sh "$program" check "$@"
    cp "$out/said" "$out/$name.said"
}
if have_ranks; then
    for n in 1 2; do
        look_by_ranks $n ranks 3 "$scenes/flood-six-cubes.scene" spacing=0.0142857142857143
        claim "within 5 s on $n ranks" "$code == 0"
        claim 'with the size that it has' "($(count ranks particles) / 590126 - 1) ^ 2 < 0.02 ^ 2"
        claim 'said once' "$(grep -c '^particles:' "$out/ranks.said") == 1"
    done
    look_by_ranks 2 points 2 "$out/points.scene"
    claim 'on 2 ranks: a scene that takes long to count' "$code == 2"
    prints points 'cannot even be counted within 1 s and 1 GB'
fi

# what fills an area grows by the square, layers by the length
cat >"$out/shapes.scene" <<'S'
dimension = 2; gravity = [0.0, -9.81]; until = 0.01; spacing = 5e-3;
domain = { from = [0.0, 0.0]; to = [0.4, 0.4]; };
fluid = { water = { type = "box"; from = [0.0, 0.0]; to = [0.4, 0.1]; }; };
wall = { tank = { type = "frame"; };
         ball = { type = "disc"; centre = [0.1, 0.3]; radius = 0.05; };
         roof = { type = "polygon"; points = [[0.2, 0.25], [0.3, 0.25], [0.25, 0.35]]; fill = "lattice"; }; };
beam = { flag = { at = [0.35, 0.2]; angle = 90.0; length = 0.08; thickness = 4e-3; E = 1e9; mass = 0.1; }; };
effects = { continuity = { }; pressure = { }; artificial-viscosity = { }; };
S
look made "$out/shapes.scene" spacing=1e-3
look counted "$out/shapes.scene" spacing=1e-4
claim 'shapes are made at 1 mm' "$code == 0 || $code == 2"
for object in water roof; do
    claim "$object: counted as it is made" \
        "($(count counted $object) / (100 * $(count made $object)) - 1) ^ 2 < 0.05 ^ 2"
done
for object in tank ball flag; do
    claim "$object: counted as it is made" \
        "($(count counted $object) / (10 * $(count made $object)) - 1) ^ 2 < 0.05 ^ 2"
done

look long "$scenes/toth-beam.scene" beam.plate.length=20000
claim 'a beam of 6 million spacings: refused' "$code == 2"
prints long 'toth-beam.scene:34: beam.plate: about 1.8e+07 particles would stand in it'
look far "$scenes/floating-box.scene" 'body.size=[1e5,1e5]'
claim 'a body of 1e14 sites: refused' "$code == 2"
prints far 'body.box: about 1e+14 particles'
finish
