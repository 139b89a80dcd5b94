#lang racket/base
;; Is an expression zero?  Proved, refuted, or undecided.
;;
;; *Proved* rests on the canonical form being 0, with exact input.  *Refuted*
;; rests on a point where the value is farther from zero than rounding can
;; explain: small integers for the symbols and for the literal functions
;; applied, which a person can put in by hand.  Otherwise the test is
;; *undecided* and says at how many points it found zero, and to what bound.
;; The points are always the same.

(require "expression.rkt" "simplify.rkt" "condition.rkt" "present.rkt" "witness.rkt")

(provide zero-test
         zero-test? zero-test-status zero-test-residual zero-test-witness zero-test-value
         zero-test-bound zero-test-points zero-test-factor zero-test-core
         zero-test-condition zero-test-assumptions)

;; status : 'proved, 'refuted or 'undecided     residual : expression, simplified
;; witness : #f or ((expression . number) ...)  value : the residual's there
;; bound : the greatest rounding error at the points tried without a decision
;; points : how many those were                 factor, core : residual = factor · core
;; condition : #f or an equation, as a datum, for which core = 0
;; assumptions : datums such as (>= R 0) that the residual takes for granted
(struct zero-test (status residual witness value bound points factor core condition
                          assumptions)
  #:name zero-test-result
  #:constructor-name make-zero-test)

(define (zero-test e)
  (define-values (F f assumptions) (normal-form e))
  (define residual (present F f))
  (cond [(and (eqv? residual 0) (not (contains-flonum? e)))
         (make-zero-test 'proved 0 #f 0 0 0 1 0 #f assumptions)]
        [(eqv? residual 0)
         (make-zero-test 'undecided 0 #f 0 0 0 1 0 #f assumptions)]
        [else
         (define-values (factor core condition) (factor-and-core F f))
         (define-values (witness value bound points) (find-witness e residual (pair? assumptions)))
         (make-zero-test (if witness 'refuted 'undecided) residual witness value bound points
                         factor core condition assumptions)]))

;; Numbers under functions count: they are no better known than others.
(define (contains-flonum? e)
  (node-fold e
             (lambda (leaf) (and (number? leaf) (not (exact? leaf))))
             (lambda (n found) (ormap values found))))
