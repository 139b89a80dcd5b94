#lang s-exp syntax/module-reader
;; `#lang mechanics` is read, coloured and indented as Racket is.
mechanics
#:wrapper1 (lambda (read) (tell-of-stale-files) (read))
(require "../error/stale-files.rkt")
