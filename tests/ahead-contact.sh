#!/bin/sh
# ahead-contact.sh -- a pressure that looks ahead between walls = "contact": a dam break and still
# water within their marks, no shear left in walls where one has moved.  With STIFFWATER_LONG a
# second of 1,800 particles, and three of still water.
#
# Marks, measured in brackets: still water 40 spacings deep, bed pressure 1 % (+0.69 % over 3 s, of
# which +0.61 % is there with `linear', too: it is the walls'), its deviation 1.5 % (0.72 %), kinetic
# energy 2e-6 m g H after 1 s (1.1e-6); 800 particles, 13 products in a right-hand side (10.5); a
# plate that has moved by 0.3 spacings changes the push along the floor beside it by less than 5 %
# of 229 N/m (0.1 %; `own-density' 10 %).
. "$top_srcdir/tests/lib.sh"
scenes=$top_srcdir/data/scenes

# scene NAME SHIPPED EOS: the shipped scene with this pressure
scene() {
    sed "s/^eos = .*/eos = { $3 };/; /density-healing/d" "$scenes/$2.scene" >"$out/$1.scene"
}

scene tension dam-break 'type = "look-ahead"; '
scene none dam-break 'type = "look-ahead"; tension = false; '
scene still still-water 'type = "look-ahead"; '

# dam NAME SCENE SPACING UNTIL PRODUCTS
dam() {
    well "$1" "$out/$2.scene" spacing="$3" until="$4" output.snapshots=0 output.fields=10
    claim "$1: products in each right-hand side" \
        "$(number "$1" operator_products) / $(number "$1" rhs_explicit) < $5"
    claim "$1: none leaves, none is in a wall" "$(number "$1" escaped) + $(number "$1" in_solids_max) == 0"
    claim "$1: the book closes" "$(number "$1" energy_defect_max) < 2e-3 * $(number "$1" energy_initial)"
}

# rests NAME UNTIL FROM KINETIC: bed pressure, its deviation, kinetic energy from that time on
rests() {
    well "$1" "$out/still.scene" until="$2" output.snapshots=0 output.fields=10
    bed=$(awk -F, -v from="$3" '/^[#t]/ || $1 < from { next }
        { p = $2 / (1000 * 9.81 * 0.185); s += p; q += p * p; n++ }
        END { m = s / n; print m - 1, sqrt(q / n - m * m) }' "$out/$1/probes.csv")
    claim "$1: bed pressure" "${bed% *} < 0.01 && ${bed% *} > -0.01"
    claim "$1: its deviation" "${bed#* } < 0.015"
    claim "$1: kinetic energy" "$(awk -F, -v from="$3" '/^[#t]/ || $1 < from { next } $2 > most { most = $2 }
        END { print most / (40 * 9.81 * 0.2) }' "$out/$1/book.csv") < $4"
}

# shear WALLS: what a plate that moved has changed of the push along the floor beside it [N/m]
shear() {
    well "$1" "$top_srcdir/tests/scenes/moved-plate.scene" walls="$1"
    left=$(awk -F, '/^t/ { while ($++c != "corner.fx"); next } /^#/ { next }
        $1 >= 0.1 && $1 <= 0.2 { before += $c; n++ } $1 >= 0.9 { after += $c; k++ }
        END { d = after / k - before / n; print d < 0 ? -d : d }' "$out/$1/forces.csv")
}

dam 800 tension 5e-3 0.3 13
dam 800-none none 5e-3 0.3 13
rests short 0.6 0.3 1e-5
shear contact
claim 'a plate that moved leaves no shear in contact walls' "$left < 0.05 * 229"
shear own-density
claim 'own-density shows what there is to leave' "$left > 0.05 * 229"

if [ -n "${STIFFWATER_LONG-}" ]; then
    dam 1800 tension 3.3333333333333333e-3 1 20
    rests long 3 1 2e-6
fi
finish
