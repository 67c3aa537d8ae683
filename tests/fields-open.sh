#!/bin/sh
# fields-open.sh -- does VTK 9.1 of Debian 12 open the particle fields?
#
# The unit test of the room output writes a sample series, tests/fields-open.py reads it
# with VTK and what it saw is compared here.  Skipped (77) when no Python has VTK:
#
#   apt-get install python3-vtk9
. "${top_srcdir:-.}/tests/lib.sh"
set +e # it looks at what fails

"$top_builddir/tests/unit/output" sample "$out" || { echo 'fields-open: no sample series'; exit 99; }

status=77
for python in /usr/bin/python3 python3; do
    command -v "$python" >/dev/null || continue
    "$python" "$top_srcdir/tests/fields-open.py" "$out" >"$out/seen"
    status=$?
    [ $status = 77 ] || break
done
[ -f "$out/seen" ] && cat "$out/seen"
[ $status = 77 ] && skip 'there is no VTK for Python here'
[ $status = 0 ] || { echo 'fields-open: FAILED'; exit 1; }

# Three moments of 30 particles: pressure of particle i at moment k is 10 i + k.
for k in 0 1 2; do
    grep -q "^hdf t=0\\.*[0-9]* particles=30 cells=30 pressure=$k\\.\\.$((290 + k)) " \
        "$out/seen" || { echo "fields-open: moment $k is not what was written"; exit 1; }
done
echo 'fields-open: VTK reads what was written'
