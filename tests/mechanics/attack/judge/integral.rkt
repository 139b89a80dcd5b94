#lang racket/base
;; Is a formula the value of an integral, or of its derivative, wherever its conditions hold?

(require "fault.rkt" "number.rkt" "point.rkt" "quadrature.rkt" "trials.rkt")

(provide judge-integral)

(define (judge-integral parts status assumed witness found)
  (define-values (e low high by claim) (apply values parts))
  (define symbols (remq 'x (symbols-of e low high (or by 0) (or claim 0) (or found 0))))
  (define ((judge formula must?) numbers) (compared e low high by formula must? numbers))
  (if (eq? status 'refuted)
      (judged-at-witness symbols witness small-numbers (opposite (judge claim #f)))
      (judged-at-points symbols assumed small-numbers 8
                        (judge (or found claim) (and found (not by))))))

;; A refutation is right where the values differ.
(define ((opposite judge) numbers)
  (define v (judge numbers))
  (cond [(eq? v #t) (fault 'no-difference-at-witness numbers #f #f)]
        [(not v) #f]
        [(eq? 'values-differ (fault-kind v)) #t]
        [else (fault 'no-value-at-witness numbers #f #f)]))

;; The integral and an expression: #t where they are equal, #f where that is not known
;; must? : must the expression have a value where the integral has?
(define (compared e low high by formula must? numbers)
  (define-values (left right) (values (integral-or-slope e low high by numbers)
                                      (number-at formula numbers)))
  (define (wrong kind)
    (fault kind numbers (and (rational? left) left) (and (rational? right) right)))
  (cond [(and (eq? left 'infinite) (rational? right)) (wrong 'no-integral)]
        [(not (rational? left)) #f]
        [(eq? right 'none) (and must? (wrong 'result-nowhere-defined))]
        [(not right) #f]
        [(> (abs (- left right)) (* (if by 1e-9 1e-12) (+ 1 (abs left)))) (wrong 'values-differ)]
        [else #t]))

(define h (expt 2 -40))

;; The value of the integral; of its derivative by a symbol, but where that jumps.  It is off by h
;; where the derivative has a kink.
(define (integral-or-slope e low high by numbers)
  (define (at step)
    (integral-value e low high (shifted numbers (if by (list (cons by step)) '()))))
  (define here (at 0))
  (define-values (before after) (if by (values (at (- h)) (at h)) (values here here)))
  (cond [(not (and by (rational? here))) here]
        [(not (and (rational? before) (rational? after))) #f]
        [(> (abs (- (+ before after) (* 2 here))) (* 1e-6 h)) #f]
        [else (/ (- after before) (* 2 h))]))
