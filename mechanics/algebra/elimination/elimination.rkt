#lang racket/base
;; Results of elimination in a matrix: determinant, solutions, rank, null space.
;; Entries are exact numbers, or expressions, whose canonical form under
;; assumptions A decides which are zero.
;;
;; Every answer is #f where the attempt was given up as too large.

(require "bareiss.rkt" "block-form.rkt" "exact-coefficients.rkt"
         "../assumption/assumption-set.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt")

(provide eliminated-determinant eliminated-solutions
         (struct-out kernel-basis) eliminated-kernel)

;; ---------------------------------------------------------------------------
;; Square matrices

;; #f also if the determinant might have more than `limit` terms, or the entries
;; satisfy relations: then there are better ways.
(define (eliminated-determinant matrix limit [A no-assumptions])
  (define n (vector-length matrix))
  (call-with-coefficients matrix A
    (lambda (c)
      (and (coefficients-unscale c)
           (<= (coefficients-most-terms c) limit)
           (determinant c (reduced c n) n)))))

(define (reduced c width) (eliminate (coefficients-domain c) (coefficients-rows c) width))

(define (determinant c E n)
  (define sign (* (permutation-sign (vector->list (echelon-order E)))
                  (permutation-sign (vector->list (echelon-columns E)))))
  (cond [(< (echelon-rank E) n) 0]
        [else
         (define d (echelon-pivot E))
         ((coefficients-unscale c) (if (eqv? sign 1) d ((coefficients-negate c) d)))]))

;; The rows of x with matrix · x = right, both vectors of rows; 'singular if that
;; has none or many.  limit : as above
(define (eliminated-solutions matrix right limit [A no-assumptions])
  (define n (vector-length matrix))
  (call-with-coefficients (beside matrix right) A
    (lambda (c)
      (and (<= (coefficients-most-terms c) limit)
           (let ([E (reduced c n)])
             (if (= (echelon-rank E) n) (read-solutions c E n) 'singular))))))

(define (read-solutions c E n)
  (define x (make-vector n))
  (for ([row (in-vector (echelon-rows E))] [j (in-vector (echelon-columns E))])
    (vector-set! x j (for/vector ([a (in-vector row n)])
                       ((coefficients-divide c) a (vector-ref row j)))))
  x)

;; ---------------------------------------------------------------------------
;; Matrices of any shape

;; rank : of the matrix;  vectors : list of vectors, a basis of its null space,
;; each without a common divisor;  assumptions : those taken for granted
(struct kernel-basis (rank vectors assumptions) #:transparent)

;; Of a matrix of at least one row.
(define (eliminated-kernel matrix [A no-assumptions])
  (define n (vector-length (vector-ref matrix 0)))
  (call-with-coefficients matrix A
    (lambda (c)
      (define E (reduced c n))
      (define free (list-tail (vector->list (echelon-columns E)) (echelon-rank E)))
      (define vectors (for/list ([j (in-list (sort free <))]) (null-vector c E n j)))
      (kernel-basis (echelon-rank E) vectors ((coefficients-assumptions c))))))

;; The free unknown j is 1; then xₚ = -aₚⱼ/aₚₚ.
(define (null-vector c E n j)
  (define D (coefficients-domain c))
  (define x (make-vector n (ratio (domain-zero D) (domain-one D))))
  (vector-set! x j (ratio (domain-one D) (domain-one D)))
  (for ([row (in-vector (echelon-rows E))] [p (in-vector (echelon-columns E))]
                                           [_ (in-range (echelon-rank E))])
    (vector-set! x p (ratio ((coefficients-negate c) (vector-ref row j)) (vector-ref row p))))
  (list->vector ((coefficients-primitive c) (vector->list x))))
