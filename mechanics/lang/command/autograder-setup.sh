#!/bin/sh
# Gradescope runs this once: Racket 8.7 or later, and the library compiled.

set -e
root=${AUTOGRADER:-/autograder}
export DEBIAN_FRONTEND=noninteractive

recent() {
    racket -n -e '(require version/utils) (exit (if (version<? (version) "8.7") 1 0))' 2>/dev/null
}

recent || { apt-get update && apt-get install -y --no-install-recommends racket; } || true
recent || {
    apt-get install -y --no-install-recommends software-properties-common
    add-apt-repository -y ppa:plt/racket
    apt-get update
    apt-get install -y --no-install-recommends racket
}

# Submissions are run by nobody, who is to read the library and not the answers.
chmod -R a+rX "$root/source/mechanics"
chmod 600 "$root/source/worksheet.rkt"

commands=$root/source/mechanics/lang/command
PLTCOLLECTS="$root/source:" racket -l- raco make "$commands/autograder.rkt" \
    "$commands/evaluate-submission.rkt" "$root/source/mechanics/worksheet.rkt" \
    "$root/source/mechanics/answers.rkt"
