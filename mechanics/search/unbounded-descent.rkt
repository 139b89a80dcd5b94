#lang racket/base
;; Does a function of a number fall without bound where a search found it least?
;;
;; Towards a minimum, or a kink as of |x| or √|x|, it falls by less and less from ten times a
;; distance to the distance, as that shrinks; towards a pole by more and more, and towards the
;; pole of a logarithm by as much.

(provide bottomless?)

;; value : flonum -> flonum, +inf.0 where there is none; y : the value at x
(define (bottomless? value x y low high)
  (define length (abs (- high low)))
  (define (at distance)
    (define there (+ x (* distance length)))
    (if (<= (min low high) there (max low high)) (value there) +inf.0))
  (define ((fall side) distance) (- (at (* side 10.0 distance)) (at (* side distance))))
  (define (grows? fall)
    (define last (fall 1e-8))
    (and (< (* 1e-9 (abs y)) last +inf.0)
         (let ([middle (fall 1e-6)])
           (and (< 0.0 middle +inf.0) (>= last (* 0.9 middle))
                (let ([first (fall 1e-4)])
                  (and (< 0.0 first +inf.0) (>= middle (* 0.9 first))))))))
  (or (grows? (fall 1.0)) (grows? (fall -1.0))))
