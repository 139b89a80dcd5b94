#lang racket/base
;; From rotations that change in time to the angular velocity (SICM 2.2, p. 126).
;;
;; If M(t) turns the body from where it was to where it is, then DM Mᵀ is antisymmetric, since
;; M Mᵀ = 1, and takes a vector v to ω × v.  On axes that turn with the body ω is Mᵀ ω.

(require "rotation.rkt" "three-vector.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/describe.rkt"
         "../generic/function.rkt" "../generic/printed-function.rkt"
         "../generic/wrong-argument.rkt"
         "../lagrangian/coordinate-transformation.rkt" "../lagrangian/local-tuple.rkt"
         "../value/simplify.rkt" "../value/structure.rkt"
         "../value/matrix/linear-algebra.rkt" "../value/matrix/matrix.rkt"
         "../verdict/prove-zero.rkt" "../verdict/verdict.rkt")

(provide M-of-q->omega-of-t M-of-q->omega-body-of-t M->omega M->omega-body
         antisymmetric->column-matrix m:antisymmetric? wcross->w)

;; ---------------------------------------------------------------------------
;; Along a path

;; (((M-of-q->omega-of-t M-of-q) q) t), a matrix of one column
(define (M-of-q->omega-of-t M-of-q)
  (along-path 'M-of-q->omega-of-t M-of-q (lambda (omega M) omega)))

(define (M-of-q->omega-body-of-t M-of-q)
  (along-path 'M-of-q->omega-body-of-t M-of-q (lambda (omega M) (g:* (transpose M) omega))))

;; choose : ω in space and M -> the result
(define (along-path who M-of-q choose)
  (unless (and (pointwise? M-of-q) (accepts? M-of-q 1))
    (complain who "expected a function from coordinates to a rotation; given ~a"
              (describe-function M-of-q)))
  (define name (call-datum who M-of-q))
  (unary-function name (given-q)
    (define q (path who given-q))
    (define (M-on-path t) (M-of-q (q t)))
    (unary-function (lambda () (list (name) (value->datum given-q))) (t)
      (define M (M-on-path t))
      (check-rotation who M)
      (choose (vector-of (g:* ((D M-on-path) t) (transpose M))) M))))

;; As functions of the local tuple
(define (M->omega M-of-q) (Gamma-bar (M-of-q->omega-of-t M-of-q)))
(define (M->omega-body M-of-q) (Gamma-bar (M-of-q->omega-body-of-t M-of-q)))

;; ---------------------------------------------------------------------------
;; Antisymmetric matrices

;; ω of the matrix of v ↦ ω × v
(define (vector-of A)
  (matrix-by-rows (list (matrix-ref A 2 1)) (list (matrix-ref A 0 2)) (list (matrix-ref A 1 0))))

(define (antisymmetric->column-matrix A)
  (unless (m:antisymmetric? A)
    (complain-of-argument 'antisymmetric->column-matrix "an antisymmetric 3 by 3 matrix" A
                          (if (matrix-of? A 3 3)
                              (format "\n  with its transpose it adds up to: ~a"
                                      (value->text (simplify (symmetric-part A))))
                              "")))
  (vector-of A))

(define (symmetric-part A) (g:+ A (transpose A)))

(define (m:antisymmetric? A)
  (and (matrix? A)
       (= (m:num-rows A) (m:num-cols A))
       (let ([sum (symmetric-part A)])
         (or (g:zero? sum) (proved? (prove-zero sum))))))

;; A : an antisymmetric matrix, or the tuple of its columns -> ω, an up tuple
(define (wcross->w A)
  (cond [(matrix-of? A 3 3) (column-matrix->up (vector-of A))]
        [(and (tuple? A) (= (s:length A) 3)) (up (ref A 1 2) (ref A 2 0) (ref A 0 1))]
        [else (complain-of-argument 'wcross->w "a 3 by 3 matrix" A)]))
