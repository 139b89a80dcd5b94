#lang info
(define name "mechanics examples")
;; Compiled when somebody runs them: an installation does not wait for programs to be read.
(define compile-omit-paths 'all)
;; The tour takes a while and prints for people.
(define test-omit-paths '("demo.rkt"))
