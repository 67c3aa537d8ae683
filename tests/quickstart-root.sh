#!/bin/sh
# quickstart-root.sh -- does ./quickstart work on a Debian 12 with nothing on it?
#
# Makes a clean root with debootstrap, unpacks the tarball of `make dist' in it, and runs
# there, without a terminal, ./quickstart and ./quickstart check.  Needs root, debootstrap,
# the network and ten minutes; not part of `make check'.
#
#   make dist && tests/quickstart-root.sh stiffwater-0.1.0.tar.gz
#   BARE_ROOT=FILE.tar   keeps the clean root there, or takes it from there
#   SUITE=trixie         another Debian than bookworm
set -u
tarball=${1:-${STIFFWATER_TARBALL:?name a tarball made by make dist}}
suite=${SUITE:-bookworm}
bare=${BARE_ROOT:-}

[ "$(id -u)" = 0 ] || { echo 'quickstart-root: needs root'; exit 77; }
command -v debootstrap >/dev/null || { echo 'quickstart-root: needs debootstrap'; exit 77; }
[ -f "$tarball" ] || { echo "quickstart-root: no tarball $tarball"; exit 99; }

root=$(mktemp -d) && chmod 755 "$root" || exit 99
trap 'umount "$root/proc" 2>/dev/null; rm -rf --one-file-system "$root"' EXIT
trap 'exit 1' INT TERM

# The first mirror that apt of this machine uses.
mirror() {
    cat /etc/apt/sources.list /etc/apt/sources.list.d/*.list \
        /etc/apt/sources.list.d/*.sources 2>/dev/null |
        sed -n -e 's/^URIs: *\([^ ]*\).*/\1/p' \
            -e 's/^deb  *\(\[[^]]*\]  *\)\{0,1\}\([^ ]*\).*/\2/p' | head -n 1
}

# A root that apt can use the way this machine does.
make_root() {
    if [ -n "$bare" ] && [ -f "$bare" ]; then
        tar -C "$root" -xf "$bare" || return
    else
        debootstrap --variant=minbase "$suite" "$root" "$(mirror)" || return
        [ -z "$bare" ] || tar -C "$root" -cf "$bare" .
    fi
    cp /etc/resolv.conf /etc/hosts "$root/etc/"
    grep -ls '^ *Acquire' /etc/apt/apt.conf.d/* /etc/apt/apt.conf |
        while read -r file; do cp "$file" "$root/etc/apt/apt.conf.d/"; done
    echo "deb $(mirror) $suite main" >"$root/etc/apt/sources.list"
    mount -t proc proc "$root/proc" 2>/dev/null || true
}

# inside COMMAND: in the clean root, with nothing of this machine's environment.
inside() {
    setsid chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin \
        sh -c "cd /opt/stiffwater-* && $1" </dev/null
}

stop() {
    echo "quickstart-root: FAILED: $1"
    exit 1
}

make_root || stop 'no clean root'
tar -C "$root/opt" -xzf "$tarball" || stop 'no tarball'
for mode in run check; do
    echo "== ./quickstart $mode"
    inside "./quickstart $mode" || stop "./quickstart $mode"
done
inside 'ls results/*/figures/*.png' || stop 'no figures'
echo 'quickstart-root: both ways of ./quickstart work on a bare Debian'
