#lang racket/base
;; The matrices of an implicit method's equations: c − J for a real number c, and for a
;; complex one a + ib, of which real and imaginary parts are unknowns side by side,
;;
;;     a − J    −b
;;       b    a − J.
;;
;; They are flvectors, row by row; J, of size n, holds its columns one after the other.

(require racket/flonum)

(provide shifted! shifted-pair! join! part!)

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
