#lang racket/base
;; Angles of which a multiple of π is a term.
;;
;; c π is a number of quarter turns and a rest r π with -1/4 < r <= 1/4.  Quarter turns change
;; sine to cosine and cosine to -sine.  The rest goes by the addition formulas if its sine
;; and cosine have short forms; each pair has no more than one root of a sum:
;;
;;     cos π/12 = (√6 + √2)/4,    sin π/12 = (√6 - √2)/4,
;;     cos π/10 = (1 + √5)/2 s,   sin π/10 = (√5 - 1)/4,     s = sin π/5,
;;     cos π/8  = √(2 + √2)/2,    sin π/8  = (√2 - 1) cos π/8,
;;     cos π/5  = (1 + √5)/4,     sin π/5  = √(10 - 2√5)/4.
;;
;; Of the other rests, sin π/7 say, nothing is known but that they are angles.
;;
;; The other way round, asin, acos and atan of a number are a multiple of π if a flonum says
;; which, and its sine and cosine are exactly the numbers that they have to be.

(require (only-in "kernel.rkt" function-value sum-of-terms)
         "../expression/constant-value.rkt" "../expression/expression.rkt"
         "../expression/operation.rkt" "../expression/pi.rkt" "../expression/simplifier.rkt"
         "../../numeric/constants.rkt")

(provide turned turned-exponential exponential-of inverse-multiple function-at)

;; terms : ((number . expression) ...), whose sum is the angle
;; -> an expression that is sin, cos or tan of it, or #f if π is none of the terms or nothing
;; can be done
(define (turned head terms)
  (define t (findf (lambda (t) (eq? (cdr t) exact-pi)) terms))
  (and t (turned-by head (inexact->exact (car t)) (sum-of-terms (remq t terms)))))

;; The function of c π + u.  Of tan π/2, which has no value, it is the quotient that has none.
(define (turned-by head c u)
  (define-values (quarters r) (quarter-turns c))
  (define k (modulo quarters 4))
  (define w (exact-wave (abs r)))
  (define rest (e:+ (e:* r exact-pi) u))
  (cond [(and w (not (eqv? r 0)))
         (quarter-turned head k (advanced-function u (if (negative? r) (opposite w) w)))]
        [(eqv? quarters 0) #f]
        [(and (eqv? rest 0) (eq? head op:tan) (odd? k)) (make-node op:/ '(-1 0))]
        [else (quarter-turned head k (function-at rest))]))

;; -> the whole quarters of a turn in c π, and the rest r, -1/4 < r <= 1/4
(define (quarter-turns c)
  (define quarters (ceiling (- (* 2 c) 1/2)))
  (values quarters (- c (/ quarters 2))))

;; The functions of u, as a procedure of their operation.
(define ((function-at u) op)
  (if (eqv? u 0) ((operation-numeric op) 0) (make-node op (list u))))

;; Values at u plus the angle of the wave.
(define ((advanced-function u w) op)
  (define-values (s c) (values ((function-at u) op:sin) ((function-at u) op:cos)))
  (function-value op
                  (e:+ (e:* (wave-sine w) c) (e:* (wave-cosine w) s))
                  (e:- (e:* (wave-cosine w) c) (e:* (wave-sine w) s))))

;; The value at u + k π/2, by values at u.
(define (quarter-turned op k f)
  (cond [(eq? op op:tan) (if (odd? k) (e:/ -1 (f op:tan)) (f op:tan))]
        [else
         (define other (if (eq? op op:sin) op:cos op:sin))
         (define value (f (if (odd? k) other op)))
         (if (memv k (if (eq? op op:sin) '(2 3) '(1 2))) (e:negate value) value)]))

;; e to the sum of the terms, one of which is c i π:  iᵏ e^(i r π) e^u; or #f
(define (turned-exponential terms)
  (define t (findf (lambda (t) (equal? (cdr t) imaginary-pi)) terms))
  (define c (if t (inexact->exact (car t)) 0))
  (define-values (quarters r) (quarter-turns c))
  (define w (exact-wave (abs r)))

  (define u (and t (sum-of-terms (remq t terms))))
  (cond [(not (and t (or w (not (eqv? quarters 0))))) #f]
        [w (e:* (expt +i (modulo quarters 4))
                (e:* (e:+ (wave-cosine w) (e:* (if (negative? r) -i +i) (wave-sine w)))
                     (exponential-of u)))]
        [else (e:* (expt +i (modulo quarters 4)) (exponential-of (e:+ (e:* r imaginary-pi) u)))]))

(define imaginary-pi (make-node op:* (list +i exact-pi)))

(define (exponential-of u) (if (eqv? u 0) 1 (make-node op:exp (list u))))

;; ---------------------------------------------------------------------------
;; Short forms

(struct wave (sine cosine) #:authentic)

(define (opposite w) (wave (e:negate (wave-sine w)) (wave-cosine w)))

(define (root u) (make-node op:sqrt (list u)))

;; Of r π with 0 <= r <= 1/4; -> a wave, or #f
(define (exact-wave r)
  (case r
    [(0) (wave 0 1)]
    [(1/12) (wave (e:* 1/4 (e:- (root 6) (root 2))) (e:* 1/4 (e:+ (root 6) (root 2))))]
    [(1/10) (wave (e:* 1/4 (e:+ -1 (root 5))) (e:* 1/2 (e:* (e:+ 1 (root 5)) (sine-of-fifth))))]
    [(1/8) (wave (e:* (e:+ -1 (root 2)) (cosine-of-eighth)) (cosine-of-eighth))]
    [(1/6) (wave 1/2 (e:* 1/2 (root 3)))]
    [(1/5) (wave (sine-of-fifth) (e:* 1/4 (e:+ 1 (root 5))))]
    [(1/4) (wave (e:* 1/2 (root 2)) (e:* 1/2 (root 2)))]
    [else #f]))

(define (sine-of-fifth) (e:* 1/4 (root (e:+ 10 (e:* -2 (root 5))))))
(define (cosine-of-eighth) (e:* 1/2 (root (e:+ 2 (root 2)))))

;; ---------------------------------------------------------------------------
;; Inverse functions

;; n : asin, acos or atan of simplified arguments; -> a rational multiple of :pi, or #f
(define (inverse-multiple s n)
  (define x (and (andmap plain-constant? (node-args n)) (constant-value n)))
  (define k (and x (round (* parts (/ x pi)))))
  (and k
       (< (abs (- x (* k (/ pi parts)))) 1e-9)
       (let* ([u (e:* (/ (inexact->exact k) parts) exact-pi)]
              [rest (simplifier-simplify s (deviation n u))])
         (and (eqv? rest 0) u))))

;; A common denominator of the multiples that are known.
(define parts 120)

;; Zero if u, which is about the value of n, equals it exactly.
(define (deviation n u)
  (define args (node-args n))
  (define (of op) (make-node op (list u)))
  (cond [(eq? (node-head n) op:asin) (e:- (of op:sin) (car args))]
        [(eq? (node-head n) op:acos) (e:- (of op:cos) (car args))]
        [else
         (define x (if (null? (cdr args)) 1 (cadr args)))
         (e:- (e:* x (of op:sin)) (e:* (car args) (of op:cos)))]))

;; Without unknowns and without flonums?
(define (plain-constant? e)
  (all-leaves? (lambda (leaf) (or (pi-symbol? leaf) (and (number? leaf) (exact? leaf)))) e))
