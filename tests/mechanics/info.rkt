#lang info
(define name "mechanics tests")
;; The runner's fixtures fail on purpose, one of them to compile.
(define compile-omit-paths '("runner/fixture"))
(define test-omit-paths '("runner" "bench"))
