#!/bin/sh
# hull.sh -- `hull' makes the points of a hull from STL files in words and in bytes, which a scene
# takes as they are, and refuses what is no such file.  Run by `make check'.
. "${top_srcdir:-.}/tests/lib.sh"
set +e
cd "$out" || exit 99

# bytes VALUE...: numbers of four bytes, lowest first; 0, 1, 2 and 3 are all that is asked for
bytes() {
    for value; do
        case $value in
        0) printf '\000\000\000\000' ;;
        1) printf '\000\000\200\077' ;;
        2) printf '\000\000\000\100' ;;
        3) printf '\000\000\100\100' ;;
        esac
    done
}

# A wedge of 3 x 2 x 1: half of a box.
words() {
    echo 'solid wedge'
    while read -r a b c d e f g h i; do
        printf 'facet normal 0 0 0\n outer loop\n  vertex %s %s %s\n  vertex %s %s %s\n  vertex %s %s %s\n' \
            "$a" "$b" "$c" "$d" "$e" "$f" "$g" "$h" "$i"
        printf ' endloop\nendfacet\n'
    done
    echo 'endsolid wedge'
}
cat >triangles <<END
0 0 0 0 2 0 3 2 0
0 0 0 3 2 0 3 0 0
0 0 0 3 0 0 3 0 1
0 2 0 3 2 1 3 2 0
3 0 0 3 2 0 3 2 1
3 0 0 3 2 1 3 0 1
0 0 0 3 0 1 3 2 1
0 0 0 3 2 1 0 2 0
END
words <triangles >words.stl
{
    printf 'solid that is none%62s' ''
    printf '\010\000\000\000'
    while read -r line; do
        bytes 0 0 0
        # shellcheck disable=SC2086 # nine numbers
        bytes $line
        printf '\000\000'
    done <triangles
} >bytes.stl
claim 'the file of bytes is as long as it says' "$(wc -c <bytes.stl) == 84 + 8 * 50"

"$STIFFWATER" hull words.stl >words.said 2>&1
claim 'hull of words' "$? == 0"
prints words '8 triangles; 6 corners and 5 faces here, 3 m^3, 17.3246 m^2' 'centre is (2, 1, 0.333333)' \
    'points = (' '[3, 2, 1]'
"$STIFFWATER" hull bytes.stl >bytes.said 2>&1
claim 'hull of bytes' "$? == 0"
sed 's/bytes.stl/words.stl/' bytes.said | cmp -s - words.said && good 'both are one' || wrong 'both are one'

"$STIFFWATER" hull words.stl --scale 0.1 >wedge.points
cat >wedge.scene <<END
dimension = 3;
gravity = [0.0, 0.0, -9.81];
until = 0.01;
spacing = 0.05;
domain = { from = [-1.0, -1.0, 0.0]; to = [1.0, 1.0, 1.0]; };
body = {
    wedge = {
        shape = "hull"; at = [0.0, 0.0, 0.2]; density = 500.0;
        @include "wedge.points"
    };
};
END
well wedge wedge.scene
z=$(sed -n '/^t/{n;p;}' wedge/bodies.csv | cut -d, -f4)
claim 'a scene takes it, its centre where it was' "$z > 0.2333 && $z < 0.23334"

"$STIFFWATER" hull words.stl --merge 1.1 >merged.said 2>&1
claim 'corners a metre apart made one' "$? == 2"
prints merged 'lie in one plane' '--merge'
head -c 300 bytes.stl >cut.stl
"$STIFFWATER" hull cut.stl >cut.said 2>&1
claim 'a file that was cut off' "$? == 2"
echo 'vertex' >none.stl
"$STIFFWATER" hull none.stl >none.said 2>&1
claim 'a file that is no STL' "$? == 2"
prints none 'it is no STL file'
{ echo 'solid'; echo 'vertex 1 2 three'; } >three.stl
"$STIFFWATER" hull three.stl >three.said 2>&1
claim 'a corner that is no number' "$? == 2"
prints three 'not followed by three numbers'
"$STIFFWATER" hull nowhere.stl >nowhere.said 2>&1
claim 'no file' "$? == 4"
finish
