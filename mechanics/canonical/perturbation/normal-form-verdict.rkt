#lang racket/base
;; The proof that a normal form (Birkhoff.rkt) is one, degree by degree: H, transformed by the Lie
;; derivatives of the generators as functions, is the normal form, and that commutes with the
;; oscillators.
;;
;; With flonums for coefficients nothing of this is exactly so, and a difference left by
;; rounding is no refutation.  There the differences are computed without rounding, of the
;; polynomials with the numbers as they are, and beside them majorants: the same sums of the
;; magnitudes of all that was added.  A difference that is a small part of its majorant is 0.0.

(require "Birkhoff.rkt" "complex-polynomial.rkt"
         "../Lie/Lie-derivative.rkt" "../Lie/Lie-triangle.rkt"
         "../../generic/arithmetic.rkt" "../../generic/up-down.rkt"
         "../../value/shape.rkt"
         "../../verdict/prove-zero.rkt")

(provide verify-normal-form)

(define (verify-normal-form N)
  (check-normal-form 'verify-normal-form N)
  (define polynomials (append (normal-form-given N) (normal-form-terms N) (normal-form-Ws N)))
  (define residual
    (if (for*/and ([f (in-list polynomials)] [c (in-hash-values f)]) (exact? c))
        (residual-of-functions N)
        (residual-of-numbers N)))
  (prove-zero residual #:variables (scalars (normal-form-state N))))

;; ---------------------------------------------------------------------------
;; Functions of the state

(define (residual-of-functions N)
  (define (functions fs) (map (lambda (f) (polynomial-function N f)) fs))
  (define transformed
    (carry (functions (normal-form-given N)) (map Lie-derivative (normal-form-generators N))
           (lambda (F L) (L F)) g:+ g:*))
  (define-values (kept state)
    (values (functions (normal-form-terms N)) (normal-form-state N)))
  (define with-oscillators (Lie-derivative (car kept)))
  (down (apply down (for/list ([F (in-list transformed)] [K (in-list kept)])
                      (g:- (F state) (K state))))
        (apply down (for/list ([K (in-list kept)]) ((with-oscillators K) state)))))

;; ---------------------------------------------------------------------------
;; Rounded numbers

;; A coefficient below this part of its majorant may be rounding.
(define rounded 1e-13)

(define (residual-of-numbers N)
  (define m (normal-form-modes N))
  (define-values (transformed kept commuted) (claims N exactly (polynomial-bracket m)))
  (define-values (greatest most greatest-commuted) (claims N magnitudes (majorant-bracket m)))
  (define (shown f bounds) (value-less-rounding N f bounds))
  (down (apply down (for/list ([F (in-list transformed)] [K (in-list kept)]
                               [A (in-list greatest)] [B (in-list most)])
                      (shown (polynomial-sum F (polynomial-scale -1 K)) (polynomial-sum A B))))
        (apply down (for/list ([f (in-list commuted)] [A (in-list greatest-commuted)])
                      (shown f A)))))

;; -> H transformed, the normal form, and its brackets with the oscillators
(define (claims N seen bracket)
  (define transformed
    (carry (map seen (normal-form-given N)) (map seen (normal-form-Ws N))
           bracket polynomial-sum polynomial-scale))
  (define kept (map seen (normal-form-terms N)))
  (values transformed kept (for/list ([K (in-list kept)]) (bracket (car kept) K))))

(define (exactly f) (for/hasheqv ([(e c) (in-hash f)]) (values e (inexact->exact c))))
(define (magnitudes f)
  (for/hasheqv ([(e c) (in-hash f)]) (values e (exact->inexact (magnitude c)))))

;; At the state of symbols.  A rounded zero, 0.0, is told from one that is exact.
(define (value-less-rounding N f bounds)
  (define left
    (for/hasheqv ([(e c) (in-hash f)]
               #:when (> (magnitude c) (* rounded (hash-ref bounds e 0.0))))
      (values e (exact->inexact c))))
  (cond [(positive? (hash-count left)) ((polynomial-function N left) (normal-form-state N))]
        [(positive? (hash-count f)) 0.0]
        [else 0]))
