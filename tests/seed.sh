#!/bin/sh
# seed.sh -- the first seed told honestly (doc/seed-000.md), with 800 and 400 particles: what its
# printed equations do and which of them does it, its two models against each other, what
# tension does to a summed density, which kernels let particles pair.
. "$top_srcdir/tests/lib.sh"
scenes=$top_srcdir/data/scenes
coarse=spacing=5e-3
often=output.fields=0.05 # and pairs are counted as often
one='kernel.density=wendland-c2 kernel.pressure=wendland-c2 kernel.support=3'

# arrival RUN: when the front is at the right wall
arrival() {
    awk -F, '!/^[#t]/ && $2 > 0.385 { print $1; exit }' "$out/$1/front.csv"
}

# tells RUN WORDS: the message in its run.json has them
tells() {
    if grep '"message"' "$out/$1/run.json" | grep -q -F -e "$2"; then good "$1 says: $2"
    else wrong "$1 says: $2"; cat "$out/$1.said"; fi
}

# --- as printed, and one fault after the other put right ---------------------------------
literal=$scenes/toth-dam-break-literal.scene
sed 's/pressure-printed/pressure/' "$literal" >"$out/force.scene"
sed 's/viscosity-printed/laplacian-viscosity/' "$out/force.scene" >"$out/both.scene"

go printed "$literal"
claim 'everything as printed fails' "$code == 1"
claim 'within the first microseconds' "$(number printed t_end) < 1e-6"
for words in particle effects.pressure-printed 'm/s^2' 'm/s, the sound speed 4 m/s' \
    'particle_mass = 0.011, but a site of this spacing holds 0.004'; do
    tells printed "$words"
done
go mass "$literal" particle_mass=4e-3
claim 'the right mass does not save it' "$code == 1"
tells mass effects.pressure-printed
go force "$out/force.scene" $coarse particle_mass=0.06875
claim 'nor does the right force with 2.75 times the mass' "$code == 1"
tells force 'particle_mass = 0.06875, but a site of this spacing holds 0.025'
go viscosity "$out/force.scene" $coarse particle_mass=0.025 until=0.3
claim 'with both it runs' "$code == 0"
claim 'but hardly braked: water leaves through the walls' "$(number viscosity escaped) > 50"
go both "$out/both.scene" $coarse particle_mass=0.025 until=0.3
claim 'with the right viscosity, too, it stays' "$code == 0 && $(number both escaped) <= 10"

# --- the scene that is put right -----------------------------------------------------------
go right "$scenes/toth-dam-break.scene" $coarse
claim 'the dam break runs to its end' "$code == 0 && $(number right t_end) == 1"
claim 'no particle leaves' "$(number right escaped) == 0"
claim 'the front is at the wall at about 0.23 s' \
    "$(arrival right) > 0.21 && $(arrival right) < 0.25"
claim 'energy closes to 15 %, rough as it is' \
    "$(number right energy_defect_max) < 0.15 * $(number right energy_initial)"
claim 'two kernels make more energy than there was' "$(last right book pressure_defect) > 20"
go tight "$scenes/toth-dam-break.scene" $coarse until=0.3 tol=1e-3
claim 'a smaller tolerance closes it to 0.5 %' \
    "$(number tight energy_defect_max) < 5e-3 * $(number tight energy_initial)"

# --- standard SPH against WCSPH, with one kernel: then no energy is made ---------------------
go printed-k "$scenes/toth-standard-sph.scene" $coarse $one until=0.3
go matched "$scenes/toth-standard-sph.scene" $coarse $one until=0.3 eos.k=392.4
go tait "$scenes/toth-dam-break.scene" $coarse $one until=0.3
go printed-c "$scenes/toth-dam-break.scene" $coarse $one until=0.3 eos.c0=4
claim 'one kernel makes no energy' \
    "$(last tait book pressure_defect) < 1e-9 && $(last tait book pressure_defect) > -1e-9"
claim 'the printed k is the stiffest' \
    "$(number printed-k density_max) < $(number tait density_max) - 20"
claim 'the printed c0 the softest' \
    "$(number printed-c density_max) > $(number tait density_max) + 100"
claim 'and takes four to five times the steps of WCSPH' \
    "sqrt(($(number printed-k steps) / $(number tait steps) - 4.65) ^ 2) < 0.85"
claim 'at equal stiffness there is one model: density' \
    "sqrt(($(number matched density_max) - $(number tait density_max)) ^ 2) < 50"
claim 'steps' "sqrt(($(number matched steps) / $(number tait steps) - 1) ^ 2) < 0.1"
claim 'front' "sqrt(($(arrival matched) - $(arrival tait)) ^ 2) < 0.0061"

# --- tension at the surface ------------------------------------------------------------------
go tension "$scenes/toth-dam-break.scene" $coarse $one until=0.1 eos.tension=true $often
go none "$scenes/toth-dam-break.scene" $coarse $one until=0.1 $often
go evolves "$scenes/dam-break.scene" $coarse until=0.1 walls=adami $often
claim 'tension starts with several times the energy' \
    "$(number tension energy_initial) > 4 * $(number none energy_initial)"
claim 'and the surface clumps' "$(last tension pairing pairing) > 0.25"
claim 'without tension it does not' "$(last none pairing pairing) < 0.02"
claim 'nor with a density that evolves' "$(last evolves pairing pairing) < 0.02"

# --- pairs under pressure, by kernel -----------------------------------------------------------
for kernel in gauss poly6 cubic-spline wendland-c2 spiky; do
    go $kernel "$scenes/clustering.scene" spacing=4e-3 particle_mass=0.0176 $often kernel.type=$kernel
done
go seeds "$scenes/clustering.scene" spacing=4e-3 particle_mass=0.0176 $often kernel.type=spiky \
    kernel.density=poly6
for kernel in gauss poly6 cubic-spline; do
    claim "$kernel pairs" "$(last $kernel pairing pairing) > 0.6"
done
for kernel in wendland-c2 spiky seeds; do
    claim "$kernel does not" "$(last $kernel pairing pairing) == 0"
    claim 'and keeps its distance' "$(last $kernel pairing nearest_least) > 0.7"
done
finish
