#lang racket/base
;; The curve of points that come from an unstable fixed point (SICM 4.3, p. 308).
;;
;; Near the fixed point it is the direction (dx, dy) that the map stretches by A: a point at the
;; parameter s of the curve is the n-th image of the one at s/Aⁿ, and with n so great that this
;; is about eps, the latter is on the straight line.

(require (only-in racket/math exact-floor)
         "iterated-map.rkt" "map-of-the-plane.rkt" "plane-points.rkt"
         "../../calculus/perturbed-value.rkt"
         "../../error/complain.rkt"
         "../../generic/arithmetic.rkt" "../../generic/describe.rkt" "../../generic/function.rkt"
         "../../generic/number-argument.rkt")

(provide unstable-manifold)

;; -> a function parameter -> point; negative parameters belong to the other branch
(define (unstable-manifold T xe ye dx dy A eps)
  (check-map 'unstable-manifold T)
  (define-values (x y across up stretch nearest)
    (apply values (map checked (list xe ye dx dy A eps))))
  (check-stretch stretch A)
  (when (and (zero? across) (zero? up))
    (complain 'unstable-manifold "the direction (dx, dy) is 0; it may be of any length but that"))
  (positive-number 'unstable-manifold eps "a positive distance from the fixed point")
  (unary-function (lambda () (list 'unstable-manifold (value->datum T) xe ye dx dy A eps)) (s)
    (define n (times-stretched (checked (innermost s)) stretch nearest))
    (define start (g:/ s (expt stretch n)))
    (image-of 'unstable-manifold (iterated-map T n)
              (g:+ x (g:* across start)) (g:+ y (g:* up start))
              make-point)))

(define (times-stretched s A eps)
  (if (= s 0)
      0
      (max 0 (exact-floor (/ (log (/ (abs s) eps)) (log (abs A)))))))

(define (checked x) (finite-number 'unstable-manifold x))

(define (check-stretch A given)
  (unless (> (abs A) 1)
    (complain 'unstable-manifold
              (string-append
               "the multiplier of an unstable direction is greater than 1 in size; given ~a"
               "\n  a stable manifold is the unstable one of the inverse map, with 1/A")
              (describe-with-value given))))
