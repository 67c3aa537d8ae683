#!/bin/sh
# another-type.sh -- another equation of state on the command line: keys of the file that belong to
# its own are left out with a warning, the scene that was used runs again to the same bits, and what
# is wrong by itself stays an error.  A default that only the run knows stands there as it was.
. "$top_srcdir/tests/lib.sh"
scenes=$(cd "$top_srcdir/data/scenes" && pwd)

# runs NAME KEY=VALUE...: with the other type, and again from what it used
runs() {
    scene=$1
    shift
    well "$scene" "$scenes/$scene.scene" eos.type=look-ahead "$@"
    prints "$scene" 'eos.type = "look-ahead" on the command line leaves out' 'belongs to "tait"' \
        "eos.gamma ($scenes/$scene.scene:"
    if sed -n '/^eos = /,/^}/p' "$out/$scene/scene.used" | grep -q gamma; then wrong "$scene: eos in scene.used has no gamma"
    else good "$scene: eos in scene.used has no gamma"; fi
    well again "$out/$scene/scene.used"
    quiet again
    if [ "$(hash "$scene")" = "$(hash again)" ]; then good "$scene: scene.used has the same bits"
    else wrong "$scene: scene.used has the same bits"; fi
    rm -r "$out/again"
}

runs still-water until=0.01
runs toth-beam until=0.003 walls=own-density
runs oscillating-drop until=0.05

# refused NAME WORDS KEY=VALUE...: exit status 2 with these words
refused() {
    words=$2
    name=$1
    shift 2
    go refused "$out/$name.scene" until=0.01 "$@"
    claim "$name $*: refused" "$code == 2"
    prints refused "$words"
}

cp "$scenes/still-water.scene" "$out/plain.scene"
sed 's/gamma = 7.0/gama = 7.0/' "$out/plain.scene" >"$out/typo.scene"
sed 's/gamma = 7.0/k = 400/' "$out/plain.scene" >"$out/stranger.scene"
sed 's/type = "tait"; //' "$out/plain.scene" >"$out/untold.scene"
refused typo 'unknown key eos.gama' eos.type=look-ahead
refused stranger 'unknown key eos.k ' eos.type=look-ahead
refused plain 'unknown key eos.gamma' eos.type=look-ahead eos.gamma=7
refused plain 'unknown key eos.gamma' eos.gamma=7 eos.type=look-ahead
refused plain 'eos.type' eos.type=look-ahed
well untold "$out/untold.scene" until=0.01 eos.type=linear
prints untold 'leaves out what belongs to "tait", the type without it: eos.gamma'
well same "$out/plain.scene" until=0.01 eos.type=tait
quiet same
well twice "$out/plain.scene" until=0.01 eos.type=linear eos.type=look-ahead
prints twice 'belongs to "tait"'

well filtered "$top_srcdir/tests/scenes/small-2d.scene" until=0.02 'effects.shepard-filter={}'
interval=$(sed -n '/shepard-filter/,/}/s/^ *interval = \(.*\);.*computed$/\1/p' "$out/filtered/scene.used")
claim "filtered: an interval of $interval s, 30 steps of sound" "${interval:-0} > 0.005 && ${interval:-0} < 0.008"
well again "$out/filtered/scene.used"
claim "filtered: the same bits" "\"$(hash filtered)\" == \"$(hash again)\""
finish
