#lang racket/base
;; Characteristic polynomials without division (Berkowitz 1984).
;;
;; Let A = (a R; C M), a number, a row, a column and the rest, m by m.  Expanding
;; |x - A| along the first row and column, with the adjugate of x - M written out
;; in powers of x, the coefficients of |x - A| are those of |x - M| times the
;; lower triangular Toeplitz matrix of m + 2 rows whose first column is
;;
;;     1, -a, -R C, -R M C, -R M² C, ...
;;
;; Starting with the last diagonal entry that takes about n⁴/4 products in any
;; commutative ring, where expansion by minors would take n 2ⁿ⁻¹.  The polynomial
;; solves systems as well: by Cayley and Hamilton
;;
;;     Aⁿ + p₁ Aⁿ⁻¹ + ... + pₙ = 0,  so  pₙ A⁻¹ b = -(Aⁿ⁻¹ + p₁ Aⁿ⁻² + ... + pₙ₋₁) b.

(require racket/list
         "minors.rkt")

(provide characteristic-coefficients characteristic-determinant adjugate-times)

;; (1 p₁ ... pₙ) with |x - A| = xⁿ + p₁ xⁿ⁻¹ + ... + pₙ.
(define (characteristic-coefficients ops A)
  (for/fold ([p '(1)]) ([i (in-range (sub1 (vector-length A)) -1 -1)])
    (Toeplitz-times ops (Toeplitz-column ops A i) p)))

(define (characteristic-determinant ops A)
  (signed-last ops (vector-length A) (characteristic-coefficients ops A)))

;; (-1)ⁿ pₙ
(define (signed-last ops n p)
  (if (even? n) (last p) (negate ops (last p))))

;; 1, -a, -R C, -R M C, ... of the rows and columns from i on.
(define (Toeplitz-column ops A i)
  (define n (vector-length A))
  (define row (vector-ref A i))
  (define C (for/vector #:length (- n i 1) ([k (in-range (add1 i) n)])
              (vector-ref (vector-ref A k) i)))
  (define last-powers
    (let loop ([v C] [count (vector-length C)])
      (if (eqv? count 0)
          '()
          (cons (negate ops (dot ops row (add1 i) v))
                (if (eqv? count 1) '() (loop (times ops A (add1 i) v) (sub1 count)))))))
  (list* 1 (negate ops (vector-ref row i)) last-powers))

;; The product of the Toeplitz matrix with this first column and p, one longer
;; than p.
(define (Toeplitz-times ops column p)
  (for/list ([k (in-range (length column))])
    (for/fold ([sum 0]) ([t (in-list (reverse (take column (add1 k))))] [c (in-list p)])
      (add-product ops sum t c))))

;; ---------------------------------------------------------------------------
;; Systems

;; -> a determinant d and vectors |A| A⁻¹ b, d · x = b, for each b in bs.
(define (adjugate-times ops A bs)
  (define n (vector-length A))
  (define p (characteristic-coefficients ops A))
  (values (signed-last ops n p)
          (for/list ([b (in-list bs)])
            (define w
              (for/fold ([w b]) ([c (in-list (take (cdr p) (sub1 n)))])
                (for/vector #:length n ([x (in-vector (times ops A 0 w))] [y (in-vector b)])
                  (add-product ops x c y))))
            (if (odd? n) w (for/vector #:length n ([x (in-vector w)]) (negate ops x))))))

;; ---------------------------------------------------------------------------
;; Vectors

;; The rows and columns of A from i on, times v.
(define (times ops A i v)
  (for/vector #:length (vector-length v) ([k (in-range i (vector-length A))])
    (dot ops (vector-ref A k) i v)))

;; row from i on, times v
(define (dot ops row i v)
  (for/fold ([sum 0]) ([a (in-vector row i)] [x (in-vector v)])
    (add-product ops sum a x)))

(define (add-product ops sum a x)
  (if (or (eqv? a 0) (eqv? x 0))
      sum
      ((operations-add ops) sum ((operations-multiply ops) a x))))

(define (negate ops x) ((operations-subtract ops) 0 x))
