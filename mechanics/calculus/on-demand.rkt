#lang racket/base
;; Minima and roots, loaded when they are first looked for.

(require racket/lazy-require)

(lazy-require
 ["minimum.rkt" (minimize brent-min golden-section-min
                 multidimensional-minimize nelder-mead)]
 ["root.rkt" (find-root newton-search bisect zbrent)])

(provide minimize brent-min golden-section-min multidimensional-minimize nelder-mead
         find-root newton-search bisect zbrent)
