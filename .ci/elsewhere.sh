#!/bin/sh
# The README's two commands on machines that have nothing: bare systems of Debian, each
# in a folder, with a clean checkout of what is committed.
#
#     elsewhere.sh [suite ...]        Debian 12 and 13 (bookworm, trixie) if none is named
#
# Takes root and debootstrap, a network, and some 3 GB in build/elsewhere.  The bare system
# is kept for the next time, what ran in it is made anew.  Everything that is printed goes
# to build/elsewhere/SUITE.log; the last lines of each command are shown.

set -eu

cd "$(dirname "$0")/.."

say() { printf '%s\n' "$*"; }

give_up() { say "$*" >&2; exit 2; }

[ "$(id -u)" -eq 0 ] || give_up "make elsewhere: installs systems in folders, which takes root."
for tool in debootstrap unshare chroot git; do
    command -v "$tool" >/dev/null 2>&1 ||
        give_up "make elsewhere: needs $tool (on Debian: apt-get install debootstrap util-linux git)."
done

where=$PWD/build/elsewhere
mkdir -p "$where"

# bare SUITE: makes it once.  What a broken attempt left behind is no bare system.
bare() {
    base=$where/$1.bare
    [ ! -d "$base" ] || return 0
    say "$1: installing a bare system ..."
    rm -rf --one-file-system "$base.part" || give_up "$1: a broken attempt cannot be removed."
    debootstrap --variant=minbase --include=make,ca-certificates "$1" "$base.part" ${MIRROR:-} \
        >"$where/$1.log" 2>&1 || { tail -n 5 "$where/$1.log"; give_up "$1: debootstrap failed."; }
    mv "$base.part" "$base" || give_up "$1: the bare system cannot be kept."
}

# checkout ROOT: what is committed, as a stranger gets it.
checkout() {
    mkdir -p "$1/mechanics" &&
        git archive -o "$1/mechanics.tar" HEAD &&
        tar -x -f "$1/mechanics.tar" -C "$1/mechanics" &&
        rm "$1/mechanics.tar"
}

# inside ROOT COMMAND: the mounts belong to the command and go with it.
inside() {
    unshare --mount --pid --fork sh -eu -c '
        mount -t proc proc "$1/proc"
        mount --rbind /dev "$1/dev"
        exec chroot "$1" /usr/bin/env -i HOME=/root LANG=C.UTF-8 \
            PATH=/usr/sbin:/usr/bin:/sbin:/bin sh -c "cd /mechanics && $2"' inside "$1" "$2"
}

# attempt SUITE COMMAND: its exit code, with the end of what it printed.
attempt() {
    code=0
    say "$1: $2 ..."
    inside "$where/$1" "$2" >>"$where/$1.log" 2>&1 || code=$?
    tail -n 3 "$where/$1.log" | sed 's/^/    /'
    return "$code"
}

# What is asked whether it fails, as try_suite is below, goes on after a command that fails,
# whatever `set -e` says: so each of them says what then.
try_suite() {
    bare "$1"
    rm -rf --one-file-system "${where:?}/$1" || give_up "$1: the last attempt cannot be removed."
    cp -a "$where/$1.bare" "$where/$1" || give_up "$1: the bare system cannot be copied."
    cp /etc/resolv.conf "$where/$1/etc/resolv.conf" || give_up "$1: no name server can be set."
    checkout "$where/$1" || give_up "$1: the checkout failed."
    : >"$where/$1.log"
    attempt "$1" "make demo" && attempt "$1" "make test"
}

failed=
for suite in ${*:-bookworm trixie}; do
    try_suite "$suite" || failed="$failed $suite"
done
[ -z "$failed" ] || { say "failed on:$failed (see build/elsewhere/)"; exit 1; }
say "all of them work"
