#lang racket/base
;; Numbers of higher precision, loaded when the first one is made.

(require racket/lazy-require)

(lazy-require
 ["bigfloat.rkt" (bigfloat bigfloat? bigfloat-precision bigfloat->exact)])

(provide bigfloat bigfloat? bigfloat-precision bigfloat->exact)
