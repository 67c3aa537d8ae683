#!/bin/sh
# figures-blocks.sh -- figures 3 to 6 of seed 003 redrawn: paths of blocks in a flood, and what it looks
# like. Draws DIR/blocks-paths.png and DIR/blocks-snapshots.png, which doc/seed-003.md tells of.
#
# Run by `make figures`, or by hand in a build tree:
#
#     top_srcdir=PATH sh .../figures-blocks.sh DIR
#
# Runs and tables stay in DIR/blocks/; one that is done is not done again.  Fifteen CPU minutes.
set -e

top=$(cd "${top_srcdir:-.}" && pwd)
stiffwater=${STIFFWATER:-$(cd "${top_builddir:-.}" && pwd)/stiffwater}
mkdir -p "$1/blocks"
cd "$1/blocks"
cp "$top/plots/style.gp" "$top/plots/"blocks-*.gp .
echo '# nothing: these figures belong to no single run' > constants.gp

# go RUN SCENE UNTIL PICTURES: unless it is there and done
go()
{
    if grep -q '"status": "done"' "$1/run.json" 2> /dev/null; then return 0; fi
    echo "figures-blocks: $1" >&2
    "$stiffwater" run "$top/data/scenes/$2.scene" -q --threads 1 -o "$1" "until=$3" output.interval=0.01 \
        output.fields=10 "output.snapshots=$4"
}

# path RUN BODY: t, x, z
path()
{
    awk -F, -v body="$2" '/^#/ { next }
        /^t,/ { for (i = 1; i <= NF; i++) { if ($i == body ".x") x = i; if ($i == body ".z") z = i } next }
        { print $1, $x, $z }' "$1/bodies.csv" > "$1-$2"
}

# edges RUN TIME: the twelve edges of each cube as seen from the side, x and z, with a blank line
# behind each; the first row at TIME or later
edges()
{
    awk -F, -v at="$2" '/^#/ { next }
        /^t,/ { for (i = 1; i <= NF; i++) if ($i ~ /\.qw$/) q[++n] = i; next }
        $1 > at - 1e-9 {
            for (b = 1; b <= n; b++) {
                i = q[b]; w = $i; x = $(i + 1); y = $(i + 2); z = $(i + 3)
                square = w * w + x * x + y * y + z * z
                for (k = 0; k < 8; k++)
                    for (bit = 1; bit < 8; bit *= 2) {
                        if (int(k / bit) % 2) continue
                        corner(k); corner(k + bit); print ""
                    }
            }
            exit
        }
        function corner(k,    a, b, c) {
            a = 0.15 * (k % 2 - 0.5); b = 0.15 * (int(k / 2) % 2 - 0.5); c = 0.15 * (int(k / 4) - 0.5)
            print $(i - 6) + (a * (w * w + x * x - y * y - z * z) + 2 * b * (x * y - w * z) \
                      + 2 * c * (x * z + w * y)) / square, \
                  $(i - 4) + (2 * a * (x * z - w * y) + 2 * b * (y * z + w * x) \
                      + c * (w * w - x * x - y * y + z * z)) / square
        }' "$1/bodies.csv"
}

# moment RUN TIME: water in the middle 0.3 m of the flume, x, z and speed, and the cubes
moment()
{
    file=$(awk -F, -v t="$2" '!/^[#t]/ && $1 > t - 1e-9 { print $2; exit }' "$1/snapshots.csv")
    awk -F, '!/^[#x]/ && $10 == 0 && ($2 - 0.35) ^ 2 < 0.15 ^ 2 && $1 > 0.9 {
        print $1, $3, sqrt($4 * $4 + $5 * $5 + $6 * $6) }' "$1/$file" > "$1-water-$2"
    edges "$1" "$2" > "$1-cubes-$2"
}

go paper seed-003-blocks 1.6 81
go three flood-three-cubes 1.6 81
go six flood-six-cubes 2 101
for run in paper three; do
    for body in lower top; do path $run $body; done
    for t in 0.98 1.28; do moment $run $t; done
done
path six top
for t in 0.82 1.16 1.46; do moment six $t; done
for what in x z; do
    awk -F, -v what=$what '$1 == "exp" && $2 == what { print $3, $4 }' \
        "$top/data/reference/D02_canelas_three_cubes_top.csv" > "seen-$what"
done
gnuplot -d blocks-paths.gp
gnuplot -d blocks-snapshots.gp
for figure in blocks-*.png; do cp "$figure" ..; done
