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
order=$(mktemp) || exit 99
trap 'rm -f "$order"' EXIT

# The automake on standard output.  One awk, as a process for every header took a minute.
write()
{
    echo '# tests.am -- made by tests/register.sh of tests/tests.list: change that one.'
    for file in tests/scenes/*.scene; do echo "EXTRA_DIST += $file"; done
    awk '
    function refuse(words) { print FILENAME ": " words >"/dev/stderr"; bad = 1; exit }

    function there(file,    line, found)
    {
        found = (getline line <file) >= 0
        close(file)
        return found
    }

    # without ..
    function straight(file) { sub(/[^\/]*\/\.\.\//, "", file); return file }

    # to among[]: headers of tests/ that a file includes, and what these include
    function headers(file, among,    line, name, names, n, i)
    {
        while ((getline line <file) > 0)
            if (line ~ /^ *# *include *"/) {
                split(line, name, "\"")
                names[++n] = name[2]
            }
        close(file)
        for (i = 1; i <= n; i++) {
            line = file
            sub(/[^\/]*$/, "", line)
            line = straight(line names[i])
            if (line ~ /^tests\/.*\.h$/ && !(line in among) && there(line)) {
                among[line] = 1
                headers(line, among)
            }
        }
    }

    # sorted and joined
    function joined(among,    name, text, sort, line)
    {
        sort = "LC_ALL=C sort >" order
        printf "" | sort # an empty file of none
        for (name in among) print name | sort
        close(sort)
        while ((getline line <order) > 0) text = text " " line
        close(order)
        return text
    }

    # the files of a word that may be a pattern
    function files(pattern,    text, line, list)
    {
        if (pattern !~ /[*?]/) {
            if (!there(pattern)) refuse("there is no " pattern)
            return " " straight(pattern)
        }
        list = "ls " pattern
        while ((list | getline line) > 0) text = text " " straight(line)
        close(list)
        if (text == "") refuse("there is no " pattern)
        return text
    }

    # a program: kind is -, 2, 3, mpi2 or mpi3
    function program(name, kind, sources, flags, with,    dim, own, mpi)
    {
        mpi = sub(/^mpi/, "", kind)
        dim = kind == "-" ? "" : "dim" kind
        own = name
        gsub(/[^a-zA-Z0-9]/, "_", own)
        print (mpi ? "mpi_tests" : "check_PROGRAMS") " += " name
        print own "_SOURCES =" sources (mpi ? " $(mpi_sources)" : "")
        if (dim != "") print own "_CPPFLAGS = $(" dim "_cppflags)" (mpi ? " $(mpi_cppflags)" : "")
        if (flags != "") print own "_LDFLAGS = $(AM_LDFLAGS)" flags
        if (dim == "") print own "_LDADD = $(common_libs) $(test_libs)"
        else
            print own "_LDADD = " (with == "" ? "" : "$(" with kind "_libs) ") \
                "$(" dim "_test_libs)" (mpi ? " $(mpi_libs)" : "")
    }

    /^#/ || NF == 0 { next }

    $1 ~ /\.sh$/ {
        if (!there("tests/" $1)) refuse("there is no tests/" $1)
        if ($2 !~ /^(quick|source|slow|long)$/)
            refuse("tests/" $1 ": quick, source, slow or long, not " $2)
        if ($2 != "long") print "script_tests += tests/" $1
        if ($2 != "quick") print $2 "_tests += tests/" $1
        next
    }

    {
        name = "tests/" $1
        room = name
        sub(/[^\/]*$/, "", room)
        if (!there(name ".c")) refuse("there is no " name ".c")
        sources = " " name ".c"
        flags = with = ""
        for (i = 3; i <= NF; i++)
            if (sub(/^with=/, "", $i)) with = $i
            else if (sub(/^wrap=/, "", $i)) { gsub(/,/, " -Wl,--wrap=", $i); flags = flags " -Wl,--wrap=" $i }
            else sources = sources files(room $i)
        split("", among)
        n = split(sources, file, " ")
        for (i = 1; i <= n; i++) headers(file[i], among)
        sources = sources joined(among)
        if ($2 == "23") {
            program(name "2", "2", sources, flags, with)
            program(name "3", "3", sources, flags, with)
        } else if ($2 ~ /^(-|2|3|mpi2|mpi3)$/) program(name, $2, sources, flags, with)
        else refuse(name ": dimensions are -, 2, 3, 23, mpi2 or mpi3, not " $2)
    }

    END { exit bad }' order="$order" $list
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
