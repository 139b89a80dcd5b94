#lang racket/base
;; Eigenvectors of a matrix of rational numbers.
;;
;; That of a rational eigenvalue λ the matrix A less λ maps to 0.  An irrational one is a root of a
;; quadratic equation Q(x) = x² − t x + d, whose other root is λ' = t − λ, and
;;
;;     Q(A) = (A − λ)(A − λ'),
;;
;; so that A − λ' maps the null space of Q(A), which is rational, to eigenvectors.  Their components
;; are p + q √D, of which decimals are taken in the end (surd.rkt).

(require racket/list
         "eigenvalues.rkt" "linear-algebra.rkt" "matrix.rkt" "surd.rkt"
         "../structure.rkt"
         "../../generic/arithmetic.rkt")

(provide exact-eigenvectors)

;; m : a matrix of rational numbers
;; -> a list of (value vector ...), up tuples; the greatest component of one with decimals is 1
(define (exact-eigenvectors m)
  (for/list ([found (in-list (remove-duplicates (exact-spectrum 'eigenvectors m)))])
    (define value (exact-value found))
    (cond [(not (surd? found)) (cons found (null-space (g:- m found)))]
          [value (cons value (map exact-values (surd-vectors m found)))]
          [else (cons (decimal 'eigenvectors found) (map decimals (surd-vectors m found)))])))

;; Lists of surds
(define (surd-vectors m λ)
  (define-values (p q D) (values (surd-p λ) (surd-q λ) (surd-D λ)))
  (define Q (g:+ (g:* m m) (g:* -2 p m) (- (* p p) (* q q D))))
  (for/list ([w (in-list (apart-with-images m (null-space Q)))])
    (for/list ([x (in-vector (structure-elements w))]
               [y (in-vector (structure-elements (g:* m w)))])
      (surd (- y (* p x)) (* q x) D))))

;; Vectors that are independent of one another and of the images of the others under m
(define (apart-with-images m vectors)
  (for/fold ([found '()] [all '()] #:result (reverse found)) ([w (in-list vectors)])
    (define more (list* w (g:* m w) all))
    (if (= (rank (apply matrix-by-columns (map up->list more))) (length more))
        (values (cons w found) more)
        (values found all))))

(define (up->list v) (vector->list (structure-elements v)))

(define (exact-values surds) (apply up (map exact-value surds)))

(define (decimals surds)
  (define numbers (map surd->number surds))
  (define greatest (argmax size-squared numbers))
  (apply up (map (lambda (x) (exact->inexact (/ x greatest))) numbers)))

(define (size-squared z) (+ (expt (real-part z) 2) (expt (imag-part z) 2)))
