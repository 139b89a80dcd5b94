#lang racket/base
;; The matrices of an implicit method's equations, and their solutions: c − J for a real
;; number c, and for a complex one a + ib, of which real and imaginary parts are unknowns
;; side by side,
;;
;;     a − J    −b
;;       b    a − J.
;;
;; They are flvectors, row by row; J, of size n, holds its columns one after the other.

(require racket/fixnum
         racket/flonum
         "../fields.rkt"
         "../linear/factored-system.rkt")

(provide make-matrices matrices-J
         factor-matrices! solve-real! solve-complex!)

;; real, complex : factored once factor-matrices! has been called; pair : room for both parts
(struct matrices (n J real complex real-exchanges complex-exchanges pair) #:authentic)

(define (make-matrices n)
  (define 2n (* 2 n))
  (matrices n (make-flvector (* n n))
            (make-flvector (* n n)) (make-flvector (* 2n 2n))
            (make-fxvector n) (make-fxvector 2n)
            (make-flvector 2n)))

;; -> have both an inverse?
(define (factor-matrices! m c a b)
  (define-fields matrices m n J real complex real-exchanges complex-exchanges)
  (shifted! real n J c)
  (shifted-pair! complex n J a b)
  (and (factor! real n real-exchanges)
       (factor! complex (* 2 n) complex-exchanges)))

;; The right-hand side v, or its real and imaginary parts v and w, become the solution.
(define (solve-real! m v)
  (solve-factored! (matrices-real m) (matrices-n m) (matrices-real-exchanges m) v))

(define (solve-complex! m v w)
  (define-fields matrices m n complex complex-exchanges pair)
  (join! pair v w n)
  (solve-factored! complex (* 2 n) complex-exchanges pair)
  (part! pair v w n))

;; ---------------------------------------------------------------------------

(define (shifted! m n J c)
  (for* ([i (in-range n)] [j (in-range n)])
    (define x (flvector-ref J (+ i (* j n))))
    (flvector-set! m (+ (* i n) j) (if (= i j) (fl- c x) (fl- 0.0 x)))))

(define (shifted-pair! m n J a b)
  (define width (* 2 n))
  (for* ([i (in-range n)] [j (in-range n)])
    (define x (flvector-ref J (+ i (* j n))))
    (define d (if (= i j) (fl- a x) (fl- 0.0 x)))
    (define o (if (= i j) b 0.0))
    (flvector-set! m (+ (* i width) j) d)
    (flvector-set! m (+ (* i width) n j) (fl- 0.0 o))
    (flvector-set! m (+ (* (+ n i) width) j) o)
    (flvector-set! m (+ (* (+ n i) width) n j) d)))

;; Two vectors as one, and back.
(define (join! pair v w n)
  (for ([i (in-range n)])
    (flvector-set! pair i (flvector-ref v i))
    (flvector-set! pair (+ n i) (flvector-ref w i))))

(define (part! pair v w n)
  (for ([i (in-range n)])
    (flvector-set! v i (flvector-ref pair i))
    (flvector-set! w i (flvector-ref pair (+ n i)))))
