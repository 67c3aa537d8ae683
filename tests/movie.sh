#!/bin/sh
# movie.sh -- `movie' makes a frame of each particle file, joined by ffmpeg where there is one, else by
# gnuplot alone.  Run by `make check'.
. "${top_srcdir:-.}/tests/lib.sh"
set +e
command -v gnuplot >/dev/null || skip 'there is no gnuplot'
cd "$out" || exit 99
"$STIFFWATER" run "$top_srcdir/data/scenes/toth-beam.scene" spacing=0.01 until=0.1 \
    output.fields=0.02 output.snapshots=0 -q -o beam >beam.said 2>&1 || wrong 'the run comes to its end'

# Programs without ffmpeg.
mkdir bin
ln -s "$(command -v gnuplot)" bin/gnuplot
PATH=$out/bin "$STIFFWATER" movie beam >gif.said 2>&1
claim 'without ffmpeg' "$? == 0"
prints gif 'beam/movie.gif'
[ "$(head -c 6 beam/movie.gif)" = GIF89a ] && good 'it is a GIF' || wrong 'it is a GIF'
# a graphic control extension stands before each frame
frames=$(od -An -v -tx1 beam/movie.gif | tr -d ' \n' | grep -o '0021f904' | wc -l)
claim 'with a frame for each of 6 files' "$frames == 6"
if command -v ffmpeg >/dev/null; then
    "$STIFFWATER" movie beam >webm.said 2>&1
    claim 'with ffmpeg' "$? == 0"
    [ -s beam/movie.webm ] && [ ! -e beam/movie.gif ] && good 'one movie' || wrong 'one movie'
    frames=$(ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of csv=p=0 \
        beam/movie.webm)
    claim 'with a frame for each of 6 files' "${frames:-0} == 6"
fi
[ -z "$(ls -d beam/.figures* 2>/dev/null)" ] && good 'nothing is left over' ||
    wrong 'nothing is left over'

# Bodies without a particle are shown, too.
"$STIFFWATER" run "$top_srcdir/data/scenes/block-heap.scene" until=0.2 output.snapshots=3 output.fields=0.05 \
    -q -o heap >heap.said 2>&1 || wrong 'bodies without water come to their end'
claim 'bodies without water have snapshots' "$(grep -c snapshots/ heap/snapshots.csv) == 3"
claim 'each with faces of ten blocks' "$(awk -F, '/^[-0-9]/ { n[$7] } END { print length(n) }' \
    heap/snapshots/0002-bodies.csv) == 10"
claim 'no grid of no particles is in the index' "$(grep -c 'Name="particles"' heap/fields.xdmf) == 0"
"$STIFFWATER" plot heap >drawn.said 2>&1
claim 'they are drawn' "$? == 0"
prints drawn view.png floor.png dye.png
claim 'but no pressure' "$(grep -c pressure.png drawn.said) == 0"
PATH=$out/bin "$STIFFWATER" movie heap >heap.said 2>&1
claim 'and move' "$? == 0"
claim 'in each of 5 frames' \
    "$(od -An -v -tx1 heap/movie.gif | tr -d ' \n' | grep -o '0021f904' | wc -l) == 5"
# Faces from above: each looks up, and none is lower than the one before.
claim 'from above the low ones come first' "$(awk -F, '/^[-0-9]/ { if ($6 <= 0) bad++; if (!on || $3 > top) top = $3
        on = 1; next } on { if (top < before) bad++; before = top; on = 0 } END { print bad + 0 }' \
    heap/figures/floor-bodies-1.csv) == 0"

# --- what it refuses ----------------------------------------------------------------------------
go few "$top_srcdir/tests/scenes/small-2d.scene" until=0.001
"$STIFFWATER" movie few >few.said 2>&1
claim 'one file is no movie' "$? == 2"
prints few 'output.fields'
printf 'no HDF5' >beam/fields/000002.vtkhdf
"$STIFFWATER" movie beam >bad.said 2>&1
claim 'a damaged file is told' "$? == 4"
prints bad '000002.vtkhdf'
finish
