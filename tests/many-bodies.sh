#!/bin/sh
# many-bodies.sh -- 200 discs, and 200 spheres, that fall a short way onto each other, without
# water; 200 boxes and cubes that are thrown into a bin; more bodies than a scene
# may have, and more places than contacts remember, are refused.  Without STIFFWATER_LONG fewer cubes
# are thrown, and boxes in water have one number of threads (tests/shipped-scenes.sh has two).
. "$top_srcdir/tests/lib.sh"
if [ -n "${STIFFWATER_LONG-}" ]; then cubes=200; else cubes=108; fi

# heap DIM SHAPE COUNT: bodies 4 cm wide in rows of 5 cm by 4.5 cm, none of them above another.
heap()
{
    awk -v dim="$1" -v shape="$2" -v n="$3" '
        function vector(x, y, z) { return dim == 3 ? "[" x ", " y ", " z "]" : "[" x ", " z "]" }
        BEGIN {
            side = dim == 3 ? 6 : 10
            row = dim == 3 ? side * side : side
            wide = sprintf("%.2f", side * 0.05)
            high = sprintf("%.2f", (int((n - 1) / row) + 2) * 0.05)
            size = shape == "box" ? "size = " vector(0.04, 0.04, 0.04) : "radius = 0.02"
            print "title = \"Many bodies\"; dimension = " dim "; until = 0.03;"
            print "gravity = " vector("0.0", "0.0", -9.81) "; output = { interval = 0.01; };"
            print "domain = { from = " vector("0.0", "0.0", "0.0") "; to = " vector(wide, wide, high) "; };"
            print "body = {"
            for (i = 0; i < n; i++)
                printf "b%d = { shape = \"%s\"; at = %s; %s; density = 1350.0; stops = [\"bottom\"]; };\n",
                    i, shape, vector(0.025 + 0.05 * (i % side) + 0.002 * (i % 3 - 1),
                                     0.025 + 0.05 * (int(i / side) % side) + 0.001 * (i % 5 - 2),
                                     0.0205 + 0.045 * int(i / row)), size
            print "};"
        }' >"$out/$2-$3.scene"
}

# A lowest row touches the floor within this time, as it starts 0.5 mm above it.
for kind in '2 disc' '3 sphere'; do
    shape=${kind#* }
    heap ${kind% *} "$shape" 200
    top=$([ "$shape" = disc ] && echo '0.0205 + 0.045 * 19' || echo '0.0205 + 0.045 * 5')
    well "$shape" "$out/$shape-200.scene" --threads 1
    up=$([ "$shape" = disc ] && echo y || echo z)
    claim "$shape: the first lies on the floor" "(($(last "$shape" bodies "b0.$up") - 0.02) / 1e-3)^2 < 1"
    claim "$shape: the last falls freely" \
        "($(last "$shape" bodies "b199.$up") - ($top) + 0.5 * 9.81 * 0.03^2)^2 < 1e-12"
    claim "$shape: momentum closes" "$(number "$shape" momentum_defect) < 1e-9"
    claim "$shape: energy closes" "$(number "$shape" energy_defect_max) < 1e-3"
    well "$shape-2" "$out/$shape-200.scene" --threads 2
    [ "$(hash "$shape")" = "$(hash "$shape-2")" ] && good "$shape: one hash of one thread and two" ||
        wrong "$shape: two hashes of one thread and two"
done

# The figures find all columns of a table, however long the line of their names.
if command -v gnuplot >/dev/null; then
    cp "$top_srcdir/plots/style.gp" "$out/disc/figures/names.gp"
    printf "table = '../bodies.csv'\neval read_names\nset print '-'\nprint words(names), word(names, words(names))\n" \
        >>"$out/disc/figures/names.gp"
    seen=$(cd "$out/disc/figures" && gnuplot -d names.gp 2>&1)
    there=$(sed -n 2p "$out/disc/bodies.csv" | awk -F, '{ print NF, $NF }')
    [ "$seen" = "$there" ] && good "columns of a long line: $there" || wrong "columns: $seen, not $there"
fi

heap 2 disc 257
go crowd "$out/disc-257.scene"
claim 'more bodies than a scene may have are refused' "$code == 2"
prints crowd '257 bodies and beams are more than the 256'

# Cylinders have so many edges that seats do not help.
awk 'BEGIN {
    print "title = \"Cylinders\"; dimension = 3; until = 0.01; gravity = [0.0, 0.0, -9.81];"
    print "domain = { from = [0.0, 0.0, 0.0]; to = [5.0, 1.0, 1.0]; }; body = {"
    for (i = 0; i < 40; i++)
        printf "c%d = { shape = \"cylinder\"; at = [%s, 0.5, 0.5]; radius = 0.02; height = 0.04; density = 1350.0; };\n",
            i, 0.1 + 0.1 * i
    print "};"
}' >"$out/cylinders.scene"
go cylinders "$out/cylinders.scene"
claim 'more places than contacts remember are refused' "$code == 2"
prints cylinders 'places, each of which remembers how far it is bent' 'bodies with fewer corners and edges'

# bin DIM COUNT ACROSS SPEED: boxes of 4 cm in a lattice of 5 cm by 4.5 cm, thrown down into a bin.
bin()
{
    awk -v dim="$1" -v n="$2" -v side="$3" -v speed="$4" '
        function vector(x, y, z) { return dim == 3 ? "[" x ", " y ", " z "]" : "[" x ", " z "]" }
        BEGIN {
            row = dim == 3 ? side * side : side
            wide = sprintf("%.2f", side * 0.05 + 0.02)
            high = sprintf("%.2f", (int((n - 1) / row) + 2) * 0.05)
            sides = "\"left\", \"right\", \"bottom\"" (dim == 3 ? ", \"front\", \"back\"" : "")
            print "title = \"Boxes in a bin\"; dimension = " dim "; until = 0.03;"
            print "gravity = " vector("0.0", "0.0", -9.81) "; output = { interval = 0.01; };"
            print "domain = { from = " vector("0.0", "0.0", "0.0") "; to = " vector(wide, wide, high) "; };"
            print "body = {"
            for (i = 0; i < n; i++)
                printf "b%d = { at = %s; size = %s; density = 1350.0; velocity = %s; stops = [%s]; };\n",
                    i, vector(0.035 + 0.05 * (i % side) + 0.002 * (i % 3 - 1),
                              0.035 + 0.05 * (int(i / side) % side) + 0.001 * (i % 5 - 2),
                              0.0225 + 0.045 * int(i / row)), vector(0.04, 0.04, 0.04),
                    vector(0.4 * (i % 7 - 3) / 3, 0.3 * (i % 4 - 1.5), -speed), sides
            print "};"
        }' >"$out/bin-$1-$2.scene"
}

# thrown NAME: what holds for all that were thrown into a bin; a core that is entered, or a pair
# that touches without a seat, would be a right-hand side without an answer.  A margin, 2 mm, is half
# of the spacing that such bodies would have in water.
thrown()
{
    claim "$1: energy closes to 2 %" "$(number "$1" energy_defect_max) < 0.02 * $(number "$1" energy_initial)"
    claim "$1: none is deeper in another than a margin" \
        "$(number "$1" contact_depth_max) > 1e-5 && $(number "$1" contact_depth_max) < 2e-3"
    claim "$1: momentum closes" "$(number "$1" momentum_defect) < 1e-9"
    claim "$1: less than half of its motion is left" \
        "$(last "$1" book kinetic) < 0.5 * $(awk -F, '!/^[#t]/ { print $2; exit }' "$out/$1/book.csv")"
    claim "$1: no step meets what has no seat, and none enters a core" "$(number "$1" refused) == 0"
    claim "$1: seats end a segment at most once in 20 steps" \
        "$(number "$1" contact_segments) >= 1 && 20 * $(number "$1" contact_segments) < $(number "$1" steps)"
}

# looks RUN: pairs looked at for a right-hand side and a body.
looks()
{
    echo "$(number "$1" contact_pairs) / $(number "$1" rhs_explicit) / $2"
}

bin 3 $cubes 6 2.0
well cubes "$out/bin-3-$cubes.scene" --threads 1
thrown cubes
claim 'cubes: of the numbers of all pairs, 9.5 million for 200, few are kept' \
    "$(number cubes state_size) < 900000 * $cubes / 200"

bin 2 200 10 2.0
bin 2 50 10 2.0
well boxes "$out/bin-2-200.scene" --threads 1 output.checkpoint=0.02 until=0.06
thrown boxes
well boxes-2 "$out/bin-2-200.scene" --threads 2 output.checkpoint=0.02 until=0.06
[ "$(hash boxes)" = "$(hash boxes-2)" ] && good 'boxes: one hash of one thread and two' ||
    wrong 'boxes: two hashes of one thread and two'
well few "$out/bin-2-50.scene" --threads 1
claim 'pairs that are looked at grow as bodies do' "$(looks boxes 200) < 1.5 * ($(looks few 50))"

# rafts COLUMNS ROWS: in the way of a dam that breaks, boxes of 3 cm, 2 mm apart; 2D.
rafts()
{
    awk -v columns="$1" -v rows="$2" '
        BEGIN {
            print "title = \"Rafts\"; dimension = 2; until = 0.3; spacing = 0.01; gravity = [0.0, -9.81];"
            print "domain = { from = [0.0, 0.0]; to = [1.6, 0.6]; }; wall = { tank = { type = \"frame\"; }; };"
            print "effects = { continuity = { }; pressure = { }; artificial-viscosity = { alpha = 0.05; }; };"
            print "fluid = { water = { type = \"box\"; from = [0.0, 0.0]; to = [0.2, 0.3]; }; }; body = {"
            for (i = 0; i < columns * rows; i++)
                printf "b%d = { at = [%s, %s]; size = [0.03, 0.03]; density = 600.0; };\n", i,
                    0.25 + 0.032 * (i % columns) + 0.0003 * (i % 5), 0.0155 + 0.032 * int(i / columns)
            print "}; output = { interval = 0.01; };"
        }' >"$out/rafts.scene"
}

# Contacts of many bodies in water: whether seats change is asked between its steps as well.
rafts 32 5
well rafts "$out/rafts.scene" --threads 1
claim 'rafts: seats end a segment at most once in 20 rebuilds' \
    "$(number rafts contact_segments) >= 1 && 20 * $(number rafts contact_segments) < $(number rafts rebuilds)"
claim 'rafts: energy closes' "$(number rafts energy_defect_max) < 0.02 * $(number rafts energy_initial)"
claim 'rafts: momentum closes' "$(number rafts momentum_defect) < 1e-8"
claim 'rafts: none is deeper in another than a margin' "$(number rafts contact_depth_max) < 5e-3"
claim 'rafts: the water moves the first' "$(last rafts bodies b0.x) > 0.26"
if [ -n "${STIFFWATER_LONG-}" ]; then
    well rafts-2 "$out/rafts.scene" --threads 2
    [ "$(hash rafts)" = "$(hash rafts-2)" ] && good 'rafts: one hash of one thread and two' ||
        wrong 'rafts: two hashes of one thread and two'
fi

# On from a checkpoint between two changes of seats.
well part "$out/bin-2-200.scene" --threads 1 output.checkpoint=0.02 until=0.02
"$STIFFWATER" resume "$out/part" until=0.06 -q >"$out/resumed.said" 2>&1 || cat "$out/resumed.said"
[ "$(hash boxes)" = "$(hash part)" ] && good 'boxes: one hash in one go and resumed' ||
    wrong 'boxes: two hashes in one go and resumed'

finish
