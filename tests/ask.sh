# ask.sh -- what cli.sh and compare.sh share: they read it with `.`, $script and $scenes being
# set.  It leaves them in a new directory, removed at the end, with $failed and $tried at 0.
stiffwater=${STIFFWATER:-${top_builddir:-.}/stiffwater}
case $scenes in /*) ;; *) scenes=$(pwd)/$scenes ;; esac
case $stiffwater in /*) ;; *) stiffwater=$(pwd)/$stiffwater ;; esac
directory=$(mktemp -d) || exit 99
trap 'chmod -R u+w "$directory"; rm -rf "$directory"' EXIT
cd "$directory" || exit 99
failed=0
tried=0

complain()
{
    failed=$((failed + 1))
    echo "$script: $*"
    sed 's/^/    /' said
}

# expect STATUS WORD ...: runs the words behind $ask; what is said is in the file `said'.
expect()
{
    wanted=$1
    shift
    # shellcheck disable=SC2086 # words
    timeout 300 "$stiffwater" $ask "$@" >said 2>&1 </dev/null
    found=$?
    what=$*
    tried=$((tried + 1))
    [ $found = "$wanted" ] || complain "$what: exit status $found instead of $wanted"
}

# says PATTERN ...: the last answer holds each of them.
says()
{
    for pattern in "$@"; do
        grep -q -F -e "$pattern" said || complain "$what: \"$pattern\" is not said"
    done
}
