#lang racket/base
;; Is an expression zero?  Proved, refuted, or undecided.
;;
;; *Proved* rests on the canonical form being 0, with exact input.  *Refuted*
;; rests on a point where the value is farther from zero than rounding can
;; explain: small integers for the symbols and for the literal functions
;; applied, which a person can put in by hand.  Otherwise the test is
;; *undecided* and says at how many points it found zero, and to what bound.
;; The points are always the same.

(require "operation.rkt" "expression.rkt" "approximate.rkt" "evaluate.rkt" "simplify.rkt"
         "condition.rkt" "present.rkt")

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
         (define-values (witness value bound points) (find-witness e residual))
         (make-zero-test (if witness 'refuted 'undecided) residual witness value bound points
                         factor core condition assumptions)]))

;; Numbers under functions count: they are no better known than others.
(define (contains-flonum? e)
  (node-fold e
             (lambda (leaf) (and (number? leaf) (not (exact? leaf))))
             (lambda (n found) (ormap values found))))

;; ---------------------------------------------------------------------------
;; Points

(define point-limit 12)

;; -> witness value bound points.  The value is that of e itself, so the
;; simplifier is no part of the evidence.
(define (find-witness e residual)
  (let loop ([k 0] [bound 0] [points 0])
    (cond
      [(= k point-limit) (values #f 0 bound points)]
      [else
       (define point (integer-point residual k))
       (define-values (value error) (value-at e point k))
       (cond [(not (decent? value error)) (loop (+ k 1) bound points)]
             [(> (magnitude value) (* 4 error)) (values point value error points)]
             [else (loop (+ k 1) (max bound error) (+ points 1))])])))

(define (decent? value error)
  (and (real? value) (rational? value) (real? error) (rational? error)))

;; The value and error of e where the point says, other leaves getting integers
;; of their own; not a number where e is not defined.
(define (value-at e point k)
  (with-handlers ([exn:fail? (lambda (x) (values +nan.0 +nan.0))])
    (approximate-expression e (point-lookup point (integers-from (+ 100 k))))))

;; Small integers for the leaves of e: ((leaf . integer) ...).  A literal
;; function has one value for one argument.
(define (integer-point e k)
  (define next (integers-from k))
  (define seen (make-hash))
  (define point '())
  (define (lookup leaf arguments)
    (define value
      (hash-ref! seen (leaf-key leaf arguments) (lambda () (next leaf arguments))))
    (unless (assoc leaf point)
      (set! point (cons (cons leaf value) point)))
    value)
  (with-handlers ([exn:fail? void])
    (evaluate-expression e lookup))
  (reverse point))

;; A literal function is known by its name, derivative and arguments' values.
(define (leaf-key leaf arguments)
  (if (symbol? leaf)
      leaf
      (let ([head (node-head leaf)])
        (list (literal-head-name head) (literal-head-index head) arguments))))

;; The k-th source of small positive integers, by a linear congruence.
(define (integers-from k)
  (define state (+ 12345 (* 7919 k)))
  (define range (if (< k 6) 5 11))
  (lambda (leaf arguments)
    (set! state (modulo (+ (* 1103515245 state) 12345) 2147483648))
    (+ 1 (modulo (quotient state 65536) range))))
