#lang info
(define name "mechanics examples")
;; The tour takes a while and prints for people.
(define test-omit-paths '("demo.rkt"))
