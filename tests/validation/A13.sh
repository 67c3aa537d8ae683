#!/bin/sh
# A13.sh -- two spheres, and a sphere and a wall, that hit each other: Hertz
#
# The six impacts of `data/reference/A13_hertz_impact.csv`, closed forms of Hertz (1882), by `law = "hertz-mindlin"` in 3D, without
# weight, tol 1e-4; depth, largest force and time are read off 1000 rows of `bodies.csv` for the time of contact. Then a ball of PVC
# with the damping that is to give back a share of its speed.
. "$(dirname "$0")/lib.sh"

# impact NAME R V E R* M* TIME KEYS: a ball that goes down onto the floor, or onto one that comes up
impact() {
    set -- "$1" "$2" "$3" "$4" "$5" "$6" "$7" "$8" "$(calc9 "$4 * 2 * (1 - 0.09)")"
    if [ "$5" = "$2" ]; then
        bodies="a = { shape = \"sphere\"; at = [0.0, 0.0, $2]; radius = $2; mass = $6; velocity = [0.0, 0.0, -$3]; stops = [\"bottom\"]; };"
    else
        bodies="a = { shape = \"sphere\"; at = [0.0, 0.0, $(calc9 "0.5 + 2 * $2")]; radius = $2; mass = $(calc9 "2 * $6"); velocity = [0.0, 0.0, -$(calc9 "$3 / 2")]; };
            b = { shape = \"sphere\"; at = [0.0, 0.0, 0.5]; radius = $2; mass = $(calc9 "2 * $6"); velocity = [0.0, 0.0, $(calc9 "$3 / 2")]; };"
    fi
    cat >"$1.scene" <<S
dimension = 3; gravity = [0.0, 0.0, 0.0]; until = $(calc9 "3 * $7"); tol = 1e-4;
domain = { from = [-1.0, -1.0, 0.0]; to = [1.0, 1.0, 1.0]; };
body = { $bodies };
contact = { all = { of = "body"; with = "body"; law = "hertz-mindlin"; young = $9; friction = 0.0; $8 };
    floor = { of = "body"; with = "side"; law = "hertz-mindlin"; young = $9; friction = 0.0; $8 }; };
output = { interval = $(calc9 "$7 / 1000"); };
S
    go "$1" "$1.scene"
}
calc9() { awk "BEGIN { printf \"%.12e\", $1 }"; }

sed '/^[#n]/d' "$reference/A13_hertz_impact.csv" | tr , ' ' >exact
while read -r name radius v elastic star mass deep force time; do
    impact "$name" "$radius" "$v" "$elastic" "$star" "$mass" "$time" 'restitution = 1.0;'
    other=; [ "$star" = "$radius" ] || other=b.z
    # shellcheck disable=SC2086 # none or one
    column "$name/bodies" a.z a.contact_z $other | awk -v r="$radius" -v two="$other" '
        { d = two == "" ? r - $2 : 2 * r - ($2 - $4); if (d > deep) deep = d; if ($3 > force) force = $3
          if ($3 > 0) { if (!begun) { begun = 1; first = $1 }; last = $1 } }
        END { printf "%.9g %.9g %.9g\n", deep, force, last - first }' >got
    read -r d f t <got
    short=$(echo "$name" | sed 's/_[0-9.]*ms$//; s/_/ /g')
    row "$short, $v m/s: deepest" "$(calc "1e6 * $deep") um" "off by $(calc "100 * ($d / $deep - 1)") %" '0.5 %' "sqrt(($d / $deep - 1) ^ 2) < 5e-3" "$(cost "$name")"
    row "$short: largest force" "$force N" "off by $(calc "100 * ($f / $force - 1)") %" '0.5 %' "sqrt(($f / $force - 1) ^ 2) < 5e-3" ''
    row "$short: time of contact" "$time s" "off by $(calc "100 * ($t / $time - 1)") %" '0.5 %' "sqrt(($t / $time - 1) ^ 2) < 5e-3" ''
done <exact
for e in 0.9 0.8 0.6 0.5; do
    impact "e$e" 0.05 1 3.2502709e9 0.05 0.41887902 0.0005779536 "restitution = $e;"
    got=$(last "e$e" bodies a.vz)
    row "PVC on steel, damped: restitution" "$e" "$got" '1 %' "sqrt(($got / $e - 1) ^ 2) < 0.01" "$(cost "e$e")"
done
done_here
