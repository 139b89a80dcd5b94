#lang mechanics
;; The manifolds of the driven pendulum upside down cross  (SICM 4.3, Figure 4.7)
;;
;; With a drive the unstable manifold, red, and the stable one, blue, are no longer one separatrix.
;; The central crossing is in the dashed circle; its images, dots, are crossings as well, and come
;; to the saddle forwards and backwards without end.

(require mechanics/plot "strobe.rkt" "tangle.rkt")

(define central (list-ref crossings (quotient (length crossings) 2)))
(define (images f n) (for/fold ([all '()] [v central] #:result (reverse all)) ([k n])
                       (define next (f v))
                       (values (cons next all) next)))
(define-values (later earlier) (values (images image 5) (images image-back 5)))

(define picture (upper-half))
(draw-branch picture unstable #:color 'red)
(draw-branch picture stable #:color 'blue)
(for ([v (append later earlier)]) (plot-point picture (ref v 0) (ref v 1) #:size 6))
(plot-parametric picture
                 (lambda (a) (+ central (up (* 0.2 (cos a)) (* 0.35 (sin a)))))
                 0. :2pi #:style 'short-dash)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-4-7.png"))

(module+ test
  (require rackunit)
  (define (size v)
    (+ (abs ((principal-value :pi) (- (ref v 0) :pi))) (abs (ref v 1))))
  (define (near? v) (lambda (w) ((plane-near? 1e-7) v w)))
  (test-case "they do not coincide"
    (define (at points theta)
      (for/first ([v points] [w (cdr points)]
                  #:when (<= (* (- (ref v 0) theta) (- (ref w 0) theta)) 0))
        (ref v 1)))
    (check-true (> (- (at unstable 0.7) (at stable 0.7)) 0.2))
    (check-true (< (- (at unstable -0.7) (at stable -0.7)) -0.2)))
  (test-case "the central crossing is its own mirror image; those before are those after, mirrored"
    (check-= (ref central 0) 0 1e-8)
    (for ([v later] [w earlier])
      (check-= (ref v 0) (- (ref w 0)) 1e-6)
      (check-= (ref v 1) (ref w 1) 1e-6)))
  (test-case "images are crossings"
    (for ([v (list (car later) (car earlier))])
      (check-true (ormap (near? v) crossings))))
  (test-case "they come to the saddle, each nearer than the last by its multiplier"
    (define rho (car (fixed-point-multipliers saddle)))
    (for ([orbit (list later earlier)])
      (define sizes (map size orbit))
      (check-= (/ (list-ref sizes 3) (list-ref sizes 4)) rho 0.1)
      (check-true (< (list-ref sizes 4) 0.05)))))
