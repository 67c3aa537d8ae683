# lib.sh -- the harness of the scripts below tests/: they read it with `.`, make claims, and end
# with `finish'.  It leaves a new directory $out, removed at the end, unless $out is set; runs
# are below it.  A command that fails ends a script that does not look at it; scripts that ask
# for failures all the time begin with `asking'.
set -eu
top_srcdir=$(cd "${top_srcdir:-.}" && pwd)
top_builddir=$(cd "${top_builddir:-.}" && pwd)
STIFFWATER=${STIFFWATER:-$top_builddir/stiffwater}
case $STIFFWATER in /*) ;; *) STIFFWATER=$(pwd)/$STIFFWATER ;; esac
script=$(basename "$0" .sh)
bad=0    # 1 when a claim was not true
tried=0  # claims
failed=0 # those that were not true

if [ -z "${out-}" ]; then
    out=$(mktemp -d) || exit 99
    trap 'chmod -R u+w "$out"; rm -rf "$out"' EXIT
fi

# brief: whether a program of a sanitizer runs, in which steps take ten times as long and few show as much;
# with STIFFWATER_LONG nothing is brief
brief() {
    [ -z "${STIFFWATER_LONG-}" ] && grep -q __asan_init "$top_builddir/stiffwater-2d"
}

# --- verdicts ---------------------------------------------------------------------------------
# good WORDS: a claim that is true
good() {
    tried=$((tried + 1))
    echo "ok      $*"
}

# wrong WORDS: a claim that is not
wrong() {
    tried=$((tried + 1))
    failed=$((failed + 1))
    bad=1
    echo "NOT SO  $*"
}

# claim WORDS EXPRESSION: an awk expression that must be true
claim() {
    if awk "BEGIN { exit !($2) }"; then good "$1: $2"; else wrong "$1: $2"; fi
}

# finish: the verdict of the script; without a claim there is none
finish() {
    echo "$script: $tried tried, $failed complaints"
    [ $tried -gt 0 ] || exit 99
    exit $bad
}

# skip WORDS: the whole script
skip() {
    echo "$script: skipped, $*"
    exit 77
}

# --- runs -------------------------------------------------------------------------------------
# go NAME FILE KEY=VALUE...; its exit status goes to $code, what it says to $out/NAME.said
go() {
    name=$1
    file=$2
    shift 2
    code=0
    "$STIFFWATER" run "$file" output.fields=100 output.snapshots=0 -q -o "$out/$name" "$@" \
        >"$out/$name.said" 2>&1 || code=$?
}

# well NAME FILE KEY=VALUE...: the same, and it must come to its end
well() {
    go "$@"
    [ "$code" = 0 ] || { wrong "$1 comes to its end"; cat "$out/$1.said"; exit 1; }
}

# prints RUN WORDS...: it printed each of them
prints() {
    run=$1
    shift
    for words in "$@"; do
        if grep -q -F -e "$words" "$out/$run.said"; then good "$run says: $words"
        else wrong "$run says: $words"; cat "$out/$run.said"; fi
    done
}

# quiet RUN: it printed nothing
quiet() {
    if [ -s "$out/$1.said" ]; then wrong "$1 is quiet"; cat "$out/$1.said"
    else good "$1 is quiet"; fi
}

# --- what a run leaves ------------------------------------------------------------------------
# number RUN KEY: a number of run.json
number() {
    sed -n "s/^ *\"$2\": \(.*[0-9]\),*\$/\1/p" "$out/$1/run.json"
}

# value RUN KEY: what run.json has there, words without their quotes
value() {
    sed -n "s/^ *\"$2\": *\"\{0,1\}\([^\",]*\).*/\1/p" "$out/$1/run.json"
}

# hash RUN: of its last state
hash() {
    value "$1" state_hash
}

# last RUN FILE COLUMN: of the last row
last() {
    awk -F, -v name="$3" '/^#/ { next } /^t/ { for (i = 1; i <= NF; i++) if ($i == name) c = i }
        { x = $c } END { print x }' "$out/$1/$2.csv"
}

# most RUN FILE COLUMN: largest number in it, whatever its sign
most() {
    awk -F, -v name="$3" '/^#/ { next } /^t/ { for (i = 1; i <= NF; i++) if ($i == name) c = i; next }
        { x = $c < 0 ? -$c : $c } x > m { m = x } END { print m + 0 }' "$out/$1/$2.csv"
}

# column RUN/FILE COLUMN...: time and these columns, with blanks between
column() {
    table=$out/$1.csv
    shift
    awk -F, -v names="$*" '/^#/ { next }
        !n { n = split(names, name, " ")
             for (k = 1; k <= n; k++) for (i = 1; i <= NF; i++) if ($i == name[k]) c[k] = i
             next }
        { line = $1; for (k = 1; k <= n; k++) line = line " " $(c[k]); print line }' "$table"
}

# torn DIRECTORY: files of it that are cut off: rows of tables with too few fields or without
# the end of a line, particle files shorter than they say, other files without their end
torn() {
    for table in "$1"/*.csv "$1"/snapshots/*.csv; do
        [ -e "$table" ] || continue
        awk -F, '/^#/ { next } { gsub(/"[^"]*"/, "text") } !n { n = NF } NF != n { exit 1 }' \
            "$table" && [ -z "$(tail -c 1 "$table")" ] || echo "$table"
    done
    for file in "$1"/fields/*.vtkhdf; do
        [ -e "$file" ] || continue
        [ "$(head -c 4 "$file" | tail -c 3)" = HDF ] || echo "$file"
        [ "$(wc -c <"$file")" -ge "$(od -A n -t u8 -j "$end_of_file" -N 8 "$file")" ] || echo "$file"
    done
    [ ! -e "$1/fields.xdmf" ] || tail -n 1 "$1/fields.xdmf" | grep -q '</Xdmf>' ||
        echo "$1/fields.xdmf"
    [ ! -e "$1/run.json" ] || [ "$(tail -n 1 "$1/run.json")" = '}' ] || echo "$1/run.json"
}
end_of_file=40 # where the superblock of HDF5 (version 0) has the length of the file

# whole RUN: its files are
whole() {
    torn=$(torn "$out/$1")
    if [ -z "$torn" ]; then good "$1: files are whole"; else wrong "$1: files are whole:" $torn; fi
}

# --- questions to the program -----------------------------------------------------------------
# asking: the script goes on whatever fails, in $out; $ask stands before the words of expect
asking() {
    set +eu
    case $scenes in /*) ;; *) scenes=$(pwd)/$scenes ;; esac
    cd "$out" || exit 99
}

# complain WORDS: not what was expected, with the last answer
complain() {
    failed=$((failed + 1))
    bad=1
    echo "$script: $*"
    [ ! -f "$out/said" ] || sed 's/^/    /' "$out/said"
}

# expect STATUS WORD...: runs the words behind $ask; what is said is in the file $out/said
expect() {
    wanted=$1
    shift
    # shellcheck disable=SC2086 # words
    timeout 300 "$STIFFWATER" $ask "$@" >"$out/said" 2>&1 </dev/null
    found=$?
    what=$*
    tried=$((tried + 1))
    [ $found = "$wanted" ] || complain "$what: exit status $found instead of $wanted"
}

# says PATTERN...: the last answer holds each of them
says() {
    for pattern in "$@"; do
        grep -q -F -e "$pattern" "$out/said" || complain "$what: \"$pattern\" is not said"
    done
}
