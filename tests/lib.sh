# lib.sh -- what the scripts of these tests share; they read it with `.` and end with
# `exit $bad`.  Runs are below the directory $out.
set -eu
bad=0

# scratch: a new directory $out, removed at the end
scratch() {
    out=$(mktemp -d)
    trap 'rm -rf "$out"' EXIT
}

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
    [ "$code" = 0 ] || { echo "NOT SO  $1 comes to its end"; cat "$out/$1.said"; exit 1; }
}

# number RUN KEY: a number of run.json
number() {
    sed -n "s/^ *\"$2\": \(.*[0-9]\),*\$/\1/p" "$out/$1/run.json"
}

# hash RUN: of its last state
hash() {
    sed -n 's/^ *"state_hash": "\(.*\)",*$/\1/p' "$out/$1/run.json"
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
