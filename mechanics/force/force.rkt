#lang racket/base
;; Forces on particles: functions F(t, positions, velocities) whose value is like the
;; positions.  0 is no force, on a particle or on all.

(require "particles.rkt" "self-describing-function.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt" "../error/hint.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function-check.rkt"
         "../generic/function.rkt" "../generic/printed-function.rkt" "../generic/scalar.rkt"
         "../generic/up-down.rkt"
         "../value/structure.rkt")

(provide potential->force check-force forces-at)

;; The force −∂V/∂r of a potential energy V(t, positions).
(define (potential->force V)
  (define who 'potential->force)
  (unless (takes? V 2)
    (complain who "a potential energy is a function of the time and the positions, ~a; given ~a~a"
              "(V t r)" (describe-with-value V)
              (if (procedure? V) (format "\n  it takes ~a" (arity->text V)) "")))
  (define slope ((partial 1) (scalar-potential who V)))
  (function-of (t r v) (call-datum who V)
    (g:negate (flip (slope t r)))))

(define ((scalar-potential who V) t positions)
  (check-scalar-value who "a potential energy" V (V t positions)))

(define (check-force who F)
  (unless (takes? F 3)
    (complain who "forces are a function of the time, positions and velocities, ~a; given ~a~a"
              "(F t r v)" (describe-with-value F)
              (cond [(or (tuple? F) (not (procedure? F)))
                     (if (or (scalar? F) (tuple? F))
                         "\n  a constant force is (lambda (t r v) ...)"
                         "")]
                    [(accepts? F 2)
                     (string-append "\n  it takes two arguments; (potential->force V) is the force "
                                    "of a potential energy V(t, r)")]
                    [else (format "\n  it takes ~a" (arity->text F))]))))

;; The forces, checked to be like the positions.
(define (forces-at who F t positions velocities)
  (define forces (F t positions velocities))
  (unless (fits? forces positions)
    (complain who "the forces must be like the positions\n  positions: ~a\n  forces: ~a~a"
              (value->text positions) (value->text forces) (difference forces positions)))
  forces)

(define (fits? force position)
  (cond [(eqv? force 0) #t]
        [(and (tuple? force) (tuple? position))
         (define-values (f p) (values (adopt force) (adopt position)))
         (and (compatible? f p) (for/and ([x f] [y p]) (fits? x y)))]
        [else (and (scalar? force) (scalar? position))]))

;; A line on the difference, or "" where none can be named.
(define (difference forces positions)
  (cond [(pair? forces) (list-hint forces "(up F_x F_y ...)")]
        [(and (tuple? forces) (fits? (flip forces) positions))
         "\n  forces are up tuples; a generalized force is the down tuple"]
        [(and (tuple? forces) (tuple? positions) (compatible? (adopt forces) (adopt positions)))
         (define k
           (for/first ([f (adopt forces)] [p (adopt positions)] [k (in-naturals)]
                       #:unless (fits? f p))
             k))
         (format "\n  they differ at component ~a" k)]
        [else ""]))
