#lang mechanics
;; The manifolds of the driven pendulum upside down, A = 0.05 m and ω = 4.2 ω₀, for figures 4.7 and
;; 4.8: the unstable one that leaves (−π, 0) upwards, and the stable one that comes to (π, 0) from
;; above.  Without a drive both are the upper half of the separatrix.

(require mechanics/plot "strobe.rkt")

(provide T T-back saddle unstable stable crossings image image-back upper-half)

(define T (strobe-map 0.05 4.2))
(define T-back (strobe-map 0.05 -4.2))
(define (image v) (T (ref v 0) (ref v 1) up void))
(define (image-back v) (T-back (ref v 0) (ref v 1) up void))

(define saddle (find-fixed-point T (up -3.14 0.)))
(define unstable (invariant-manifold T saddle #:length 24 #:gap 0.06))
(define stable
  (invariant-manifold T saddle #:stable? #t #:inverse T-back #:branch -1 #:length 24 #:gap 0.06))

;; Where they cross first, from left to right.
(define crossings
  (sort (homoclinic-points T saddle #:inverse T-back #:stable-branch -1 #:length 14 #:gap 0.2)
        < #:key (lambda (v) (ref v 0))))

(define (upper-half) (frame :-pi :pi -1 8 #:width 500 #:height 400 #:x-label "θ" #:y-label "p_θ"))
