#!/bin/sh
# quickstart-root.sh -- does ./quickstart work on a Debian 12 and a Debian 13 with nothing on them?
#
# For each of both makes a clean root with debootstrap, unpacks the tarball of `make dist' in it,
# and runs there, without a terminal, ./quickstart and ./quickstart check.  Needs root,
# debootstrap, the network and ten minutes for each; not part of `make check'.
#
#   make dist && tests/quickstart-root.sh stiffwater-0.1.0.tar.gz
#   SUITES=trixie        not both (bookworm, trixie)
#   BARE_ROOTS=DIR       keeps the clean roots there (DIR/bookworm.tar), or takes them from there
set -u
tarball=${1:-${STIFFWATER_TARBALL:?name a tarball made by make dist}}
bare=${BARE_ROOTS:-}

[ "$(id -u)" = 0 ] || { echo 'quickstart-root: needs root'; exit 77; }
command -v debootstrap >/dev/null || { echo 'quickstart-root: needs debootstrap'; exit 77; }
[ -f "$tarball" ] || { echo "quickstart-root: no tarball $tarball"; exit 99; }

root=
trap 'clear_root' EXIT
trap 'exit 1' INT TERM

clear_root() {
    [ -n "$root" ] || return 0
    umount "$root/proc" 2>/dev/null
    rm -rf --one-file-system "$root"
    root=
}

# The first mirror that apt of this machine uses.
mirror() {
    cat /etc/apt/sources.list /etc/apt/sources.list.d/*.list \
        /etc/apt/sources.list.d/*.sources 2>/dev/null |
        sed -n -e 's/^URIs: *\([^ ]*\).*/\1/p' \
            -e 's/^deb  *\(\[[^]]*\]  *\)\{0,1\}\([^ ]*\).*/\2/p' | head -n 1
}

# make_root SUITE: one that apt can use the way this machine does.
make_root() {
    root=$(mktemp -d) && chmod 755 "$root" || return
    if [ -n "$bare" ] && [ -f "$bare/$1.tar" ]; then
        tar -C "$root" -xf "$bare/$1.tar" || return
    else
        debootstrap --variant=minbase "$1" "$root" "$(mirror)" || return
        [ -z "$bare" ] || { mkdir -p "$bare" && tar -C "$root" -cf "$bare/$1.tar" .; } || return
    fi
    cp /etc/resolv.conf /etc/hosts "$root/etc/"
    grep -ls '^ *Acquire' /etc/apt/apt.conf.d/* /etc/apt/apt.conf |
        while read -r file; do cp "$file" "$root/etc/apt/apt.conf.d/"; done
    echo "deb $(mirror) $1 main" >"$root/etc/apt/sources.list"
    mount -t proc proc "$root/proc" 2>/dev/null || true
}

# inside COMMAND: in the clean root, with nothing of this machine's environment.
inside() {
    setsid chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin \
        sh -c "cd /opt/stiffwater-* && $1" </dev/null
}

# try SUITE: says what is wrong, if something is.
try() {
    make_root "$1" || { echo "quickstart-root: FAILED: $1: no clean root"; return 1; }
    tar -C "$root/opt" -xzf "$tarball" || { echo "quickstart-root: FAILED: $1: no tarball"; return 1; }
    for mode in run check; do
        echo "== $1: ./quickstart $mode"
        inside "./quickstart $mode" || { echo "quickstart-root: FAILED: $1: ./quickstart $mode"; return 1; }
    done
    inside 'ls results/*/figures/*.png' || { echo "quickstart-root: FAILED: $1: no figures"; return 1; }
    echo "quickstart-root: both ways of ./quickstart work on a bare $1"
}

failed=0
for suite in ${SUITES:-bookworm trixie}; do
    try "$suite" || failed=1
    clear_root
done
exit $failed
