#lang racket/base
;; Has the matrix of derivatives at a root an inverse, as far as the root is known?
;;
;; At a double root, where x² = 0, Newton's method stops at some x = 10⁻¹², or rounding stops it
;; at 10⁻⁸ of where it should be: the slope 2x there is not zero, and its inverse says nothing.
;; So derivatives are looked at, too, where the root may as well be: in the direction v in which
;; they are least, as far as Newton's next steps reach, and rounding.  A slope along v that
;; loses half of itself on the way is no slope.

(require racket/flonum
         racket/list
         "../numeric/finite-number.rkt" "../numeric/flvector.rkt"
         "../numeric/linear-algebra/row-matrix.rkt" "../numeric/linear-algebra/singular-values.rkt")

(provide steady?)

;; jacobian : flvector -> vector of rows, which are J at the root x; y : the values there
(define (steady? jacobian J x y)
  (and (all-entries? finite? J)
       (let-values ([(u least v) (least-singular J)])
         (define step (/ (- (dot y u)) least))
         (define rounding (* 1.5e-8 (greatest x)))
         (define (holds? s)
           (or (= s 0.0) (> (dot u (image (jacobian (along x s v)) v)) (* 0.5 least))))
         (and (> least 0.0)
              (andmap holds? (list step (* 2.0 step) (* 3.0 step) rounding (- rounding)))))))

;; J v = least u
(define (least-singular J)
  (define-values (us sizes vs) (singular-values (columns-of J)))
  (values (last us) (last sizes) (last vs)))

(define (image rows v)
  (for/flvector #:length (vector-length rows) ([row (in-vector rows)])
    (for/fold ([sum 0.0]) ([a (in-vector row)] [x (in-flvector v)])
      (fl+ sum (fl* (real->double-flonum a) x)))))
