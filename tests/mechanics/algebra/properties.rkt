#lang racket/base
;; Random expressions of the whole class: simplification keeps values, is
;; idempotent, and gives one form and one print whatever sound rewrites were made
;; anywhere; fingerprints and verdicts agree; wrong variants are told apart.
;;
;; A batch runs here; ../support/property/run.rkt makes long ones and says what a seed is.

(require "../support/checks.rkt"
         "../support/property/expressions.rkt" "../support/property/run.rkt")

(define batch 1200)

(for ([class (in-list classes)] [offset (in-naturals)])
  (test-case (format "properties hold of ~a expressions" class)
    (for ([seed (in-range offset batch (length classes))])
      (define failures (run-seed seed))
      (check-true (null? failures)
                  (if (null? failures) "" (failure->string (car failures)))))))
