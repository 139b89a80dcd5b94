#!/bin/sh
# The README's two commands in places that strangers have: bare systems of Debian, each in a
# folder, with a clean checkout of what is committed.
#
#     elsewhere.sh [place ...]        all of them if none is named
#
#     container   Debian 12: root, a checkout in root's home (mode 0700), no namespaces, no
#                 pseudo-terminals, the capabilities that containers leave
#     trixie      Debian 13: root, a path with spaces, namespaces
#     user        Debian 12: an ordinary user, who cannot install anything; Racket is there
#     busy        Debian 12: both processors have something else to do all the time
#
# Takes root and debootstrap, a network, and some 6 GB in build/elsewhere.  The bare systems are
# kept for the next time; the copies in which commands ran are made anew.  Everything that is
# printed goes to build/elsewhere/PLACE.log; the last lines of each command are shown.

set -eu

cd "$(dirname "$0")/.."

say() { printf '%s\n' "$*"; }

give_up() { say "$*" >&2; exit 2; }

all_places='container trixie user busy'

for place; do
    case " $all_places " in
        *" $place "*) ;;
        *) give_up "make elsewhere: there is no place $place; there are: $all_places" ;;
    esac
done
[ "$(id -u)" -eq 0 ] || give_up "make elsewhere: installs systems in folders, which takes root."
for tool in debootstrap unshare setpriv chroot pivot_root git; do
    command -v "$tool" >/dev/null 2>&1 ||
        give_up "make elsewhere: needs $tool (on Debian: apt-get install debootstrap util-linux git)."
done

where=$PWD/build/elsewhere
mkdir -p "$where"

# ---------------------------------------------------------------------------
# A place: its system, its user, the folder of the checkout, and what is different there

suite_of() { case $1 in trixie) echo trixie ;; *) echo bookworm ;; esac; }
user_of() { case $1 in user) echo student ;; *) echo root ;; esac; }
home_of() { case $1 in user) echo /home/student ;; *) echo /root ;; esac; }
folder_of() {
    case $1 in
        container) echo /root/mechanics ;;
        trixie) echo "/srv/my own programs/mechanics" ;;
        *) echo "$(home_of "$1")/mechanics" ;;
    esac
}

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

# furnish PLACE: its system, with what is committed, as a stranger gets it.
furnish() {
    root=$where/$1
    rm -rf --one-file-system "${root:?}" &&
        cp -a "$where/$(suite_of "$1").bare" "$root" &&
        cp /etc/resolv.conf "$root/etc/resolv.conf" &&
        chmod 700 "$root/root" &&
        mkdir -p "$root$(folder_of "$1")" &&
        git archive -o "$where/checkout.tar" HEAD &&
        tar -x -f "$where/checkout.tar" -C "$root$(folder_of "$1")" ||
        give_up "$1: it cannot be furnished."
    : >"$where/$1.log"
    [ "$1" != user ] || settle "$1"
}

# The ordinary user cannot install anything: root installs Racket and the libraries first.
settle() {
    run "$1" root "useradd --create-home student && .ci/ensure-racket.sh &&
        .ci/ensure-racket.sh libraries && chown -R student: \"\$PWD\"" >>"$where/$1.log" 2>&1 ||
        give_up "$1: Racket could not be installed there."
}

# ---------------------------------------------------------------------------
# Running commands there

# What containers take from root.
lost=-sys_admin,-sys_ptrace,-sys_module,-sys_time,-sys_resource,-sys_boot,-net_admin,-syslog

# run PLACE USER COMMAND: the mounts belong to the command and go with it.  Linux gives a process
# in a chroot no user namespaces; after pivot_root it does.
run() {
    kind=machine
    [ "$1" != container ] || kind=container
    unshare --mount --pid --fork sh -eu -c '
        root=$1 kind=$2 lost=$3; shift 3
        mount --rbind "$root" "$root"
        mount -t proc proc "$root/proc"
        cd "$root"
        if [ "$kind" = container ]; then
            mount -t tmpfs -o mode=755 none dev
            for node in "null 3" "zero 5" "full 7" "random 8" "urandom 9"; do
                mknod -m 666 "dev/${node% *}" c 1 "${node#* }"
            done
            ln -s /proc/self/fd dev/fd
            exec setpriv --bounding-set "$lost" chroot . "$@"
        fi
        mount --rbind /dev dev
        mkdir -p .outside
        pivot_root . .outside
        umount -l .outside
        exec "$@"
    ' run "$where/$1" "$kind" "$lost" \
        /usr/bin/env -i HOME="$(home_of "$1")" LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin \
        setpriv --reuid="$2" --regid="$2" --init-groups \
        sh -c 'cd "$0" && eval "$1"' "$(folder_of "$1")" "$3"
}

# attempt PLACE COMMAND: its exit code, with the end of what it printed.
attempt() {
    code=0
    say "$1: $2 ..."
    command=$2
    [ "$1" != busy ] ||
        command="for _ in \$(seq \$(nproc)); do (while :; do :; done) & done; $2"
    run "$1" "$(user_of "$1")" "$command" >>"$where/$1.log" 2>&1 </dev/null || code=$?
    tail -n 3 "$where/$1.log" | sed 's/^/    /'
    return "$code"
}

# ---------------------------------------------------------------------------

failed=
for place in ${*:-$all_places}; do
    bare "$(suite_of "$place")"
    furnish "$place"
    { attempt "$place" "make demo" && attempt "$place" "make test"; } || failed="$failed $place"
done
[ -z "$failed" ] || { say "failed in:$failed (see build/elsewhere/)"; exit 1; }
say "all of them work"
