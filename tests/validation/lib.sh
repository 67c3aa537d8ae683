# lib.sh -- what the cases of this directory share; a case begins with  . "$(dirname "$0")/lib.sh"
#
# A case is one file, CASE.sh.  The comment at its head is its section in doc/validation.md:
# the title behind `--', then paragraphs in Markdown.  It runs scenes (go), puts a table and a
# drawing beside them (draw) and says what came of it, a line for each claim (row).  It fails
# when a claim misses its mark without a reason given, or meets it although a reason is given.
#
# VALIDATION_OUT is where runs, rows, tables and the figure are left; without it, nowhere.
set -eu
top=$(cd "${top_srcdir:-.}" && pwd)
top_srcdir=$top
top_builddir=$(cd "${top_builddir:-.}" && pwd)
cases=$top/tests/validation
scenes=$top/data/scenes
reference=$top/data/reference
case=$(basename "$0" .sh)
if [ -n "${VALIDATION_OUT-}" ]; then
    mkdir -p "$VALIDATION_OUT"
else
    VALIDATION_OUT=$(mktemp -d)
    trap 'rm -rf "$VALIDATION_OUT"' EXIT
fi
cd "$VALIDATION_OUT"
: >rows
out=.
. "$top/tests/lib.sh" # the harness; what stands there under a name used below is replaced

# go NAME SCENE KEY=VALUE...: a run into the directory NAME
go() {
    name=$1
    file=$2
    shift 2
    rm -rf "$name"
    "$STIFFWATER" run "$file" -q -o "$name" "$@" 2>"$name.said" ||
        { echo "$case: the run $name ends with $?"; cat "$name.said"; return 1; }
}

# mean FROM TO: of the second column between these times
mean() {
    awk -v from="$1" -v to="$2" '$1 >= from && $1 <= to { s += $2; n++ }
        END { printf "%.6g\n", n ? s / n : "nan" }'
}

# most: largest of the second column, and when
most() {
    awk 'NR == 1 || $2 > m { m = $2; t = $1 } END { printf "%.6g %.6g\n", m, t }'
}

# first LIMIT: when the second column first exceeds it, between rows by a straight line
first() {
    awk -v l="$1" '$2 > l { print NR == 1 ? $1 : t + (l - x) / ($2 - x) * ($1 - t); exit }
        { t = $1; x = $2 }'
}

# cross UP WHICH: time of that crossing of zero of the second column, upwards (1) or down (-1)
cross() {
    awk -v up="$1" -v which="$2" 'NR > 1 && x * up < 0 && $2 * up > 0 && ++k == which {
            print t - x / ($2 - x) * ($1 - t); exit }
        { t = $1; x = $2 }'
}

# calc EXPRESSION: in awk
calc() {
    awk "BEGIN { printf \"%.4g\", $1 }"
}

# cost RUN...: what they took together
cost() {
    seconds=0 sides=0 many=0
    for name; do
        seconds="$seconds + $(number "$name" cpu_s)"
        sides="$sides + $(number "$name" rhs_explicit)"
        here=$(sed -n 's/^ *"\(fluid\|wall\|skin\)": \([0-9]*\),*$/\2/p' "$name/run.json" |
            awk '{ n += $1 } END { print n + 0 }')
        [ "$here" -gt "$many" ] && many=$here
    done
    awk "BEGIN { printf \"%.3g s, %d, %d\", $seconds, $sides, $many }"
}

# row WHAT REFERENCE GOT MARK EXPRESSION COST [WHY]: EXPRESSION (awk) is the mark; WHY is the
# reason found for missing it
row() {
    verdict=missed
    case $5 in
    *nan* | *inf*) echo "$case: $1: no number in $5"; bad=1 ;;
    *) awk "BEGIN { exit !($5) }" && verdict=pass ;;
    esac
    case $verdict${7:+ with reason} in
    pass | 'missed with reason') ;;
    *) bad=1; echo "$case: $1: $verdict ${7:+, although a reason is given}" ;;
    esac
    [ $verdict = missed ] && verdict="**missed**${7:+: $7}"
    echo "$case | $1 | $2 | $3 | $4 | $verdict | $6" | tee -a rows
}

# snapshots RUN AWK-PROGRAM: a line a snapshot, t and what its END prints; columns of the fluid
# are x, y, u, v, rho, p
snapshots() {
    awk -F, '!/^[#t]/ { print $1, $2 }' "$1/snapshots.csv" | while read -r t file; do
        awk -F, -v t="$t" '/^#/ || /^x/ { next } $8 != 0 { next }
            { x = $1; y = $2; u = $3; v = $4; rho = $5; p = $6 } '"$2" \
            "$1/$file"
    done
}

# draw [-NAME]: the gnuplot script on its standard input, into CASE.png or CASE-NAME.png
draw() {
    cp "$top/plots/style.gp" .
    echo '# nothing: this figure belongs to no single run' >constants.gp
    { printf "load 'style.gp'\nset terminal pngcairo size 800, 480 font 'Sans,12'\n"
      echo "set output '$case${1-}.png'"; cat; } >figure${1-}.gp
    gnuplot -d figure${1-}.gp
}

# done_here: the last line of a case
done_here() {
    exit $bad
}
