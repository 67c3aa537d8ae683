# hands.sh -- what the scripts of tests/hard share; they read it with `.`.  It leaves a new
# directory $out, removed at the end, and $bad, the exit status to end with.
set -eu
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
bad=0

# go NAME FILE KEY=VALUE...; its exit status goes to $code, what it says to $out/NAME.said
go() {
    name=$1
    file=$2
    shift 2
    code=0
    "$STIFFWATER" run "$file" output.fields=100 output.snapshots=0 -q -o "$out/$name" "$@" \
        >"$out/$name.said" 2>&1 || code=$?
}

# number RUN KEY: a number of run.json
number() {
    sed -n "s/^ *\"$2\": \(.*[0-9]\),*\$/\1/p" "$out/$1/run.json"
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

# claim WORDS EXPRESSION: an awk expression that must be true
claim() {
    if awk "BEGIN { exit !($2) }"; then echo "ok      $1: $2"
    else echo "NOT SO  $1: $2"; bad=1; fi
}

# says RUN WORDS...: it printed each of them
says() {
    run=$1
    shift
    for words in "$@"; do
        if grep -q -F -e "$words" "$out/$run.said"; then echo "ok      $run says: $words"
        else echo "NOT SO  $run says: $words"; cat "$out/$run.said"; bad=1; fi
    done
}

# quiet RUN: it printed nothing
quiet() {
    if [ -s "$out/$1.said" ]; then echo "NOT SO  $1 is quiet"; cat "$out/$1.said"; bad=1
    else echo "ok      $1 is quiet"; fi
}

# whole RUN: every row of its tables has all fields and ends its line, particle files are
# HDF5 as long as they say, run.json closes
whole() {
    torn=
    for table in "$out/$1"/*.csv "$out/$1"/snapshots/*.csv; do
        [ -e "$table" ] || continue
        awk -F, '/^#/ { next } { gsub(/"[^"]*"/, "text") } !n { n = NF } NF != n { exit 1 }' \
            "$table" && [ -z "$(tail -c 1 "$table")" ] || torn="$torn $table"
    done
    for file in "$out/$1"/fields/*.vtkhdf; do
        [ -e "$file" ] || continue
        [ "$(head -c 4 "$file" | tail -c 3)" = HDF ] || torn="$torn $file"
        [ "$(wc -c <"$file")" -ge "$(od -A n -t u8 -j "$end_of_file" -N 8 "$file")" ] ||
            torn="$torn $file"
    done
    [ ! -e "$out/$1/fields.xdmf" ] || tail -n 1 "$out/$1/fields.xdmf" | grep -q '</Xdmf>' ||
        torn="$torn fields.xdmf"
    [ ! -e "$out/$1/run.json" ] || [ "$(tail -n 1 "$out/$1/run.json")" = '}' ] ||
        torn="$torn run.json"
    if [ -z "$torn" ]; then echo "ok      $1: files are whole"
    else echo "NOT SO  $1: files are whole:$torn"; bad=1; fi
}
end_of_file=40 # where the superblock of HDF5 (version 0) has the length of the file
