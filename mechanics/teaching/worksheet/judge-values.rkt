#lang racket/base
;; Answers that are compared with the key: expressions, functions, numbers, Hamiltonians.

(require "answer-parts.rkt" "exercise.rkt" "judgment.rkt" "prescribed-symbols.rkt"
         "../../algebra/expression/expression.rkt"
         "../../calculus/derivative.rkt"
         "../../generic/arithmetic.rkt" "../../generic/describe.rkt" "../../generic/rounding.rkt"
         "../../value/shape.rkt" "../../value/simplify.rkt"
         "../../value/structure.rkt"
         "../../verdict/prove-zero.rkt" "../../verdict/verdict.rkt")

(provide judge-value judge-number judge-Hamiltonian
         ;; for slips
         real-value within?)

;; Equal to the key; of a tuple each component counts by itself.
(define (judge-value e key answer)
  (if (alike? key answer)
      (judged-by (verify-equal answer key) share-proved)
      (wrong #f (format "the answer is ~a where ~a is expected" (describe answer) (describe key)))))

;; Within a relative tolerance of the key; absolute, where the key is 0 or the question says so.
(define (judge-number e key answer)
  (define-values (k a) (values (real-value key) (real-value answer)))
  (cond [(not a) (wrong #f (format "the answer is no number: ~a" (value->text answer)))]
        [(within? e k a) (right #f)]
        [else (wrong #f)]))

(define (within? e k a)
  (define tolerance (setting e 'within 1/100))
  (define least (if (or (setting e 'absolute) (zero? k)) 1 (abs k)))
  (<= (abs (- a k)) (* tolerance least)))

;; -> a flonum, or #f
(define (real-value x)
  (define n (and (expression? x) (g:exact->inexact (simplify x))))
  (and (number? n) (real? n) (rational? n) (real->double-flonum n)))

;; Equal but for a function of the time, which no equation sees.
(define (judge-Hamiltonian e key answer)
  (define state (state-of (exercise-coordinates e)))
  (cond
    [(not (alike? key answer)) (judge-value e key answer)]
    [else
     (define difference (value-function (g:- answer key) state))
     (define gradient
       (list->up (append (scalars (((partial 1) difference) state))
                         (scalars (((partial 2) difference) state)))))
     (define v (verify-equal answer key))
     (cond [(proved? v) (right v)]
           [else
            (define by-time-alone (prove-zero gradient #:variables (scalars state)))
            (if (proved? by-time-alone)
                (right by-time-alone "it differs by a term that no equation of motion sees")
                (judged-by v (lambda (_) 0)))])]))
