#lang racket/base
;; Matrices in units of about their greatest entry: products of entries then neither
;; overflow nor vanish.  The unit is a power of two, so that nothing is rounded.

(require racket/flonum
         "../flvector.rkt")

(provide unit-of in-units)

;; v : flvector of finite numbers
(define (unit-of v)
  (define size (greatest v))
  (if (fl= size 0.0)
      1.0
      (flexpt 2.0 (flmin 1023.0 (flfloor (fl/ (fllog size) (fllog 2.0)))))))

(define (in-units v unit) (flvector-map (lambda (x) (fl/ x unit)) v))
