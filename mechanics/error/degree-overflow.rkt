#lang racket/base
;; A polynomial that its ring has no room for.  Whoever sized the ring catches this and
;; makes a wider one, or has a bug.

(provide (struct-out exn:algebra:degree-overflow) raise-degree-overflow)

;; An operation would give a polynomial of total degree `degree`, more than the ring's
;; `bound`.
(struct exn:algebra:degree-overflow exn:fail (degree bound))

(define (raise-degree-overflow degree bound)
  (raise (exn:algebra:degree-overflow
          (format (string-append "polynomial: the degree would pass the bound of the ring\n"
                                 "  degree: ~a\n  bound: ~a")
                  degree bound)
          (current-continuation-marks)
          degree bound)))
