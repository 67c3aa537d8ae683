#!/bin/sh
# study-home.sh -- directories of comparisons, sweeps and spreads have a mark of their kind; others'
# files stay, one kind does not take the directory of another, links are not followed.
. "${top_srcdir:-.}/tests/lib.sh"
scenes=$top_srcdir/tests/scenes
ask=
asking
scene=$scenes/small-2d.scene

# study KIND DIRECTORY OPTION...: fills the variable `words' with the shortest there is
study() {
    asked=$1
    dir=$2
    shift 2
    case $asked in
    comparison) words="compare $scene -u 0.001 -M imex2 -T 1 -R imex3:1" ;;
    sweep) words="sweep $scene -u 0.001 eos.c0=20,25" ;;
    spread) words="spread $scene -u 0.001 -N 2" ;;
    esac
    words="$words -q -o $dir $*"
}

# same WORDS DIRECTORY: nothing in it differs from DIRECTORY-before
same() {
    tried=$((tried + 1))
    diff -r --no-dereference "$2" "$2-before" >differ 2>&1 || complain "$1: $(cat differ)"
}

# shellcheck disable=SC2086 # words of a study
for kind in comparison sweep spread; do
    case $kind in comparison) file=compare.csv ;; *) file=$kind.csv ;; esac

    # --- the mark ---
    study $kind $kind
    expect 0 $words
    grep -q "^kind $kind\$" $kind/.stiffwater && grep -q '^scene small-2d.scene$' $kind/.stiffwater ||
        complain "the mark of a $kind does not say whose: $(cat $kind/.stiffwater)"
    grep -q '^kind run$' $kind/runs/*/.stiffwater || complain "runs of a $kind have no mark"
    expect 0 $words # again: what is there is its own

    # --- directories of others ---
    rm -rf theirs theirs-before
    mkdir theirs
    echo mine >theirs/$file
    echo mine >theirs/yours
    cp -r theirs theirs-before
    study $kind theirs
    expect 4 $words
    says 'theirs: there are files' "$file" "no $kind has left its mark" '--force'
    same "a refused $kind changes nothing" theirs
    expect 0 $words --force
    [ "$(cat theirs/yours)" = mine ] || complain "--force loses a file"
    [ "$(wc -l <theirs/$file)" = "$(wc -l <$kind/$file)" ] || complain "--force writes another $file"
    expect 0 $words
    mkdir -p hollow-$kind
    study $kind hollow-$kind
    expect 0 $words

    # --- one kind in the directory of another ---
    cp -r $kind $kind-before
    expect 4 run "$scene" -q until=0.001 -o $kind
    says "$kind: this directory is that of a $kind" '--force'
    for other in comparison sweep spread; do
        [ $other != $kind ] || continue
        study $other $kind
        expect 4 $words
        says "that of a $kind" "those of a $other"
    done
    same "others in the directory of a $kind" $kind
    [ -d plain ] || expect 0 run "$scene" -q until=0.001 -o plain
    rm -rf plain-before
    cp -r plain plain-before
    study $kind plain
    expect 4 $words
    says 'that of a run'
    same "a $kind in the directory of a run" plain

    # --- links ---
    echo theirs >victim
    rm -rf elsewhere
    mkdir elsewhere
    for name in $(cd $kind && ls) runs/"$(cd $kind/runs && ls | head -n 1)"; do
        rm -rf linked linked-before
        cp -r $kind linked
        rm -r "linked/$name"
        case $name in
        *.*) ln -s "$PWD/victim" "linked/$name" ;;
        *) ln -s "$PWD/elsewhere" "linked/$name" ;;
        esac
        cp -r linked linked-before
        study $kind linked
        case $name in runs/*) rm -f linked/runs/*/order ;; esac # so that they are made again
        expect 4 $words --force
        says "linked/$name is a symbolic link"
        case $name in runs/*) ;; *) same "a $kind with a link in place of $name" linked ;; esac
        [ "$(cat victim)" = theirs ] || complain "a $kind writes through $name"
        [ -z "$(ls elsewhere)" ] || complain "a $kind writes through $name"
    done
    for said in $kind/runs/*/said; do
        rm -f $said $(dirname $said)/order
        ln -s "$PWD/victim" $said
    done
    study $kind $kind
    expect 0 $words
    [ "$(cat victim)" = theirs ] || complain "a $kind writes through said"
done
finish
