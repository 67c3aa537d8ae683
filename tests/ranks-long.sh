#!/bin/sh
# ranks-long.sh -- tests/ranks.sh with 8 ranks, too, longer runs, and more scenes and methods.
RANKS_LONG=1
export RANKS_LONG
. "${top_srcdir:-.}/tests/ranks.sh"
