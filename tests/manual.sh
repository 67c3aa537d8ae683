#!/bin/sh
# manual.sh -- the manual says what the program does: every label of an equation in the
# sources stands in doc/equations.md, every key that `explain' prints and every file that
# a run leaves stand in the man page, what a page names is there, and the code that
# doc/adding-a-part.md shows is that of files that are compiled and tested.
#
# Run by `make check'.
top=${top_srcdir:-.}
build=${top_builddir:-.}
. "$top/tests/lib.sh"
set +eu # it complains about all that fails

# --- labels ---------------------------------------------------------------------------------
# (D1), (BE2), (LF) are ours, (14) and (9) those of the work that this one started from;
# a number counts when it does not stand behind a name or another bracket, as in f(14).
labels=$(find "$top/src" -name '*.[ch]' -exec cat {} + |
    grep -o -E '(^|[^])A-Za-z0-9_])\(([A-Z]{1,2}[0-9]|LF|[1-9]|[1-4][0-9])\)' |
    sed 's/.*(/(/' | sort -u)
count=0
for label in $labels; do
    count=$((count + 1))
    case $label in
    '('[A-Z]*) head="^(\\*\\*|\\| )\\(${label#?}" ;;
    *) head="^\\|( \\([0-9]+\\),)* \\(${label#?}" ;;
    esac
    head=$(echo "$head" | sed 's/)$/\\)/')
    grep -q -E -e "$head" "$top/doc/equations.md" ||
        complain "$label stands in $(grep -r -l -F -e "$label" "$top/src" | head -n 3 | tr '\n' ' ')" \
            "but has no equation in doc/equations.md"
done
[ $count -gt 40 ] || complain "only $count labels are found in the sources"

# --- keys -----------------------------------------------------------------------------------
page=$build/stiffwater.1
[ -f "$page" ] || page=$top/stiffwater.1
sed 's/\\-/-/g; s/\\(ha/^/g; s/\\fR/ /g' "$page" >"$out/page" || exit 99

# stands NAME KEY: in bold, with its last component, below NAME where it is written so.
keys=0
stands()
{
    keys=$((keys + 1))
    case $1 in
    scene) tag=$2 ;;
    kernel | domain | reference | disturbance | eos | output | mps) tag=$1.$2 ;;
    rigid) tag=body.NAME.$2 ;;
    fluid | wall | probe | panel | contact | beam) tag=$1.NAME.$2 ;;
    *) tag="(effects\\.$1|eos|walls)\\.$2" ;;
    esac
    grep -q -E -e "^\\\\fB$tag " "$out/page" || complain "the man page lacks $2 of $1"
}

for dimension in 2 3; do
    program=$build/stiffwater-${dimension}d
    names='scene kernel domain reference disturbance eos fluid wall probe panel output mps'
    for table in effects eos walls bodies; do
        names="$names $("$program" list $table | awk '{ print $1 }')"
    done
    for name in $names; do
        "$program" explain "$name" >"$out/told" || complain "explain $name fails"
        for key in $(awk '/^  [A-Za-z]/ && / (required|default)/ { print $1 }' "$out/told"); do
            stands "$name" "$key"
        done
    done
done
for table in kernels methods; do
    for name in $("$STIFFWATER" list $table | awk '{ print $1 }'); do
        grep -q -F -e "\\fB$name " "$out/page" || complain "the man page lacks $name"
    done
done
for word in $("$STIFFWATER" run --help | grep -o -E -e '--[a-z]+' | sort -u); do
    case $word in
    --help | --usage | --version) ;;
    *) grep -q -F -e "$word" "$out/page" || complain "the man page lacks $word" ;;
    esac
done
[ $keys -gt 100 ] || complain "only $keys keys are asked for"

# --- files of a run, and how the page looks ------------------------------------------------------
"$STIFFWATER" run "$top/tests/scenes/small-2d.scene" -q until=0.002 -o "$out/run" \
    >"$out/told" 2>&1 || complain "the small scene fails: $(cat "$out/told")"
for file in "$out"/run/*; do
    grep -q -F -e "${file##*/}" "$out/page" ||
        complain "a run leaves ${file##*/}, which the man page does not name"
done
if command -v groff >/dev/null; then
    groff -man -ww -Tutf8 "$page" 2>&1 >/dev/null | grep . && complain "groff warns of the man page"
fi

# --- what pages name --------------------------------------------------------------------------
pages="$top/README.md $top/CONTRIBUTING.md $(echo "$top"/doc/*.md)"
effect=$(sed -n 's,^/\* \([a-z-]*\)\.c -- .*,\1,p' "$top/doc/adding-a-part.md" | head -n 1)

# Paths with a directory of ours, in quotes or links; NAME is none, wildcards must find something.
# shellcheck disable=SC2086 # paths have no blanks
for path in $(grep -h -o -E '[(` ](src|tests|doc|data|plots|bench|m4|build-aux)/[A-Za-z0-9_./*-]+' $pages |
    sed 's/^.//; s/[.,]$//' | grep -v -E 'NAME|ROOM|PREFIX|CASE' | sort -u); do
    case $path in *"/$effect"* | *.log) continue ;; esac
    ls $top/$path >"$out/there" 2>&1 || grep -q -w -e "$path" "$top"/tests/tests.am ||
        complain "$path is named in $(grep -l -F -e "$path" $pages | tr '\n' ' ')but is not there"
done

# Names of files without their directory, and of tests and functions.
find "$top" -name '*.[ch]' -o -name '*.sh' -o -name '*.am' -o -name '*.scene' -o -name '*.md' |
    sed 's,.*/,,' | sort -u >"$out/files"
# shellcheck disable=SC2086
for name in $(grep -h -o -E '`[a-z0-9-]+\.(c|h|sh|am|scene|md)`' $pages | tr -d '`' | sort -u); do
    case $name in "$effect".* | sweep.md) continue ;; esac # that which sweep leaves
    # shellcheck disable=SC2086
    grep -q -F -e "Save it as \`$name\`" $pages && continue # a file of the reader
    grep -q -x -F -e "$name" "$out/files" || complain "$name is named but is not there"
done
# shellcheck disable=SC2086
for name in $(grep -h -o -E '`[a-z0-9]+_[a-z0-9]+_[a-z0-9_]+`' $pages | tr -d '`' | sort -u); do
    grep -r -q -w -e "$name" "$top/src" "$top/tests" || complain "$name is named but is not there"
done

# --- the code of doc/adding-a-part.md -------------------------------------------------------
# Each block of C stands, line for line, in a file that is compiled and tested; one that begins
# with the head of a file is all of it.
mkdir "$out/blocks"
awk -v to="$out/blocks/" '/^```/ { file = ""; if (/^```c$/) file = to (++n) ".c"; next }
    file { print >file }' "$top/doc/adding-a-part.md"
# holds FILE BLOCK
holds()
{
    awk 'NR == FNR { block = block "\n" $0; next } { text = text "\n" $0 }
        END { exit !index(text "\n", block "\n") }' "$2" "$1"
}
blocks=0
for block in "$out"/blocks/*.c; do
    [ -f "$block" ] || break
    blocks=$((blocks + 1))
    head=$(sed -n '1s,^/\* \([a-z-]*\.c\) -- .*,\1,p' "$block")
    if [ -n "$head" ]; then
        cmp -s "$block" "$top/tests/parts/$head" ||
            complain "tests/parts/$head is not as doc/adding-a-part.md shows it"
        continue
    fi
    found=
    for file in "$top"/tests/parts/*.c "$top/tests/unit/float.c" "$top/tests/unit/effects.c"; do
        holds "$file" "$block" && found=$file
    done
    [ -n "$found" ] || complain "doc/adding-a-part.md shows code that is in no file: $(head -n 2 "$block")"
done
[ $blocks -gt 10 ] || complain "doc/adding-a-part.md holds only $blocks blocks of code"

tried=$((count + keys + blocks))
finish
