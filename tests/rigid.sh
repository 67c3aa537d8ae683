#!/bin/sh
# rigid.sh -- rigid bodies in water at rest: a box floats as deep as Archimedes says, and one that
# is held has his lift; nothing depends on threads and lanes.
. "$top_srcdir/tests/lib.sh"

scenes=$top_srcdir/tests/scenes

# mean RUN FILE COLUMN FROM [LESS]: of a column after that time, less that.
mean()
{
    awk -F, -v name="$3" -v from="$4" -v less="${5:-0}" '
        /^#/ { next }
        /^t/ { for (i = 1; i <= NF; i++) if ($i == name) column = i; next }
        $1 >= from { n++; sum += $column }
        END { printf "%.9g", sum / n - less }' "$out/$1/$2"
}

# The level is (0.095 + 0.0036)/0.5 m, the box 0.036 m deep, its centre 0.006 m below the level.
for walls in contact own-density; do
    well "$walls" "$scenes/floating-box.scene" walls="$walls"
    rise=$(mean "$walls" bodies.csv it.y 3 0.18)
    echo "$walls: the box rises by $rise m, by Archimedes 0.0112 m"
    claim "$walls: draft within a spacing" "($rise - 0.0112)^2 < 0.01^2"
    lift=$(mean "$walls" forces.csv it.fy 3)
    claim "$walls: lift is weight" "($lift / (6 * 0.6 * 9.81) - 1)^2 < 0.005^2"
    claim "$walls: momentum closes" "$(number "$walls" momentum_defect) < 1e-8"
    claim "$walls: energy closes" "$(number "$walls" energy_defect_max) < 1e-3"
done
rise=$(mean contact bodies.csv it.y 3 0.18)
claim 'at faces: draft within a tenth of it' "($rise - 0.0112)^2 < 0.001^2"

# One that water makes room for: no water is left in it, behind its skin.
well room "$top_srcdir/data/scenes/floating-box.scene" until=6
rise=$(mean room bodies.csv box.y 3 0.2475)
claim 'water makes room for all of it' "$(number room carved) == 120"
claim 'draft of the shipped box within a tenth of a spacing' "$rise^2 < 0.001^2"
claim 'it does not drift' "$(mean room bodies.csv box.x 3 0.4)^2 < (0.01 * 0.2)^2"
claim 'it does not turn' "$(mean room bodies.csv box.angle 3)^2 < (0.5 / 57.3)^2"
claim 'its energy closes' "$(number room energy_defect_max) < 5e-3"

well held "$scenes/held-box.scene"
lift=$(mean held forces.csv it.fy 2)
torque=$(mean held bodies.csv it.mz 2)
own=$(mean held bodies.csv it.fy 2)
echo "held: $lift N/m, by Archimedes 58.86 N/m"
claim 'lift of a held box within 3 %' "($lift / 58.86 - 1)^2 < 0.03^2"
claim 'it stays' "$(mean held bodies.csv it.y 0 0.10)^2 < 1e-24"

# Bits, of a box that sinks and turns.
keys='body.it.density=1500.0 body.it.angle=3.0 body.it.stops=["bottom","left"] until=0.2'
for lanes in 2 8; do
    for threads in 1 2; do
        STIFFWATER_LANES=$lanes OMP_NUM_THREADS=$threads "$STIFFWATER" run \
            "$scenes/floating-box.scene" -q $keys -o "$out/bits-$lanes-$threads" 2>"$out/said" ||
            wrong "bits: $(cat "$out/said")"
        grep state_hash "$out/bits-$lanes-$threads/run.json" >>"$out/hashes"
    done
done
claim 'one hash of four runs' "$(sort -u "$out/hashes" | wc -l) == 1"
claim 'of four' "$(wc -l <"$out/hashes") == 4"

finish
