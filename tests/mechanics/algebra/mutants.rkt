#lang racket/base
;; The suite can fail: unsound rules put into the algebra are noticed.
;;
;; Every fifth mutant is tried here;
;;
;;     racket tests/mechanics/algebra/mutants.rkt
;;
;; tries all and tells how each was noticed.

(require "../support/checks.rkt" "../support/mutation/mutants.rkt" "../support/mutation/mutate.rkt")

(module+ test
  (test-case "what each mutant replaces occurs exactly once"
    (for ([m (in-list mutants)])
      (check-equal? (occurrences m) 1 (mutant-name m))))

  (test-case "the algebra as it is passes"
    (check-false (try-original)))

  (for ([m (in-list mutants)] [i (in-naturals)] #:when (eqv? 0 (modulo i 5)))
    (test-case (format "it is noticed that ~a" (mutant-name m))
      (check-not-false (try-mutant m)))))

(module+ main
  (for ([m (in-list mutants)])
    (printf "~a: ~a\n" (mutant-name m) (or (try-mutant m) "NOT NOTICED"))))
