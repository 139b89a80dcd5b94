#lang mechanics
;; Exercise 4.6 (SICM 4.3.1): homoclinic tangles of the standard map
;; Checked: where the manifolds of the fixed point at 0 cross, how surely; the space they take
;; How: homoclinic-points, mapped forwards and back; squares that a manifold and an orbit visit

(require mechanics/book
         (only-in racket/list append* argmin))

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

;; How much space?  At K = 0.8, in squares of a sixtieth of a turn: those that a chaotic orbit of
;; 100,000 points visits, and those that the unstable manifold does, followed far and farther.
;; All of these are of the zone, and come nearer to filling it, but slowly: even the farthest here
;; is half of it, for much of the zone is behind broken curves, in which the gaps are small.
(define weak (standard-map 0.8))
(define side (/ :2pi 60))
(define (squares points)
  (define seen (make-hash))
  (define (place z) (floor (/ ((principal-value :2pi) z) side)))
  (for ([p points]) (hash-set! seen (list (place (ref p 0)) (place (ref p 1))) #t))
  seen)
(define zone
  (squares (for/fold ([all '()] [x 1e-3] [y 1e-3] #:result all) ([k 100000])
             (weak x y (lambda (x y) (values (cons (up x y) all) x y)) void))))
(define weak-saddle (find-fixed-point weak (up 0 0)))
(define (manifold-squares length)
  (squares (append* (for/list ([side '(1 -1)])
                      (invariant-manifold weak weak-saddle #:branch side #:length length)))))
(define tangles (map manifold-squares '(25 100 400)))
(define (part-filled tangle) (exact->inexact (/ (hash-count tangle) (hash-count zone))))
(map part-filled tangles)

(module+ test
  (require rackunit)
  (test-case "the crossings are real"
    (check-true (> (length crossings) 5))
    (check-true (< attempt 1e-3))
    (check-true (> slip attempt)))
  (test-case "and their images are crossings"
    (check-true again))
  (test-case "a longer manifold fills more of the zone, and nothing else"
    (define parts (map part-filled tangles))
    (check-true (< 0.2 (car parts) (cadr parts) (caddr parts) 0.6))
    (for ([tangle tangles])
      (define beside (for/sum ([square (hash-keys tangle)]) (if (hash-ref zone square #f) 0 1)))
      (check-true (<= beside 3)))))
