#lang racket/base
;; Arguments of version 0.2 that are written otherwise now: the words of a message to a reader
;; who still writes them so.  The manual's page of conventions has the same table.

(provide former-keyword former-count
         ;; for tests
         (rename-out [keywords former-keywords] [counts former-counts]))

;; (keyword, its replacement, procedures that had the keyword)
(define keywords
  '((#:progress "it is called #:progress? now"
                find-minimum minimize multidimensional-minimize nelder-mead brent-min
                golden-section-min find-path state-advancer evolve linearized-flow
                evolve-trajectory evolve-ensemble)
    (#:all? "all of them are found by (minima f low high)" find-minimum minimize)
    (#:on-each "it is called #:observe now" evolve-ensemble)
    (#:from "it is called #:initial now" evolve-ensemble)
    (#:from "it is called #:starts now" explore-map)
    (#:from "it is called #:zero-at now" gauge-function separation-function)
    (#:to "it is called #:language now" export-system)
    (#:between "#:between (list low high) is written #:from low #:to high now"
               invariant-circle invariant-circle-limit)
    (#:longest "it is called #:longest-time now" action-of-orbit frequency-of-orbit)))

;; (procedure, number of arguments with a tolerance among them)
(define counts '((D-numeric 2) (Hamiltonian-action 6)))

;; -> text or #f
(define (former-keyword who keyword)
  (for/first ([entry (in-list keywords)]
              #:when (and (eq? (car entry) keyword) (memq who (cddr entry))))
    (cadr entry)))

;; -> text or #f
(define (former-count who n)
  (and (member (list who n) counts)
       "the tolerance is given as #:tolerance now"))
