#lang racket/base
;; From order to order: formulas of the Bessel functions J and Y, with the sign s = −1.0, and of the
;; modified ones I and K, with s = 1.0.
;;
;;     J'/J, I'/I = ν/x + s/(2(ν + 1)/x + s/(2(ν + 2)/x + …)),
;;     f(ν − 1) = ν/x f(ν) + f'(ν),   f'(ν − 1) = (ν − 1)/x f(ν − 1) + s f(ν)     for J and I,
;;     f(ν + 1) = 2ν/x f(ν) + s f(ν − 1)     for Y and K.
;;
;; J and I lose no digits downwards, Y and K none upwards.

(require racket/flonum)

(provide first-fraction downwards upwards)

;; -> J'/J or I'/I at order ν by Lentz's method, and the sign of the function: J changes its sign
;; as often as a denominator is negative.
(define (first-fraction nu x sign)
  (define step (fl/ 2.0 x))
  (define (not-zero y) (if (fl< (flabs y) 1e-300) 1e-300 y))
  (define start (not-zero (fl/ nu x)))
  (let loop ([h start] [b (fl* nu step)] [c start] [d 0.0] [side 1.0])
    (define b* (fl+ b step))
    (define d* (fl/ 1.0 (not-zero (fl+ b* (fl* sign d)))))
    (define c* (not-zero (fl+ b* (fl/ sign c))))
    (define change (fl* c* d*))
    (define side* (if (fl< d* 0.0) (fl- 0.0 side) side))
    (if (fl< (flabs (fl- change 1.0)) 1e-16)
        (values (fl* h change) side*)
        (loop (fl* h change) b* c* d* side*))))

;; ratio, side : of first-fraction at order ν
;; -> in one unit, f at ν, and f and f' at μ = ν − m.  f at ν is 0 beside an f at μ that is too
;; great for this unit.
(define (downwards ratio side m nu x sign)
  (define unit (fl* side 1e-290))
  (for/fold ([start unit] [f unit] [slope (fl* ratio unit)]
             #:result (values start (if (fl= f 0.0) 1e-306 f) slope))
            ([k (in-range m)])
    (define up (fl/ (fl- nu (->fl k)) x))
    (define f* (fl+ (fl* up f) slope))
    (define slope* (fl+ (fl* (fl- up (fl/ 1.0 x)) f*) (fl* sign f)))
    (if (fl> (flabs f*) 1e280)
        (values 0.0 (fl* 1e-280 f*) (fl* 1e-280 slope*))
        (values start f* slope*))))

;; -> f at order μ + m, from those of μ and μ + 1; perhaps infinite
(define (upwards f next m mu x sign)
  (for/fold ([f f] [next next] #:result f) ([k (in-range 1 (+ m 1))])
    (values next
            (if (fl= (flabs next) +inf.0)
                next
                (fl+ (fl/ (fl* (fl* 2.0 (fl+ mu (->fl k))) next) x) (fl* sign f))))))
