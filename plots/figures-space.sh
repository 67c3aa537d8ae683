#!/bin/sh
# figures-space.sh -- a dam break on a box in three dimensions: the error of time, of five methods at
# one spacing, beside that of space, at four spacings, and beside chance: DIR/space.png.
# doc/accuracy.md tells what it shows.
#
# Run by `make figures', or by hand in a build tree:
#
#     top_srcdir=PATH sh .../figures-space.sh DIR
#
# Tables stay in DIR/space/, and so do runs; one that is done is not done again.  Ten CPU minutes,
# three of them for the finest run; times mean something on a machine that does nothing else.
#
# runs.csv and chance.csv have a row a run or set of runs: what it is (time, space, chance,
# experiment), method@CFL, tolerance, spacing [m], particles of water, right-hand sides, CPU
# seconds, and three errors: of the front, of the impulse on the box, and of the pressures P1 to P4
# as means over 20 ms.  An error is that of doc/compare.md,
#
#     sqrt(mean over t of sum over c of (v_c - r_c)^2) / max over t of sqrt(sum over c of r_c^2)
#
# over the columns c of a table, for impulse and pressures from 0.35 s on; before that there is no
# water at the box.  The r of time is `tight', that of space the finest run; chance has standard
# deviations of four runs in the place of v - r; an experiment has pressures only.
set -e

top=$(cd "${top_srcdir:-.}" && pwd)
stiffwater=${STIFFWATER:-$(cd "${top_builddir:-.}" && pwd)/stiffwater}
scene=$top/data/scenes/dam-break-3d.scene
until=0.6
keys='probe.P1.window=0.02 probe.P2.window=0.02 probe.P3.window=0.02 probe.P4.window=0.02
    output.fields=10 output.snapshots=1'
impulse='box.ix box.iy box.iz'
pressure='P1.mean P2.mean P3.mean P4.mean'
mkdir -p "$1/space"
cp "$top/plots/style.gp" "$top/plots/space.gp" "$1/space"
cd "$1/space"
echo '# nothing: this figure belongs to no single run' > constants.gp

# go RUN METHOD TOL SPACING: unless it is there and done
go()
{
    if grep -q '"status": "done"' "$1/run.json" 2> /dev/null; then return 0; fi
    echo "figures-space: $1" >&2
    # shellcheck disable=SC2086 # a list of words
    "$stiffwater" run "$scene" -q --threads 1 --until $until -m "$2" -t "$3" -o "$1" \
        spacing="$4" $keys
}

# number RUN KEY: of run.json
number()
{
    sed -n "s/^ *\"$2\": \(.*[0-9]\),*\$/\1/p" "$1/run.json"
}

# take TABLE NAME...: t and these columns
take()
{
    table=$1
    shift
    awk -F, -v names="$*" '
        /^#/ { next }
        /^t,/ { n = split(names, name, " "); for (i = 1; i <= NF; i++) at[$i] = i
                for (k = 1; k <= n; k++) if (!at[name[k]]) { print FILENAME ": no " name[k] >"/dev/stderr"; exit 1 }
                next }
        { line = $1; for (k = 1; k <= n; k++) line = line " " $at[name[k]]; print line }' "$table"
}

# distance FROM: of columns in `seen' from those in `true', whose t the rows have; both of `take'
distance()
{
    awk -v from="$1" '
        NR == FNR { t[++m] = $1; for (k = 2; k <= NF; k++) v[m, k] = $k; next }
        $1 < from || $1 > t[m] { next }
        { if (!i) i = 1
          while (i < m - 1 && t[i + 1] < $1) i++
          w = ($1 - t[i]) / (t[i + 1] - t[i]); size = 0
          for (k = 2; k <= NF; k++) {
              s += (v[i, k] + w * (v[i + 1, k] - v[i, k]) - $k) ^ 2
              size += $k ^ 2
          }
          if (size > most) most = size
          n++ }
        END { if (!n || !most) exit 1; printf "%.4g", sqrt(s / n / most) }' seen true
}

# front RUN SPACING: its way; half a spacing lies between the foremost particle and the front
front()
{
    take "$1/front.csv" x | awk -v half="$2" '{ print $1, $2 + half / 2 - 1.221 }'
}

# errors RUN SPACING REFERENCE ITS-SPACING
errors()
{
    front "$1" "$2" > seen
    front "$3" "$4" > true
    distance 0
    # shellcheck disable=SC2086 # lists of words
    {
        take "$1/forces.csv" $impulse > seen
        take "$3/forces.csv" $impulse > true
        printf ' '
        distance 0.35
        take "$1/probes.csv" $pressure > seen
        take "$3/probes.csv" $pressure > true
    }
    printf ' '
    distance 0.35
}

# row WHAT RUN METHOD TOL SPACING REFERENCE ITS-SPACING
row()
{
    off=$(errors "$2" "$5" "$6" "$7")
    echo "$1 $3 $4 $5 $(number "$2" fluid) $(number "$2" rhs_explicit) $(number "$2" cpu_s) $off"
}

# spread_of TABLE FROM COLUMN...: standard deviations of four runs as an error
spread_of()
{
    table=$1
    from=$2
    shift 2
    awk -F, -v from="$from" -v names="$*" '
        /^#/ { next }
        /^t,/ { n = split(names, name, " "); for (i = 1; i <= NF; i++) at[$i] = i; next }
        { size = 0
          for (k = 1; k <= n; k++) {
              mean = $at[name[k] ".mean"]
              if (!rows) first[k] = mean # of the front: where it starts
              size += (mean - first[k]) ^ 2
              if ($1 >= from) s += $at[name[k] ".sd"] ^ 2
          }
          rows++
          if ($1 >= from) m++
          if (size > most) most = size }
        END { if (!m || !most) exit 1; printf "%.4g", sqrt(s / m / most) }' "$table"
}

# chance SPACING: of four runs whose particles are shifted by a millionth of a spacing
chance()
{
    # shellcheck disable=SC2086 # lists of words
    {
        "$stiffwater" spread "$scene" -q --runs 4 --size 1e-6 --until $until --window 0.35,$until \
            -o "chance-$1" spacing="$1" $keys > "chance-$1.said"
        echo "chance cks43 1e-2 $1 $(number "chance-$1/runs/seed-1" fluid) 0 0" \
            "$(spread_of "chance-$1/spread-front.csv" 0 x)" \
            "$(spread_of "chance-$1/spread-forces.csv" 0.35 $impulse)" \
            "$(spread_of "chance-$1/spread-probes.csv" 0.35 $pressure)"
    }
}

# experiment: P1 to P4, rows 5 ms apart, as means over 20 ms that end there
experiment()
{
    awk -F, '/^[#t]/ { next }
        { n++; t[n] = $1; for (k = 2; k < 6; k++) p[n, k] = $k }
        n > 4 { line = $1
            for (k = 2; k < 6; k++) line = line " " (p[n, k] + p[n - 4, k]) / 8 + (p[n - 1, k] + p[n - 2, k] + p[n - 3, k]) / 4
            print line }' "$top/data/reference/E01_kleefsman_spheric2.csv"
}

# --- time: at 37 mm ---------------------------------------------------------------------------
at=0.037
go tight bs54 1e-5 $at
for way in cks43:1e-1 cks43:1e-2 cks43:1e-3 cks43:1e-4 ark436:1e-2 ark436:1e-3 opt53:1e-1 opt53:1e-2 \
    dv:1e-2 dv:1e-3 leapfrog@0.25:- leapfrog@0.1:-; do
    tol=${way#*:}
    go "$way" "${way%:*}" "$(echo "$tol" | sed 's/^-$/1e-2/')" $at
    row time "$way" "${way%:*}" "$tol" $at tight $at
done > time.csv

# --- space: the default method ------------------------------------------------------------------
for dx in 0.0185 0.02775 0.0555; do go "space-$dx" cks43 1e-2 $dx; done
{
    row space space-0.0555 cks43 1e-2 0.0555 space-0.0185 0.0185
    row space cks43:1e-2 cks43 1e-2 0.037 space-0.0185 0.0185
    row space space-0.02775 cks43 1e-2 0.02775 space-0.0185 0.0185
    experiment > true
    for dx in 0.0555 0.037 0.02775 0.0185; do
        run=space-$dx
        if [ $dx = $at ]; then run=cks43:1e-2; fi
        # shellcheck disable=SC2086 # a list of words
        take "$run/probes.csv" $pressure > seen
        echo "experiment cks43 1e-2 $dx $(number "$run" fluid) $(number "$run" rhs_explicit)" \
            "$(number "$run" cpu_s) nan nan $(distance 0.35)"
    done
} > space.csv
{
    chance 0.0555
    chance $at
} > chance.csv
{
    echo 'what method tol spacing particles rhs cpu front impulse pressure'
    cat time.csv space.csv chance.csv
} > runs.csv
gnuplot -d space.gp
