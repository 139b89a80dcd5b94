#lang racket/base
;; The kernel of two functions of which each has the other in its derivative, as sin and cos.
;;
;; The angle of a drive grows as the time does: coefficient k of its sine and cosine follows from
;; the one before alone.

(require racket/unsafe/ops
         "convolution.rkt"
         (only-in "kernels.rkt" last-index))

(provide pair-kernel)

;; r' = u p a' and p' = v r a', given d of a
(define (pair-kernel r u p v d degree)
  (if (= degree 1) (turning-kernel r u p v d) (general-pair-kernel r u p v d degree)))

(define (general-pair-kernel r u p v d degree)
  (define end (last-index degree))
  (lambda (k)
    (define order (unsafe-fx->fl k))
    (convolve k 1 (smaller k end) ([s d p] [t d r])
              (begin (put! r k (unsafe-fl/ (unsafe-fl* u s) order))
                     (put! p k (unsafe-fl/ (unsafe-fl* v t) order))))))

(define (turning-kernel r u p v d)
  (lambda (k)
    (define order (unsafe-fx->fl k))
    (define rate (at d 1))
    (define before (unsafe-fx- k 1))
    (put! r k (unsafe-fl/ (unsafe-fl* (unsafe-fl* u rate) (at p before)) order))
    (put! p k (unsafe-fl/ (unsafe-fl* (unsafe-fl* v rate) (at r before)) order))))
