#!/bin/sh
# register.sh -- the automake of all tests, made of tests/tests.list.
#
#     tests/register.sh write   writes tests/tests.am
#     tests/register.sh         fails when tests/tests.am is not what it would write, or when a
#                               program that is there is not in the list
#
# `make' runs the first when the list has changed, `make check' the second.  tests.am is kept
# with the sources, so that a checkout needs nothing but autoreconf.
set -u
cd "${top_srcdir:-$(dirname "$0")/..}" || exit 99
list=tests/tests.list
made=tests/tests.am

refuse()
{
    echo "$list: $*" >&2
    exit 1
}

# straight FILE: without ..
straight()
{
    echo "$1" | sed 's|[^/]*/\.\./||g'
}

# headers FILE...: those of tests/ that they include, and what these include
headers()
{
    for file; do
        for name in $(sed -n 's/^ *# *include *"\(.*\)".*/\1/p' "$file"); do
            name=$(straight "$(dirname "$file")/$name")
            case $name in
            tests/*.h)
                [ -f "$name" ] || continue
                echo "$name"
                headers "$name" ;;
            esac
        done
    done | sort -u
}

# flags WORD...: for the linker, of wrap=FUNCTION,...
flags()
{
    for word; do
        case $word in
        wrap=*) echo "$word" | sed 's/,/ -Wl@--wrap=/g; s/^wrap=/ -Wl@--wrap=/; s/@/,/g' ;;
        esac
    done
}

# brought DIMENSION WORD...: libraries that come before the house's, of with=NAME
brought()
{
    dimension=$1
    shift
    for word; do
        case $word in with=*) printf '$(%s%s_libs) ' "${word#with=}" "$dimension" ;; esac
    done
}

# sources DIRECTORY WORD...: the others
sources()
{
    directory=$1
    shift
    for word; do
        case $word in
        wrap=* | with=*) ;;
        *)
            for file in "$directory"/$word; do
                [ -f "$file" ] || refuse "there is no $file"
                straight "$file"
            done ;;
        esac
    done
}

# one NAME DIMENSION FLAGS WORDS SOURCE...: a program
one()
{
    name=$1 dimension=$2 flags=$3 words=$4
    shift 4
    canonical=$(echo "$name" | tr -c 'a-zA-Z0-9\n' _)
    echo "check_PROGRAMS += $name"
    echo "${canonical}_SOURCES =" "$@"
    [ "$dimension" = - ] || echo "${canonical}_CPPFLAGS = \$(dim${dimension}_cppflags)"
    [ -z "$flags" ] || echo "${canonical}_LDFLAGS = \$(AM_LDFLAGS)$flags"
    case $dimension in
    -) echo "${canonical}_LDADD = \$(common_libs) \$(test_libs)" ;;
    *)
        # shellcheck disable=SC2086 # words
        echo "${canonical}_LDADD = $(brought "$dimension" $words)\$(dim${dimension}_test_libs)" ;;
    esac
}

# parallel NAME DIMENSION WORDS SOURCE...: a program of MPI, which a script starts
parallel()
{
    name=$1 dimension=$2 words=$3
    shift 3
    canonical=$(echo "$name" | tr -c 'a-zA-Z0-9\n' _)
    echo "mpi_tests += $name"
    echo "${canonical}_SOURCES =" "$@" '$(mpi_sources)'
    echo "${canonical}_CPPFLAGS = \$(dim${dimension}_cppflags) \$(mpi_cppflags)"
    # shellcheck disable=SC2086 # words
    echo "${canonical}_LDADD = $(brought "$dimension" $words)\$(dim${dimension}_test_libs) \$(mpi_libs)"
}

# program NAME DIMENSIONS [WORD...]
program()
{
    name=tests/$1 dimensions=$2
    shift 2
    [ -f "$name.c" ] || refuse "there is no $name.c"
    files="$name.c $(sources "$(dirname "$name")" "$@")" || exit 1
    flags=$(flags "$@") words=$*
    # shellcheck disable=SC2086 # names of files have no blanks
    set -- $files $(headers $files)
    case $dimensions in
    - | 2 | 3) one "$name" "$dimensions" "$flags" "$words" "$@" ;;
    23)
        plain=$name
        one "${plain}2" 2 "$flags" "$words" "$@"
        one "${plain}3" 3 "$flags" "$words" "$@" ;;
    mpi2 | mpi3) parallel "$name" "${dimensions#mpi}" "$words" "$@" ;;
    *) refuse "$name: dimensions are -, 2, 3, 23, mpi2 or mpi3, not $dimensions" ;;
    esac
}

# script NAME WHEN
script()
{
    [ -f "tests/$1" ] || refuse "there is no tests/$1"
    case $2 in
    quick) echo "script_tests += tests/$1" ;;
    slow) echo "script_tests += tests/$1"; echo "slow_tests += tests/$1" ;;
    long) echo "long_tests += tests/$1" ;;
    *) refuse "tests/$1: quick, slow or long, not $2" ;;
    esac
}

write()
{
    echo '# tests.am -- made by tests/register.sh of tests/tests.list: change that one.'
    for file in tests/scenes/*.scene; do echo "EXTRA_DIST += $file"; done
    while read -r name what more; do
        case $name in
        '' | '#'*) ;;
        *.sh) script "$name" "$what" ;;
        *)
            set -f # patterns of names are not for here
            # shellcheck disable=SC2086 # words
            set -- $more
            set +f
            program "$name" "$what" "$@" ;;
        esac
    done <$list
}

# forgotten: programs that are there and not in the list
forgotten()
{
    for file in $(grep -l '^int main(' tests/*/*.c); do
        name=${file#tests/}
        grep -q "^${name%.c} " $list || echo "$file"
    done
}

text=$(write) || exit 1
if [ "${1-}" = write ]; then
    echo "$text" >$made
    exit
fi
status=0
echo "$text" | diff $made - ||
    { echo "register: $made is old: run tests/register.sh write, and keep what it writes"; status=1; }
for file in $(forgotten); do
    echo "register: $file is not in $list"
    status=1
done
echo "register: $(grep -c '^check_PROGRAMS' $made) programs, $(grep -c '^[^#]*\.sh ' $list) scripts"
exit $status
