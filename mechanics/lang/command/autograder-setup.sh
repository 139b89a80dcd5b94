#!/bin/sh
# Gradescope runs this once: Racket 8.7 or later, and the library compiled.

set -e
root=${AUTOGRADER:-/autograder}
export DEBIAN_FRONTEND=noninteractive

recent() {
    racket -l racket/base -l version/utils \
        -e '(exit (if (version<? (version) "8.7") 1 0))' 2>/dev/null
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

# What needs a screen cannot be compiled there, nor is it needed.
PLTCOLLECTS="$root/source:" racket -l racket/base -l compiler/cm -e "
  (define compile (make-caching-managed-compile-zo))
  (for ([file (in-directory \"$root/source/mechanics\")]
        #:when (regexp-match? #rx\"[.]rkt\$\" (path->string file)))
    (with-handlers ([exn:fail? void])
      (parameterize ([current-namespace (make-base-empty-namespace)]) (compile file))))"
