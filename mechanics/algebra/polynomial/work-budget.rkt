#lang racket/base
;; Meters: the cost allowed to arithmetic, counted in terms and never in time.
;;
;; A ring may have a meter.  Work in the ring is charged to it, as many times as
;; terms are multiplied or looked at; so the count says
;; within a small factor how long things took, and is the same every time.  While
;; an allowance is given, a charge beyond it raises `overspent`.

(provide make-meter meter-left
         meter-charge! meter-allow! meter-allow-all!
         (struct-out overspent))

;; left : may be negative; stop : a charge that takes `left` below it is refused
(struct meter ([left #:mutable] [stop #:mutable]) #:authentic)

(struct overspent ())

(define (make-meter n) (meter n -inf.0))

(define (meter-charge! m n)
  (define left (- (meter-left m) n))
  (set-meter-left! m left)
  (when (< left (meter-stop m)) (raise (overspent))))

;; Allows charges of at most n from now on.
(define (meter-allow! m n) (set-meter-stop! m (- (meter-left m) n)))

(define (meter-allow-all! m) (set-meter-stop! m -inf.0))
