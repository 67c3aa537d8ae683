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
