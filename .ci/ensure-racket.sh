#!/bin/sh
# Makes sure that Racket 8.7 or later is there, with the parts we use:
#
#     ensure-racket.sh               Racket itself
#     ensure-racket.sh libraries     the shared libraries that tests may use
#     ensure-racket.sh editing       the library that edits lines at the prompt
#     ensure-racket.sh drawing       the libraries that draw pictures
#     ensure-racket.sh manual        the library that keeps the index of Racket's manuals
#
# On Debian and Ubuntu what is missing is installed with apt-get, through sudo
# for others than root.  Elsewhere, or when that fails, it says what to install.
# Missing libraries are no error: the tests that need them are skipped, and lines are read
# without editing.

set -eu

required=8.7
racket=${RACKET:-racket}

say() { printf '%s\n' "$*" >&2; }

have() { command -v "$1" >/dev/null 2>&1; }

# at_least VERSION: is VERSION (8.10, 8.7+dfsg1-1, …) `required` or later?
at_least() {
    printf '%s %s\n' "$1" "$required" | tr -c '0-9. \n' ' ' |
        awk '{ split($1, a, "."); split($NF, b, ".")
               exit !(a[1] > b[1] || (a[1] == b[1] && a[2] + 0 >= b[2] + 0)) }'
}

how_to_get_racket() {
    say "
mechanics needs Racket $required or later.  Ways to get it:
  any system       the installer from https://download.racket-lang.org
  Debian, Ubuntu   apt-get install racket             (Debian 12, Ubuntu 24.04 or later)
                   add-apt-repository ppa:plt/racket  (first, on an earlier Ubuntu)
  Fedora           dnf install racket
  Arch             pacman -S racket
  macOS            brew install --cask racket
Then run the same make command again."
}

give_up() { say "$1"; how_to_get_racket; exit 1; }

# as_root COMMAND …
as_root() {
    if [ "$(id -u)" -eq 0 ]; then env DEBIAN_FRONTEND=noninteractive "$@"
    elif [ -t 0 ]; then sudo env DEBIAN_FRONTEND=noninteractive "$@"
    else sudo -n env DEBIAN_FRONTEND=noninteractive "$@"
    fi
}

# apt_install PACKAGE …: what apt-get says is shown only when it fails.
apt_install() {
    log=$(mktemp)
    code=0
    as_root apt-get install -y -qq --no-install-recommends "$@" >"$log" 2>&1 || code=$?
    [ "$code" -eq 0 ] || cat "$log" >&2
    rm -f "$log"
    return "$code"
}

can_be_root() { [ "$(id -u)" -eq 0 ] || have sudo; }

# Lists may be stale or, on a fresh machine, absent.  One source that cannot be
# reached is no reason to stop: the installation will tell.
update_lists() {
    as_root apt-get update -qq || say "(apt-get update reported errors: no network? going on)"
}

candidate() { apt-cache policy "$1" 2>/dev/null | sed -n 's/^ *Candidate: *//p'; }

install_racket() {
    have apt-get || give_up "There is no Racket here, and no apt-get to install it with."
    can_be_root || give_up "There is no Racket here, and installing it takes root or sudo: as root, run
  apt-get update && apt-get install racket"
    say "Installing Racket (package racket, about 100 MB) ..."
    update_lists
    version=$(candidate racket)
    case $version in
        '' | '(none)') give_up "apt-get knows no package racket; without a network it cannot ask." ;;
    esac
    at_least "${version#*:}" || give_up "The package racket of this system is version $version, which is too old."
    apt_install racket || give_up "apt-get could not install Racket; above is what it says."
}

# Minimal Racket lacks most of the distribution.
has_needed_parts() {
    "$racket" -l racket/base -e '
      (for-each (lambda (m) (collection-file-path (cdr m) (car m)))
                (list (cons "compiler/commands" "make.rkt")
                      (cons "rackunit" "main.rkt")
                      (cons "scribble" "manual.rkt")))' >/dev/null 2>&1
}

# Its settings are environment variables; with some values it does not start, and exits with 0.
check_start() {
    answer=$("$racket" --version 2>&1) || :
    case $answer in Welcome*) return ;; esac
    settings=$(env | sed -n 's/^\(PLT[A-Z_]*\)=.*/\1/p' | grep -v '^PLTCOLLECTS$' | tr '\n' ' ')
    say "$(command -v "$racket") does not start:"
    printf '%s\n' "$answer" | head -n 3 | sed 's/^/  /' >&2
    if [ -n "$settings" ]; then
        say "The environment sets ${settings}for it; folders there are full paths.  Without them:"
        say "  env $(printf -- '-u %s ' $settings)make ..."
    else
        say "Install it again, and run the same make command."
    fi
    exit 1
}

ensure_racket() {
    have "$racket" || [ "$racket" = racket ] || give_up "There is no $racket, which RACKET names."
    have "$racket" || install_racket
    check_start
    version=$(printf '%s\n' "$answer" | sed -n 's/^Welcome to Racket v\([0-9.]*[0-9]\).*/\1/p')
    at_least "${version:-0}" || give_up "$(command -v "$racket") is Racket ${version:-of an unknown version}, which is too old."
    has_needed_parts || give_up "$(command -v "$racket") is Racket $version without the main distribution; this adds it:
  raco pkg install --auto main-distribution"
}

# ---------------------------------------------------------------------------
# Shared libraries.  Packages are called differently on Debian and Ubuntu.

is_installed() { dpkg-query -W -f '${Status}\n' "$1" 2>/dev/null | grep -q 'ok installed'; }

# any_installed NAME …: is one of them?
any_installed() {
    for name; do if is_installed "$name"; then return 0; fi; done
    return 1
}

# first_available NAME …
first_available() {
    for name; do
        case $(candidate "$name") in
            '' | '(none)') ;;
            *) echo "$name"; return ;;
        esac
    done
}

for_drawing='libglib2.0-0 libglib2.0-0t64
libcairo2
libpangocairo-1.0-0
libjpeg62-turbo libjpeg-turbo8
libpng16-16 libpng16-16t64'

# MPFR is for numbers of higher precision.
for_tests="libmpfr6
$for_drawing
libedit2"

for_editing=libedit2
for_manual=libsqlite3-0

# missing_libraries ALTERNATIVES: its lines of which nothing is installed.
missing_libraries() {
    printf '%s\n' "$1" | while read -r names; do
        # shellcheck disable=SC2086
        any_installed $names || echo "$names"
    done
}

# install_libraries ALTERNATIVES
install_libraries() {
    update_lists
    packages=$(missing_libraries "$1" | while read -r names; do
        # shellcheck disable=SC2086
        first_available $names
    done)
    # shellcheck disable=SC2086
    [ -z "$packages" ] || apt_install $packages
}

# ensure_libraries ALTERNATIVES PURPOSE CONSEQUENCE
ensure_libraries() {
    if ! have apt-get || ! have dpkg-query; then return 0; fi
    [ -n "$(missing_libraries "$1")" ] || return 0
    say "Installing shared libraries $2 ..."
    if can_be_root; then install_libraries "$1" || true; fi
    missing=$(missing_libraries "$1" | cut -d ' ' -f 1 | tr '\n' ' ')
    [ -z "$missing" ] || say "(not installed: $missing; $3)"
}

case ${1:-} in
    '') ensure_racket ;;
    libraries) ensure_libraries "$for_tests" "that tests use" "tests that need them are skipped" ;;
    editing) ensure_libraries "$for_editing" "for line editing" \
                 "the prompt works, without history and completion; apt-get install libedit2 adds them" ;;
    drawing) ensure_libraries "$for_drawing" "for pictures" "pictures are told in words" ;;
    manual) ensure_libraries "$for_manual" "for the manual" "the manual is left out" ;;
    *) say "usage: $0 [libraries|editing|drawing|manual]"; exit 2 ;;
esac
