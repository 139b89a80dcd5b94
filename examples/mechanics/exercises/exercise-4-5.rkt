#lang mechanics
;; Exercise 4.5 (SICM 4.3): how infinitely many lobes find room
;; Checked: that lobes of a tangle have one area, and that their images overlap earlier ones
;; How: polygons between crossings of the standard map's manifolds; orbits that come back

(require mechanics/book
         (only-in racket/list argmin drop index-of take))

(define K 1.4)
(define-values (T T-back) (values (standard-map K) (standard-map-inverse K)))
(define saddle (find-fixed-point T (up 0 0)))
(define (image p) (T (ref p 0) (ref p 1) up void))

;; The unstable branch that leaves upwards, the stable one that comes from the other side of θ = π,
;; and crossings: A on the line of symmetry, its image, and B between.
(define unstable (invariant-manifold T saddle #:length 14 #:gap 0.01))
(define stable
  (invariant-manifold T saddle #:stable? #t #:inverse T-back #:branch -1 #:length 8 #:gap 0.01))
(define crossings
  (homoclinic-points T saddle #:inverse T-back #:stable-branch -1 #:length 6))
(define A (argmin (lambda (p) (abs (- (ref p 0) :pi))) crossings))
(define A-next (image A))
(define B
  (argmin (lambda (p) (abs (- (ref p 0) (* 1/2 (+ (ref A 0) (ref A-next 0)))))) crossings))

;; The part of a branch from one of its points to another.
(define (distance p q)
  (+ (abs ((principal-value :pi) (- (ref p 0) (ref q 0)))) (abs (- (ref p 1) (ref q 1)))))
(define (part branch p q)
  (define (place v) (index-of branch (argmin (lambda (w) (distance v w)) branch)))
  (define-values (i j) (values (place p) (place q)))
  (if (<= i j)
      (append (list p) (take (drop branch (+ i 1)) (max 0 (- j i 1))) (list q))
      (reverse (part branch q p))))

;; A lobe: from p to q on the unstable branch, and back on the stable one.
(define (lobe p q) (append (part unstable p q) (part stable q p)))
(define (area points)
  (abs (for/sum ([p points] [q (append (cdr points) (list (car points)))])
         (* 1/2 (- (* (ref p 0) (ref q 1)) (* (ref q 0) (ref p 1)))))))
(define-values (first second third)
  (values (lobe A B) (lobe B A-next) (lobe A-next (image B))))
(define areas (map area (list first second third)))
areas

;; So many would fill the torus if they were side by side; there are infinitely many.
(define room (/ (square :2pi) (car areas)))
room

;; An attempt at the answer: manifolds do not cross themselves, but a lobe is bounded by both: its
;; images cross the stable side of earlier lobes.  A point of the lobe comes back to it.  The
;; slip: that images of a lobe stay outside of it.
(define (inside? p polygon)
  (for/fold ([in? #f]) ([a polygon] [b (append (cdr polygon) (list (car polygon)))])
    (define-values (x y) (values (ref p 0) (ref p 1)))
    (if (and (not (eq? (> (ref a 1) y) (> (ref b 1) y)))
             (< x (+ (ref a 0) (* (- (ref b 0) (ref a 0))
                                  (/ (- y (ref a 1)) (- (ref b 1) (ref a 1)))))))
        (not in?)
        in?)))
(define center (/ (apply + first) (length first)))
(define (comes-back p)
  (for/fold ([p (image p)] [n 1] [back #f] #:result back) ([k 3000])
    (values (image p) (+ n 1) (or back (and (inside? p first) n)))))
(define returns
  (for*/list ([i 4] [j 4]
              [p (list (+ center (up (* 0.01 (- i 1.5)) (* 0.01 (- j 1.5)))))]
              #:when (inside? p first))
    (comes-back p)))
(define back (filter values returns))
(list (length back) (apply min back))

(module+ test
  (require rackunit)
  (test-case "lobes on both sides, and their images, have one area"
    (check-true (> (car areas) 0.01))
    (for ([a (cdr areas)]) (check-= (/ a (car areas)) 1 1e-2)))
  (test-case "points of a lobe come back to it: its images overlap it"
    (check-true (> (length back) 0))
    (check-true (> (apply min back) 1))))
