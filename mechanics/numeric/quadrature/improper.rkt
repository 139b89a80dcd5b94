#lang racket/base
;; Definite integrals of any kind, to infinity too; one that cannot be done is refused, and said
;; not to converge only where that is seen.

(require "half-line.rkt" "finite-range.rkt" "tail.rkt"
         "../checked-arguments.rkt"
         "../../error/complain.rkt" "../../error/failure.rkt")

(provide improper-quadrature)     ; (improper-quadrature f low high) -> flonum, error bound

;; The tolerance is relative to ∫ |f|, over each half of an infinite range.
;; (search?) tells whether to look for peaks between the nodes of the method; (peaks) is a list of
;; flonums near which there may be some.
(define (improper-quadrature f low high
                             #:tolerance [tolerance 1e-10]
                             #:search? [search? always]
                             #:peaks [peaks list]
                             #:name [who 'quadrature])
  (check-limit who low)
  (check-limit who high)
  (check-tolerance who tolerance)
  (define a (real->double-flonum low))
  (define b (real->double-flonum high))
  (define q (question tolerance who search? peaks))
  (cond [(= a b) (values 0.0 0.0)]
        [(> a b)
         (define-values (value bound) (between q f b a))
         (values (- value) bound)]
        [else (between q f a b)]))

(define (always) #t)

(define (check-limit who x)
  (unless (and (real? x) (= x x))
    (complain-of-datum who "a real number, perhaps infinite, as limit of integration" x)))

;; a < b
(define (between q f a b)
  (define (to-infinity from direction) (half-line q f from direction))
  (with-handlers* ([exn:fail:mechanics:not-convergent:integral?
                    (lambda (e) (raise-truly (question-who q) f a b e))])
    (cond [(and (= a -inf.0) (= b +inf.0))
           (both (lambda () (to-infinity 0.0 -1.0)) (lambda () (to-infinity 0.0 1.0)))]
          [(= b +inf.0) (to-infinity a 1.0)]
          [(= a -inf.0) (to-infinity b -1.0)]
          [else (over-interval q f a b)])))

;; ---------------------------------------------------------------------------

;; Raises the failure e again, as one of divergence if f is seen to have no integral near its place.
(define (raise-truly who f a b e)
  (define c (at-end (exn:fail:mechanics:not-convergent:integral-where e) a b))
  (define (diverges-to? side)
    (diverging? (in-logarithm f c side -1.0) (last-logarithm c)))
  (when (if (far? c a b)
            (diverging? (in-logarithm f 0.0 (if (> c 0.0) 1.0 -1.0) 1.0) (last-logarithm 0.0))
            (or (and (< a c) (diverges-to? -1.0)) (and (< c b) (diverges-to? 1.0))))
    (raise-divergent-integral who
                              (exn:fail:mechanics:not-convergent-value e)
                              (exn:fail:mechanics:not-convergent-error-estimate e)
                              (exn:fail:mechanics:not-convergent:integral-where e)))
  (raise e))

;; The end that c is nearly at, or c; 0, too, is known exactly.
(define (at-end c a b)
  (define (near? end)
    (and (rational? end) (<= (abs (- c end)) (* 1e-12 (if (= end 0.0) 1e-12 (abs end))))))
  (cond [(near? a) a] [(near? b) b] [(near? 0.0) 0.0] [else c]))

;; Is c so far on the way to infinity that it means infinity?
(define (far? c a b)
  (or (and (= b +inf.0) (> c (* 1e12 (+ 1.0 (if (> a -inf.0) (abs a) 0.0)))))
      (and (= a -inf.0) (< c (* -1e12 (+ 1.0 (if (< b +inf.0) (abs b) 0.0)))))))
