#!/bin/sh
# structure.sh -- how large things may be, and that files of a room form no circle.
#
# In src/:
#   a file has at most 300 lines, a function 45;
#   a struct has at most 25 members that are no keys of a scene (a member is a key when a row
#     of a table of `struct param` gives its offset);
#   a contract, which is a struct in a header with three or more pointers to functions, has
#     at most 15 members;
#   no header includes itself by way of others;
#   no files of a room call each other in a circle.
#
# A file calls another of its room when its object asks for a function, or a variable without
# initialiser, that the other defines (nm).  A file that includes a header for its types or its inline
# functions calls nothing.  Nor does a table call the const structs that it lists: that is a
# contract with its implementations, which may call what stands beside the table.
#
# Run by `make check`, or by hand in a build tree with top_srcdir=PATH.
sources=$(cd "${top_srcdir:-..}" && pwd) || exit 99
objects=$(cd "${top_builddir:-.}" && find "$(pwd)/src" -mindepth 2 -name '*.o' | sort)
[ -n "$objects" ] || { echo "structure: no objects below src: run make first"; exit 99; }
cd "$sources" || exit 99
files=$(find src -name '*.[ch]' | LC_ALL=C sort)
out=$(mktemp -d) || exit 99
trap 'rm -rf "$out"' EXIT
bad=0

# --- sizes and headers --------------------------------------------------------------------
# shellcheck disable=SC2086 # names of sources have no blanks
LC_ALL=C awk '
function complain(where, text) {
    printf "%s: %s\n", where, text
    bad++
}
function strip(line,    clean, at) {   # without comments and texts
    clean = ""
    while (line != "") {
        if (comment) {
            at = index(line, "*/")
            if (!at) return clean
            line = substr(line, at + 2); comment = 0
        } else if (match(line, /\/\*|\/\/|"(\\.|[^"\\])*"|\047(\\.|[^\047\\])*\047/)) {
            clean = clean substr(line, 1, RSTART - 1) " "
            at = substr(line, RSTART, 2)
            line = at == "//" ? "" : substr(line, RSTART + (at == "/*" ? 2 : RLENGTH))
            if (at == "/*") comment = 1
            else if (at != "//") clean = clean "0"
        } else {
            return clean line
        }
    }
    return clean
}
function name_of(head) {                # of the function with this head
    if (match(head, /LANE_NAME\([a-z_0-9]*\)/)) return substr(head, RSTART + 10, RLENGTH - 11)
    sub(/[ \t]*\(.*/, "", head); sub(/.*[^A-Za-z_0-9]/, "", head)
    return head
}
function enter(    head) {
    head = text[depth]; sub(/[ \t]+$/, "", head)
    paren[depth] = parens; parens = 0; depth++
    text[depth] = ""; members[depth] = commas[depth] = 0; list[depth] = ""
    start[depth] = begun[depth - 1]; kind[depth] = "other"; called[depth] = ""
    if (head ~ /(^|[^A-Za-z_0-9])(struct|union)([ \t]+[A-Za-z_0-9]+)?$/ && head !~ /[(=]/) {
        kind[depth] = "struct"; called[depth] = head; sub(/.*(struct|union)[ \t]*/, "", called[depth])
        start[depth] = FNR
    } else if (depth == 1 && head ~ /\)$/ && head !~ /=/) {
        kind[depth] = "function"; called[depth] = name_of(head)
    }
}
function member(    n) {                # a declaration of a struct ends
    if (text[depth] ~ /^[ \t]*$/ || text[depth] ~ /^[ \t]*_Static_assert/) return
    if (text[depth] ~ /^[ \t]*@[0-9]+@[ \t]*$/) {
        n = text[depth]; gsub(/[^0-9]/, "", n)      # a nameless struct: its members are here
        members[depth] += n; return
    }
    members[depth] += 1 + commas[depth]
    list[depth] = list[depth] SUBSEP 1 + commas[depth] " " text[depth]
}
function leave(    n) {
    if (depth == 0) { complain(FILENAME ":" FNR, "a brace too many"); return }
    if (kind[depth] == "function") {
        n = FNR - start[depth] + 1; functions++
        if (n > 45) complain(FILENAME ":" start[depth], called[depth] "() has " n " lines, at most 45")
        if (n > longest) { longest = n; longest_name = called[depth] "(), " FILENAME ":" start[depth] }
    } else if (kind[depth] == "struct") {
        structs++
        struct_name[structs] = called[depth]; struct_at[structs] = FILENAME ":" start[depth]
        struct_members[structs] = members[depth]; struct_list[structs] = list[depth]
    }
    n = kind[depth] == "struct" ? "@" members[depth] "@" : ""
    depth--; parens = paren[depth]; text[depth] = n; commas[depth] = 0
}
function read(line,    token) {
    while (match(line, /[{}();,]/)) {
        add(substr(line, 1, RSTART - 1)); token = substr(line, RSTART, 1)
        line = substr(line, RSTART + 1)
        if (token == "{") enter()
        else if (token == "}") leave()
        else if (token == ";" && parens == 0) {
            if (kind[depth] == "struct") member()
            else if (depth == 0 && text[0] ~ /typedef.*\(/) types[name_of(text[0])] = 1
            text[depth] = ""; commas[depth] = 0
        } else {
            if (token == "(") parens++
            if (token == ")") parens--
            if (token == "," && parens == 0) commas[depth]++
            add(token)
        }
    }
    add(line " ")
}
function add(piece) {
    if (text[depth] ~ /^[ \t]*$/ && piece ~ /[^ \t]/) begun[depth] = FNR
    text[depth] = text[depth] piece
}
# Which members are keys: offsetof(struct X, member), or a macro that stands for it.
function note_keys(line,    rest, word, pair) {
    if (match(line, /^[ \t]*#[ \t]*define[ \t]+[A-Z_]+\([a-z_, ]*\).*offsetof\(struct [a-z_0-9]+/)) {
        word = line; sub(/^[ \t]*#[ \t]*define[ \t]+/, "", word); sub(/\(.*/, "", word)
        rest = line; sub(/.*offsetof\(struct /, "", rest); sub(/[^a-z_0-9].*/, "", rest)
        if (index(line, word "(" rest ",") > 0) rest = "*"
        macro[FILENAME, word] = rest
        if (FILENAME ~ /\.h$/) macro["", word] = rest
        return
    }
    if (line ~ /struct param [a-z_0-9]+\[\]/) in_table = 1
    if (line ~ /^}/) in_table = 0
    rest = in_table ? line : ""
    while (match(rest, /[A-Za-z_]+\((struct )?[a-z_0-9]+(, *[a-z_0-9.]+)?/)) {
        pair = substr(rest, RSTART, RLENGTH); rest = substr(rest, RSTART + RLENGTH)
        word = pair; sub(/\(.*/, "", word); sub(/^[^(]*\((struct )?/, "", pair)
        key_row(word, pair)
    }
}
function key_row(word, pair,    to, of) {
    to = (FILENAME, word) in macro ? macro[FILENAME, word] : macro["", word]
    if (word == "offsetof") to = "*"
    if (to == "") return
    of = to
    if (to == "*") { of = pair; sub(/,.*/, "", of); sub(/.*, */, "", pair) }
    else sub(/,.*/, "", pair)
    sub(/\..*/, "", pair)
    if (!((of, pair) in is_key)) { is_key[of, pair] = 1; keys[of]++ }
}
function end_file() {
    if (last == "") return
    if (depth || comment) complain(last, "braces or comments do not close: cannot be read")
    if (lines > 300) complain(last ":301", "has " lines " lines, at most 300")
    if (lines > most) { most = lines; most_name = last }
    total += lines
}
FNR == 1 {
    end_file(); last = FILENAME; depth = parens = comment = define = branch = in_table = 0
    text[0] = ""; commas[0] = 0; kind[0] = "file"; n_files++
}
{ lines = FNR; note_keys($0) }
!comment && /^[ \t]*#[ \t]*include[ \t]*"/ && FILENAME ~ /\.h$/ {
    split($0, quoted, "\""); includes[FILENAME] = includes[FILENAME] " src/" quoted[2]
    include_at[FILENAME, "src/" quoted[2]] = FNR
}
!comment && /^[ \t]*#[ \t]*if/ {       # each branch starts where the first one does
    branch++; depth_at[branch] = depth; parens_at[branch] = parens; text_at[branch] = text[depth]
}
!comment && /^[ \t]*#[ \t]*el/ {
    depth = depth_at[branch]; parens = parens_at[branch]; text[depth] = text_at[branch]
}
!comment && /^[ \t]*#[ \t]*endif/ { branch-- }
!comment && (define || /^[ \t]*#/) { define = $0 ~ /\\$/; next }
{ read(strip($0)) }

function is_pointer(declaration,    word) {
    if (declaration ~ /\([ \t]*\*[^)]*\)[ \t]*\(/) return 1
    for (word in types)
        if (declaration ~ ("(^|[^A-Za-z_0-9])" word "[ \t]*\\*")) return 1
    return 0
}
function judge_structs(    i, j, n, list, name, own, functions) {
    for (i = 1; i <= structs; i++) {
        name = struct_name[i] == "" ? "a nameless struct" : "struct " struct_name[i]
        own = struct_members[i] - keys[struct_name[i]]
        if (own > 25)
            complain(struct_at[i], name " has " own " members that are no keys, at most 25")
        if (own > widest) { widest = own; widest_name = name ", " struct_at[i] }
        n = split(struct_list[i], list, SUBSEP); functions = 0
        for (j = 1; j <= n; j++) if (is_pointer(list[j])) functions += list[j]
        if (struct_at[i] !~ /\.h:/ || functions < 3) continue
        contracts++; told = told "\n  " name " " struct_members[i]
        if (struct_members[i] > 15)
            complain(struct_at[i], "contract " name " has " struct_members[i] " members, at most 15")
    }
}
# Does a way through includes lead from one header to another?
function leads(from, to,    n, i, next_ones) {
    n = split(includes[from], next_ones, " ")
    for (i = 1; i <= n; i++) {
        if (next_ones[i] == to) return 1
        if ((to, next_ones[i]) in passed) continue
        passed[to, next_ones[i]] = 1
        if (leads(next_ones[i], to)) return 1
    }
    return 0
}
function judge_headers(    header, n, i, to) {
    for (header in includes) {
        n = split(includes[header], to, " ")
        for (i = 1; i <= n; i++) {
            split("", passed)
            if (to[i] == header || leads(to[i], header))
                complain(header ":" include_at[header, to[i]], "includes itself by way of " to[i])
        }
    }
}
END {
    end_file(); judge_structs(); judge_headers()
    printf "structure: %d files, %d lines; the longest has %d: %s\n", n_files, total, most, most_name
    printf "structure: %d functions; the longest has %d lines: %s\n", functions, longest, longest_name
    printf "structure: %d structs; the largest has %d members: %s\n", structs, widest, widest_name
    printf "structure: %d contracts and their members:%s\n", contracts, told
    exit n_files == 0 || functions == 0 || structs == 0 ? 99 : bad > 0
}' $files || bad=$?

# --- calls --------------------------------------------------------------------------------
# From nm: "caller callee name" of those inside a room; files of one name are one in all widths.
# shellcheck disable=SC2086
${NM:-nm} -A -P -g $objects | LC_ALL=C awk -v files="$(echo "$files" | tr '\n' ' ')" '
BEGIN { n = split(files, source, " "); for (i = 1; i <= n; i++) here[source[i]] = 1 }
function file_of(object,    part, n) {
    sub(/:$/, "", object); sub(/\.o$/, "", object)
    n = split(object, part, "/"); sub(/^lib[a-z0-9]*_a-/, "", part[n])
    return "src/" part[n - 1] "/" part[n]
}
function room(file) { sub(/\/[^\/]*$/, "", file); return file }
{ file = file_of($1) }
!((file ".c") in here) { next }         # left over from a file that is gone
$3 == "U" { asked[file, $2] = 1; next }
$3 ~ /^[TWBC]$/ { home[$2] = file }
END {
    for (key in asked) {
        split(key, part, SUBSEP); to = home[part[2]]
        if (to == "" || to == part[1] || room(to) != room(part[1])) continue
        name = part[2]; sub(/_lanes[248]$/, "", name)
        print part[1], to, name
    }
}' >"$out/calls"
[ -s "$out/calls" ] || { echo "structure: no calls found: is this nm?"; exit 99; }

LC_ALL=C sort -u "$out/calls" >"$out/sorted"
LC_ALL=C awk '
function reach(from, start,    n, i, next_ones) {
    n = split(to[from], next_ones, " ")
    for (i = 1; i <= n; i++)
        if (!((start, next_ones[i]) in reached)) {
            reached[start, next_ones[i]] = 1
            reach(next_ones[i], start)
        }
}
function line_of(file, name,    text, n, found) {
    for (n = 1; (getline text <(file ".c")) > 0; n++)
        if (!found && text ~ ("(^|[^A-Za-z_0-9])" name "([^A-Za-z_0-9]|$)") && text !~ /^ \*/) found = n
    close(file ".c")
    return found
}
{
    file[$1] = file[$2] = 1; calls++
    if (!(($1, $2) in edge)) { edge[$1, $2] = $3; to[$1] = to[$1] " " $2; pairs++ }
    call[calls] = $0
}
END {
    for (f in file) reach(f, f)
    for (i = 1; i <= calls; i++) {
        split(call[i], part, " ")
        if (!((part[2], part[1]) in reached)) continue
        printf "%s.c:%d: in a circle: %s() is in %s.c, which calls back%s\n", part[1],
               line_of(part[1], part[3]), part[3], part[2],
               (part[2], part[1]) in edge ? "" : " by way of others"
        bad++
    }
    printf "structure: %d calls between %d pairs of files inside rooms, %d in circles\n",
           calls, pairs, bad
    exit bad > 0
}' "$out/sorted" || bad=1
exit $bad
