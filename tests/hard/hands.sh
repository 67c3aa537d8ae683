# hands.sh -- what the scripts of tests/hard share beside ../lib.sh; they read it with `.`.  It
# leaves a new directory $out, removed at the end.
. "$top_srcdir/tests/lib.sh"
scratch

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
