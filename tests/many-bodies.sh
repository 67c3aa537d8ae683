#!/bin/sh
# many-bodies.sh -- 200 discs, and 200 spheres, that fall a short way onto each other, without
# water; more bodies than a scene may have, and more places than contacts remember, are refused.
. "$top_srcdir/tests/lib.sh"

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

heap 2 disc 257
go crowd "$out/disc-257.scene"
claim 'more bodies than a scene may have are refused' "$code == 2"
prints crowd '257 bodies and beams are more than the 256'

heap 3 box 200
go boxes "$out/box-200.scene"
claim 'more places than contacts remember are refused' "$code == 2"
prints boxes 'places, each of which remembers how far it is bent' 'use fewer bodies'

finish
