#lang mechanics
;; Exercise 4.6 (SICM 4.3.1): homoclinic tangles of the standard map
;; Checked: where the manifolds of the fixed point at 0 cross, how surely
;; How: invariant-manifold and homoclinic-points, crossings mapped forwards and back

(require mechanics/book
         (only-in racket/list argmin))

(define K 1.4)
(define T (standard-map K))
(define T-back (standard-map-inverse K))
(define saddle (find-fixed-point T (up 0 0)))
(fixed-point-multipliers saddle)

(define crossings
  (homoclinic-points T saddle #:inverse T-back #:stable-branch -1 #:length 16))
(length crossings)

;; An attempt: they are real, for backwards and forwards both come to the fixed point; the slip, a
;; point near by, does not.
(define (distance-to-saddle x y)
  (define (turned z) (abs ((principal-value :pi) z)))
  (max (turned x) (turned y)))
(define (nearest map p)
  (for/fold ([least +inf.0] [p p] #:result least) ([k 12])
    (values (min least (distance-to-saddle (ref p 0) (ref p 1)))
            (map (ref p 0) (ref p 1) up void))))
(define (both p) (max (nearest T p) (nearest T-back p)))
(define central
  (argmin (lambda (p) (abs (- (ref p 0) :pi))) crossings))
(define attempt (both central))
(define slip (both (+ central (up 1e-3 0))))
(list attempt slip)

;; The image of a crossing is a crossing again.
(define image (T (ref central 0) (ref central 1) up void))
(define (near? p q)
  (and (< (abs ((principal-value :pi) (- (ref p 0) (ref q 0)))) 1e-8)
       (< (abs ((principal-value :pi) (- (ref p 1) (ref q 1)))) 1e-8)))
(define again (ormap (lambda (p) (near? p image)) crossings))
again

(module+ test
  (require rackunit)
  (test-case "the crossings are real"
    (check-true (> (length crossings) 5))
    (check-true (< attempt 1e-3))
    (check-true (> slip attempt)))
  (test-case "and their images are crossings"
    (check-true again)))
