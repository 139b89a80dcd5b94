#lang racket/base
;; Common parts of several classes: forms of either sign, exponents, relations at a point.

(require "../judge/evaluate.rkt" "../judge/flonum.rkt" "../judge/point.rkt"
         "../statement.rkt")

(provide random-symbol random-symbols random-linear random-form random-exponent
         random-point relations-at)

(define (random-symbol) (pick '(x y z a)))

;; Two that differ.
(define (random-symbols)
  (define u (random-symbol))
  (values u (pick (remq u '(x y z a)))))

;; Differences in both orders, sums, symbols: of either sign, as they come.
(define (random-linear)
  (define-values (u v) (random-symbols))
  (define c (pick '(1 2 3 1/2)))
  (pick (list u `(- ,c ,u) `(- ,u ,c) `(+ ,u ,c) `(- ,u ,v) `(+ ,u ,v) `(- ,u) `(* ,u ,v)
              `(- (* ,c ,u) ,v) `(/ ,u ,v))))

;; The same, and what has a sign of its own that shows only to who looks closely.
(define (random-form)
  (define-values (u v) (random-symbols))
  (if (chance 3)
      (pick (list `(- 2 (cos ,u)) `(- (cos ,u) 2) `(- ,u (exp ,u)) `(- (* ,u (exp (- ,u))) 1)
                  `(- (atan ,u) 2) `(- (* (sin ,u) (cos ,v)) 1) `(+ (square ,u) (square ,v))
                  `(- 1 (exp ,u)) `(asinh ,u) `(- ,u (square ,u)) `(- (square ,u) ,v)
                  `(sin ,u) `(exp ,u) `(- 1 (exp 1)) `(- (sqrt 2) 1) `(- 1 (sqrt 3))))
      (random-linear)))

(define (random-exponent)
  (pick '(1/2 1/2 1/3 1/4 -1/2 2/3 3/2 -1/4 3 2 -1 2 -1/3 5/2)))

;; ---------------------------------------------------------------------------
;; Relations that hold at a point

(define (random-point)
  (random-numbers '(x y z a) (* 2 (random 20))))

;; So many relations between random forms, all true at the point.
(define (relations-at numbers count)
  (define where (make-point numbers 0))
  (let loop ([k count])
    (cond [(eqv? k 0) '()]
          [else
           (define form (if (chance 2) (random-symbol) (random-linear)))
           (define v (value-at form where flonum-intervals))
           (define s (and (value? v) (sign-of v)))
           (case s
             [(1) (cons (list (pick '(> >=)) form 0) (loop (- k 1)))]
             [(-1) (cons (list (pick '(< <=)) form 0) (loop (- k 1)))]
             [else (loop k)])])))
