#lang racket/base
;; Compilation, loaded when it is first used.

(require racket/lazy-require)

(lazy-require
 ["compile-function.rkt" (compile-function compiled-function? compiled-function-reason
                          compiled-function-operations)])

(provide compile-function compiled-function? compiled-function-reason
         compiled-function-operations)
