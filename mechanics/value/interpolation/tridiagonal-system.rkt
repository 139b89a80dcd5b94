#lang racket/base
;; Equations a xᵢ₋₁ + b xᵢ + c xᵢ₊₁ = right, row by row, with b the largest as in
;; splines: elimination downwards needs no exchange of rows.  The right-hand sides, and
;; so the unknowns, may be values of any kind.

(require "../../generic/arithmetic.rkt")

(provide (struct-out equation) homogeneous opposite solve-tridiagonal)

(struct equation (a b c right) #:authentic)

(define (homogeneous e)
  (equation (equation-a e) (equation-b e) (equation-c e) 0))

;; The neighbours exchanged, for the other end.
(define (opposite e)
  (equation (equation-c e) (equation-b e) (equation-a e) (equation-right e)))

;; A list of rows -> the vector of unknowns.
(define (solve-tridiagonal rows)
  ;; reduced, the last one first: xᵢ = right - c xᵢ₊₁
  (define reduced
    (for/fold ([done '()]) ([e (in-list rows)])
      (define-values (c0 right0)
        (if (null? done) (values 0 0) (values (caar done) (cdar done))))
      (define pivot (g:- (equation-b e) (g:* (equation-a e) c0)))
      (cons (cons (g:/ (equation-c e) pivot)
                  (g:/ (subtract (equation-right e) (times (equation-a e) right0)) pivot))
            done)))
  (list->vector
   (for/fold ([xs '()]) ([e (in-list reduced)])
     (cons (if (null? xs) (cdr e) (subtract (cdr e) (times (car e) (car xs)))) xs))))

;; Where 0 stands for nothing, whatever the kind of values.
(define (times a x) (if (eqv? a 0) 0 (g:* a x)))
(define (subtract x y) (if (eqv? y 0) x (g:- x y)))
