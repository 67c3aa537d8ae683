#!/bin/sh
# include-rule.sh -- a file includes headers of its own room and of lower floors only.
#
# The floors are those of the table in doc/house.md: a room may include the rooms of the rows
# above its own, not those beside it.  Items of a row are parted by middle dots, and each begins
# with the name of its room.
#
# Run by `make check', or by hand from the root of the sources.
cd "${top_srcdir:-.}" || exit 99

files=$(find src -name '*.[ch]' | sort)
[ -n "$files" ] || { echo "include-rule: no sources below $(pwd)/src"; exit 99; }

# shellcheck disable=SC2086 # names of sources have no blanks
awk '
function complain(text) {
    printf "%s:%d: %s\n", FILENAME, FNR, text
    bad++
}
FNR == 1 { table = FILENAME ~ /\.md$/ }
table && /^\| [0-9]+ \|/ {
    rows++
    n = split($0, item, " · ")
    for (i = 1; i <= n; i++) {
        split(item[i], quoted, "`")
        room = quoted[2] == "main.c" ? "main" : quoted[2]
        if (room in row) complain("room " room " stands twice in the table")
        row[room] = rows; floor[room] = $2
    }
}
table { next }
FNR == 1 {
    split(FILENAME, part, "/")
    room = part[3] == "" ? "main" : part[2]
    if (!(room in used)) rooms_used++
    used[room] = 1
    if (!(room in row)) complain("src/" room " is no room of doc/house.md")
}
/^[ \t]*#[ \t]*include[ \t]*"/ {
    split($0, quoted, "\"")
    n = split(quoted[2], to, "/")
    seen++
    if (n != 2)
        complain("\"" quoted[2] "\" is not written \"room/file.h\"")
    else if (!(to[1] in row))
        complain("\"" quoted[2] "\": there is no room " to[1])
    else if (to[1] != room && row[to[1]] >= row[room])
        complain(room " (floor " floor[room] ") must not include " quoted[2] \
                 " (floor " floor[to[1]] "): only its own room and those of rows above it")
}
END {
    for (room in row)
        if (!(room in used)) { printf "doc/house.md: there is no room %s\n", room; bad++ }
    printf "include-rule: %d rooms, %d includes, %d violations\n", rooms_used, seen, bad
    exit bad > 0
}' doc/house.md $files
