#!/bin/sh
# figures-clump.sh -- figure 2 of seed 003 redrawn: a cube as a clump of balls, whole and cut; and what
# interlocking does to two of them. Draws DIR/clump.png, which doc/seed-003.md tells of.
#
# Run by `make figures`, or by hand in a build tree:
#
#     top_srcdir=PATH sh .../figures-clump.sh DIR
#
# Ten CPU seconds.
set -e

top=$(cd "${top_srcdir:-.}" && pwd)
stiffwater=${STIFFWATER:-$(cd "${top_builddir:-.}" && pwd)/stiffwater}
mkdir -p "$1/clump"
cd "$1/clump"
cp "$top/plots/style.gp" "$top/plots/clump.gp" .
echo '# nothing: this figure belongs to no single run' > constants.gp

# balls CUT: a cube of 0.15 m, radius 33 mm, pitch 21 mm, by rays of an oblique view; rows x, y, red, green,
# blue.  CUT = 1: without the half that looks at us.
balls()
{
    awk -v cut="$1" 'BEGIN {
        r = 0.033; half = 0.075 - r; n = 4
        for (i = 0; i <= n; i++) for (j = 0; j <= n; j++) for (k = 0; k <= n; k++) {
            if (i % n && j % n && k % n) continue
            cx[++m] = half * (2 * i / n - 1); cy[m] = half * (2 * j / n - 1); cz[m] = half * (2 * k / n - 1)
        }
        a = 0.6; b = 0.45                   # turned to the right, seen from above
        rx = cos(a); ry = sin(a); rz = 0    # to the right, up, into the picture
        ux = -sin(a) * sin(b); uy = cos(a) * sin(b); uz = cos(b)
        dx = -sin(a) * cos(b); dy = cos(a) * cos(b); dz = -sin(b)
        size = 480; wide = 0.26
        for (v = 0; v < size; v++) for (h = 0; h < size; h++) {
            s = ((h + 0.5) / size - 0.5) * wide; t = ((v + 0.5) / size - 0.5) * wide
            ox = s * rx + t * ux - dx; oy = s * ry + t * uy - dy; oz = s * rz + t * uz - dz
            from = cut ? -oy / dy : 0; best = 9; hit = 0; inside = 0
            for (i = 1; i <= m; i++) {
                px = ox - cx[i]; py = oy - cy[i]; pz = oz - cz[i]
                along = px * dx + py * dy + pz * dz
                root = along * along - (px * px + py * py + pz * pz - r * r)
                if (root <= 0) continue
                root = sqrt(root)
                if (-along - root <= from && from < -along + root) inside = 1
                else if (-along - root > from && -along - root < best) { best = -along - root; hit = i }
            }
            if (inside) print h, v, 222, 120, 60
            else if (hit) {
                nx = (ox + best * dx - cx[hit]) / r; ny = (oy + best * dy - cy[hit]) / r
                nz = (oz + best * dz - cz[hit]) / r
                light = 0.35 + 0.65 * (0.2 * nx - 0.6 * ny + 0.77 * nz > 0 ? 0.2 * nx - 0.6 * ny + 0.77 * nz : 0)
                printf "%d %d %d %d %d\n", h, v, 110 * light, 165 * light, 225 * light
            } else print h, v, 255, 255, 255
        }
    }'
}

# slide NAME RADIUS DEGREES: a square of discs on a larger one that is held, ball upon ball, no friction;
# radius in pitches of 15 mm
slide()
{
    awk -v radius="$2" -v degrees="$3" 'BEGIN {
        s = 0.015; r = radius * s; side = 9 * s + 2 * r; base = 13 * s + 2 * r; a = degrees * atan2(0, -1) / 180
        print "dimension = 2; until = 0.25;"
        printf "gravity = [%.12f, %.12f];\n", 9.81 * sin(a), -9.81 * cos(a)
        print "domain = { from = [-1.0, -1.0]; to = [1.0, 1.0]; };"
        form = "%s = { shape = \"clump\"; at = [0.0, %.12f]; size = [%.12f, %.12f]; radius = %.12f; " \
               "pitch = 0.015; mass = 2.7; friction = 0.0; %s };\n"
        print "body = {"
        printf form, "base", -base / 2, base, base, r, "held = [\"x\", \"y\", \"turn\"];"
        printf form, "it", side / 2 + 1e-6, side, side, r, ""
        print "}; output = { interval = 0.0025; };"
    }' > "$1.scene"
    rm -rf "$1-run"
    "$stiffwater" run "$1.scene" -q --threads 1 -o "$1-run"
    awk -F, '/^#/ { next } /^t,/ { for (i = 1; i <= NF; i++) if ($i == "it.x") x = i; next }
        { print $1, 1000 * $x }' "$1-run/bodies.csv" > "$1"
}

balls 0 > whole
balls 1 > cut
slide small-5 0.32 5
slide small-10 0.32 10
slide half-10 0.5 10
slide large-5 1.1 5
slide large-10 1.1 10
gnuplot -d clump.gp
cp clump.png ..
