#!/bin/sh
# kill-long.sh -- tests/kill.sh with fifty kills.
KILLS=50
export KILLS
. "${top_srcdir:-.}/tests/kill.sh"
