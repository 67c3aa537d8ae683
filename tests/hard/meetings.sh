#!/bin/sh
# meetings.sh -- solids that meet while a run goes on, and linear beams that bend too far: the
# run ends with the names of both and the time; what is allowed goes on.
. "$top_srcdir/tests/lib.sh"

# --- linear beams ------------------------------------------------------------------------
# bend NAME SHARE: a cantilever of 0.08 m, EI = 2.6667 N m, with a force at its tip that would
# hold it at SHARE of its length; let go at once, it swings by twice that
bend() {
    force=$(awk "BEGIN { print $2 * 3 * 0.5e9 * 4e-3 ^ 3 / 12 / 0.08 ^ 2 }")
    go "$1" "$top_srcdir/data/scenes/beam-alone.scene" beam.plate.tip_force="$force" ${3-}
}
bend little 0.04
claim 'a beam that bends by 8 % runs' "$code == 0"
quiet little
bend some 0.07
claim 'a beam that bends by 14 % runs' "$code == 0"
prints some 'beam.plate has bent by 10' 'theory = "elastica"'
claim 'and is warned of once' "$(grep -c 'has bent' "$out/some.said") == 1"
bend far 0.12
claim 'a beam that bends by 24 % ends the run' "$code == 1"
prints far 'beam.plate has bent by 20' 'of its length at t = ' 'set theory = "elastica"'
claim 'at a fifth' "$(most far beam plate.tip_x) < 0.21 * 0.08"
bend asked 0.12 beam.plate.theory=linear
claim 'unless its scene says linear' "$code == 0"
# Twice as long as until a fifth; with STIFFWATER_LONG to the end of the scene.
until=$(awk "BEGIN { print 2 * $(number far t_end) }")
[ -z "${STIFFWATER_LONG-}" ] && until="until=$until" || until=
bend elastica 0.12 "beam.plate.theory=elastica $until"
claim 'an elastica bends on' "$code == 0 && $(most elastica beam plate.tip_x) > 0.21 * 0.08"
quiet elastica

# --- solids that meet ----------------------------------------------------------------------
# A soft plate in still air beside a post and another plate: a force at its tip bends it there.
lone() {
    cat <<EOF
title = "Plates beside a post";
dimension = 2;
gravity = [0.0, -9.81];
until = 0.3;
spacing = 0.01;
domain = { from = [0.0, 0.0]; to = [0.6, 0.4]; };
fluid = { puddle = { from = [0.0, 0.0]; to = [0.05, 0.02]; }; };
wall = { tank = { type = "frame"; }; $1 };
beam = { plate = { theory = "elastica"; at = [0.3, 0.0]; length = 0.2; thickness = 4e-3;
    E = 1e8; mass = 0.8; layers = 3; tip_force = $2; }; $3 };
effects = { continuity = { }; pressure = { }; artificial-viscosity = { }; };
EOF
}
post='post = { from = [0.22, 0.05]; to = [0.26, 0.2]; };'
twin='twin = { theory = "elastica"; at = [0.24, 0.0]; length = 0.2; thickness = 4e-3;
    E = 1e8; mass = 0.8; layers = 3; };'

# met NAME WORDS...: the run ends early, with status 1, and says so
met() {
    go "$1" "$out/$1.scene"
    claim "$1 ends the run" "$code == 1 && $(number "$1" t_end) > 0.01 && $(number "$1" t_end) < 0.3"
    prints "$@"
}
lone "$post" 4 '' >"$out/wall.scene"
met wall 'beam.plate has met wall.post: at t = ' 'No contact'
lone '' 6 "$twin" >"$out/beam.scene"
met beam 'beam.plate has met beam.twin: at t = '
lone "$post velocity = [0, 0]" 0 '' | sed 's/; }; velocity = .0, 0./; velocity = [0.5, 0.0]; };/' >"$out/gate.scene"
met gate 'beam.plate has met wall.post'
lone "$post" -4 "" >"$out/away.scene"
go away "$out/away.scene"
claim 'a plate that bends the other way meets nothing' "$code == 0"
quiet away
# At its hinge a plate turns into the floor, which holds it.
lone '' 4 '' | sed 's/theory = "elastica"; at/theory = "elastica"; root = "pinned"; at/' \
    >"$out/hinge.scene"
go hinge "$out/hinge.scene" until=0.15
claim 'a hinge in the floor is no meeting' "$code == 0"
claim 'though the plate turns by a half' "$(most hinge beam plate.tip_angle) > 0.5"
finish
