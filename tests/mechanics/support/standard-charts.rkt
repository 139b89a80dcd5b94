#lang racket/base
;; The charts that have names, by manifold, each with a box of coordinates in which charts of the
;; manifold are regular.

(require mechanics/geometry mechanics/generic/up-down)

(provide standard-charts         ; list of lists (chart (low high) ...), one list for each manifold
         random-coordinates      ; entry -> tuple, or a number
         entry-chart)

(define plane '((0.3 1.2) (0.4 1.3)))

(define standard-charts
  `(((,R1-rect (-2.0 2.0)))
    ((,R2-rect ,@plane) (,R2-polar ,@plane))
    ((,R3-rect ,@plane (0.2 1.1)) (,R3-cyl ,@plane (0.2 1.1)) (,R3-spherical ,@plane (0.2 1.1)))
    ((,R4-rect ,@plane ,@plane) (,R4-cyl ,@plane ,@plane))
    ((,spacetime-rect (-1.0 1.0) ,@plane (0.2 1.1))
     (,spacetime-sphere (-1.0 1.0) ,@plane (0.2 1.1)))
    ((,S1-circular (0.2 1.3)) (,S1-tilted (-1.3 -0.2)))
    ((,S2-spherical (0.3 1.2) (0.3 1.2)) (,S2-tilted (0.3 1.2) (0.3 1.2))
     (,S2-stereographic (1.1 1.4) (1.2 1.5)) (,S2-gnomonic (0.3 1.2) (0.3 1.2)))
    ((,S3-spherical (0.3 1.2) (0.3 1.2) (0.3 1.2)) (,S3-tilted (0.3 1.2) (0.3 1.2) (0.3 1.2))
     (,S3-stereographic (1.1 1.4) (1.2 1.5) (0.3 0.9)))
    ((,Euler-angles (0.3 1.2) (0.3 1.2) (0.3 1.2))
     (,alternate-angles (0.3 1.2) (0.3 1.2) (0.3 1.2)))))

(define (entry-chart entry) (car entry))

(define (random-coordinates entry)
  (define xs (for/list ([range (in-list (cdr entry))])
               (+ (car range) (* (random) (- (cadr range) (car range))))))
  (if (null? (cdr xs)) (car xs) (apply up xs)))
