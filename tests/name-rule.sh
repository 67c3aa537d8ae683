#!/bin/sh
# name-rule.sh -- a global name says where it lives: it starts with the name of its file, of
# its room, or of the header of its room that declares it.
#
# Looks with nm at every object of the built libraries.  For src/bodies/beam-load.c these
# names pass: beam_load, beam_load_x, bodies_x, body_x (one of them) and, if there is a
# src/bodies/beam.h, beam_x.  Names that start with two underscores belong to the compiler.
#
# Run by `make check', or by hand in a build tree with top_srcdir=PATH.
headers=$(cd "${top_srcdir:-..}" && find src -mindepth 2 -name '*.h' | tr '\n' ' ')
cd "${top_builddir:-.}" || exit 99

objects=$(find src -mindepth 2 -name '*.o' | sort)
[ -n "$objects" ] || { echo "name-rule: no objects below $(pwd)/src: run make first"; exit 99; }

# shellcheck disable=SC2086 # names of objects have no blanks
${NM:-nm} -A -P -g --defined-only $objects | awk -v headers="$headers" '
BEGIN {
    n = split(headers, header, " ")
    for (i = 1; i <= n; i++) {
        split(header[i], part, "/")
        sub(/\.h$/, "", part[3]); gsub(/-/, "_", part[3])
        declares[part[2], part[3]] = 1
    }
}
function starts(name, prefix) {
    return name == prefix || index(name, prefix "_") == 1
}
function declared(name, room,    key, part) {
    for (key in declares) {
        split(key, part, SUBSEP)
        if (part[1] == room && starts(name, part[2])) return 1
    }
    return 0
}
function singular(room) {
    if (room ~ /ies$/) return substr(room, 1, length(room) - 3) "y"
    return room ~ /s$/ ? substr(room, 1, length(room) - 1) : room
}
{
    object = $1; sub(/:$/, "", object); name = $2
    n = split(object, part, "/")
    room = part[n - 1]
    file = part[n]; sub(/\.o$/, "", file); sub(/^lib[a-z0-9]*_a-/, "", file)
    gsub(/-/, "_", file)
    if (name ~ /^__/) next
    seen++
    if (!starts(name, file) && !starts(name, room) && !starts(name, singular(room)) &&
        !declared(name, room)) {
        printf "%s: %s starts with the name of no header of %s/, nor with %s_ or %s_\n",
               object, name, room, file, room
        bad++
    }
}
END {
    printf "name-rule: %d global names, %d violations\n", seen, bad
    exit seen == 0 ? 99 : bad > 0
}'
