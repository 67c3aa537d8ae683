#!/bin/sh
# include-rule.sh -- a file includes headers of its own room and of lower floors only.
#
# The floors are those of doc/house.md.  Rooms of one floor do not include each other, but
# where they stand in an order here: those may include what stands before them.
#
# Run by `make check', or by hand from the root of the sources.
cd "${top_srcdir:-.}" || exit 99

files=$(find src -name '*.[ch]' | sort)
[ -n "$files" ] || { echo "include-rule: no sources below $(pwd)/src"; exit 99; }

# shellcheck disable=SC2086 # names of sources have no blanks
awk '
BEGIN {
    place("base", 0)
    place("algebra kernels shapes matter scene", 1); place("space", 1.1)
    place("state", 2); place("fill", 2.1)
    place("effects pressure walls bodies", 3)
    place("plan", 4)
    place("time measure", 5)
    place("output", 6)
    place("run", 7); place("study", 7.1); place("cli", 7.2); place("main", 7.3)
}
function place(rooms, level,    name, i, n) {
    n = split(rooms, name, " ")
    for (i = 1; i <= n; i++) floor[name[i]] = level
}
function complain(text) {
    printf "%s:%d: %s\n", FILENAME, FNR, text
    bad++
}
FNR == 1 {
    split(FILENAME, part, "/")
    room = part[3] == "" ? "main" : part[2]
    if (!(room in floor)) complain("src/" room " is no room of the house")
}
/^[ \t]*#[ \t]*include[ \t]*"/ {
    split($0, quoted, "\"")
    n = split(quoted[2], to, "/")
    seen++
    if (n != 2)
        complain("\"" quoted[2] "\" is not written \"room/file.h\"")
    else if (!(to[1] in floor))
        complain("\"" quoted[2] "\": there is no room " to[1])
    else if (to[1] != room && floor[to[1]] >= floor[room])
        complain(room " (floor " int(floor[room]) ") must not include " quoted[2] \
                 " (floor " int(floor[to[1]]) "): only its own room and lower floors")
}
END {
    printf "include-rule: %d includes, %d violations\n", seen, bad
    exit bad > 0
}' $files
