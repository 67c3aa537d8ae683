#!/bin/sh
# commit-subjects.sh -- the first line of a commit has at most 72 characters, begins with a
# capital letter and ends without a full stop.
#
# Looks at the commits of HEAD since this rule, but for merges; of a shallow clone at those that
# are there.  Skipped (77) where there is no git or no history.  Run by .ci/run, or by hand.
LC_ALL=C.UTF-8
export LC_ALL
cd "${top_srcdir:-$(dirname "$0")/..}" || exit 99

rule=3f22fa917ce1      # the last commit before it,
rule_date=1795356169   # committed then [s]

skip() {
    echo "commit-subjects: skipped, $1"
    exit 77
}

command -v git >/dev/null || skip 'there is no git'
[ "$(git rev-parse --show-toplevel 2>/dev/null)" = "$(pwd -P)" ] || skip 'this is no checkout'
git rev-parse -q --verify HEAD >/dev/null || skip 'there is no commit'

# The start of a shallow clone hides what came before the rule, so dates tell.
if [ "$(git rev-parse --is-shallow-repository)" = true ]; then
    range=HEAD
    after=$rule_date
else
    git rev-parse -q --verify "$rule^{commit}" >/dev/null || skip "there is no commit $rule"
    range=$rule..HEAD
    after=0
fi

bad=0
list=$(mktemp) || exit 99
trap 'rm -f "$list" "$list.all"' EXIT
git log --no-merges --format='%ct %h %s' "$range" >"$list.all" || exit 99
awk -v after=$after '$1 > after { sub(/^[0-9]* /, ""); print }' "$list.all" >"$list" || exit 99
count=$(wc -l <"$list")

# complain WHY OPTION... PATTERN: of subjects that match; a commit's name stands before each
complain() {
    why=$1
    shift
    grep "$@" "$list" || return 0
    echo "^ $why"
    bad=$((bad + $(grep -c "$@" "$list")))
}
complain 'more than 72 characters' '^[0-9a-f]* .\{73\}'
complain 'does not begin with a capital letter' -v '^[0-9a-f]* [[:upper:]]'
complain 'ends with a full stop' '\.$'

echo "commit-subjects: $count commits, $bad complaints"
[ $bad = 0 ]
