#!/bin/sh
# memory-faults-long.sh -- tests/memory-faults.sh with a thousand cases of each kind.
CASES=1000
export CASES
. "${top_srcdir:-.}/tests/memory-faults.sh"
