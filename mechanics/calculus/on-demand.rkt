#lang racket/base
;; Minima and roots, loaded when they are first looked for.

(require racket/lazy-require)

(lazy-require
 ["minimum.rkt" (minimize multidimensional-minimize)]
 ["root.rkt" (find-root newton-search bisect zbrent)])

(provide minimize multidimensional-minimize find-root newton-search bisect zbrent)
