#lang info
(define name "mechanics tests")
;; Compiled by `make test`: who installs the library does not wait for its tests.
(define compile-omit-paths 'all)
;; The runner's fixtures fail on purpose.
(define test-omit-paths '("runner" "bench"))
