#!/bin/sh
# page.sh -- runs cases and writes doc/validation.md: a row a claim, a section and a figure a case.
#
# Run by `make validation'; `make validation CASES="A01 C03"' runs these only and takes the rows
# of the others as they were kept.  A case with a line `# Long' in its head is run when it is
# named.
#     page.sh BUILD-DIRECTORY CASE.sh...
set -eu
top=$(cd "${top_srcdir:-.}" && pwd)
build=$1
shift
here=$top/tests/validation
page=$top/doc/validation.md
failed=0

# wanted CASE FILE
wanted() {
    case " ${CASES-} " in
    '  ') ! grep -q '^# Long' "$2" ;;
    *" $1 "*) true ;;
    *) false ;;
    esac
}

for file; do
    case=$(basename "$file" .sh)
    wanted "$case" "$here/$case.sh" || continue
    rm -f "$build/$case/rows"
    VALIDATION_OUT=$build/$case sh "$here/$case.sh" || failed=1
    if ! [ -f "$build/$case/rows" ]; then
        echo "$case: its run failed, the page keeps what it had" >&2
        failed=1
        continue
    fi
    cp "$build/$case/rows" "$here/rows/$case.rows"
    for figure in "$build/$case/$case"*.png; do
        [ ! -f "$figure" ] ||
            cp "$figure" "$top/doc/img/validation-$(basename "$figure")"
    done
done

# head FILE: its comment without the marks
head_of() {
    awk 'NR == 1 { next } !/^#/ { exit } { sub(/^# ?/, ""); print }' "$1"
}

{
    cat "$here/page.head"
    echo
    echo '| case | what | reference | here | mark | | cost |'
    echo '| --- | --- | --- | --- | --- | --- | --- |'
    for file; do
        case=$(basename "$file" .sh)
        [ ! -f "$here/rows/$case.rows" ] || sed 's/^/| /; s/$/ |/' "$here/rows/$case.rows"
    done
    for file; do
        case=$(basename "$file" .sh)
        echo
        head_of "$here/$case.sh" | sed '1s/^[^ ]* -- \(.*\)$/## '"$case"': \1/; /^Long/d'
        for figure in "$top/doc/img/validation-$case.png" "$top/doc/img/validation-$case-"[a-z]*.png; do
            [ ! -f "$figure" ] || printf '\n![%s](img/%s)\n' "$case" "$(basename "$figure")"
        done
    done
} >"$page.new"
mv "$page.new" "$page"
exit $failed
