#lang racket/base
;; The stable and the unstable manifold of a hyperbolic point, as curves without gaps, and where
;; they cross (SICM 4.3).
;;
;; A branch is followed by its parameter s (unstable-manifold.rkt).  It is stretched from one turn
;; of the map to the next, so the step from s to s (1 + h) is made shorter where the next point
;; would be farther away than allowed, and longer where points crowd.
;;
;; Where a branch of one crosses a branch of the other is found between the points of both, and
;; made exact by Newton's method in both parameters.

(require racket/flonum
         racket/list
         "fixed-points.rkt" "iterated-map.rkt" "jacobian.rkt" "map-of-the-plane.rkt"
         "plane-points.rkt" "unstable-manifold.rkt"
         "../../error/complain.rkt" "../../error/failure.rkt" "../../error/refusal.rkt"
         "../../generic/arithmetic.rkt" "../../generic/compare.rkt"
         "../../generic/define-plain.rkt" "../../generic/describe.rkt"
         "../../generic/number-argument.rkt" "../../generic/up-down.rkt"
         "../../generic/wrong-argument.rkt"
         "../../numeric/whole-turns.rkt"
         "../../search/find-root.rkt"
         (only-in "../../value/structure.rkt" ref))

(provide invariant-manifold homoclinic-points)

;; curve : parameter -> point; points : of (vector s x y), by rising size of s
(struct branch (curve points))

;; -> the points of a branch; neighbours are at most `gap` apart
(define-plain (invariant-manifold map p #:stable? [stable? #f] #:inverse [inverse #f]
                                  #:branch [side 1] #:length [length 5.0] #:gap [gap 0.05])
  (define who 'invariant-manifold)
  (define b (follow who map p stable? inverse side length gap))
  (for/list ([v (in-list (branch-points b))]) (make-point (vector-ref v 1) (vector-ref v 2))))

;; -> the points where the unstable branch crosses the stable one, within `length` of both
(define-plain (homoclinic-points map p #:inverse [inverse #f]
                                 #:branch [side 1] #:stable-branch [stable-side side]
                                 #:length [length 5.0] #:gap [gap 0.05])
  (define who 'homoclinic-points)
  (define u (follow who map p #f inverse side length gap))
  (define s (follow who map p #t inverse stable-side length gap))
  (define angles (fixed-point-angles p))
  (remove-duplicates
   (filter values
           (for*/list ([a (in-list (pieces (branch-points u)))]
                       [b (in-list (pieces (branch-points s)))]
                       #:when (cross? a b angles))
             (crossing u s a b angles)))
   (nearness-by-angles angles 1e-8)))

;; ---------------------------------------------------------------------------
;; Following a branch

(define (follow who map p stable? inverse side length gap)
  (check-asked who map p stable? inverse side length gap)
  (define T (iterated-map (if stable? inverse map) (fixed-point-period p)))
  (define-values (A dx dy) (stretched p stable?))
  (define at (fixed-point-coordinates p))
  (define size (flsqrt (fl+ (fl* dx dx) (fl* dy dy))))
  (define sign (real->double-flonum side))
  (define curve
    (unstable-manifold T (abscissa at) (ordinate at)
                       (fl/ (fl* sign dx) size) (fl/ (fl* sign dy) size) A straight-distance))
  (branch curve (march who curve (fixed-point-angles p) (comparand length) (comparand gap))))

;; Within this distance of the fixed point the curve is taken for straight.  The error across the
;; curve, the square of this, shrinks as the curve is stretched; that of rounding along it does not.
(define straight-distance 3e-5)

;; -> the multiplier by which the branch is stretched, and its direction x, y
(define (stretched p stable?)
  (define J (fixed-point-matrix p))
  (define-values (greater less) (eigenvalues J))
  (define-values (dx dy) (eigenvector J (if stable? less greater) (not stable?)))
  (values (if stable? (/ 1.0 less) greater) (real->double-flonum dx) (real->double-flonum dy)))

;; The greatest number of points of a branch.
(define most-points 200000)

(define (march who curve angles length gap)
  (define (at s)
    (define-values (x y) (start-coordinates who (curve s)))
    (vector s x y))
  (define first (* 0.5 gap))
  (let loop ([last (at (min first 1e-3))] [h 0.1] [far 0.0] [points '()] [count 0])
    (define next (at (* (vector-ref last 0) (+ 1 h))))
    (define d (apart last next angles))
    (cond [(and (> d gap) (> h 1e-12)) (loop last (* 0.5 h) far points count)]
          [(>= far length) (reverse (cons last points))]
          [(> count most-points) (raise-too-long who far count)]
          [else
           (loop next (if (< d (* 0.4 gap)) (min 0.5 (* 1.6 h)) h) (+ far d) (cons last points)
                 (+ count 1))])))

(define (apart v w angles)
  (define-values (x y) (difference v w angles))
  (flsqrt (fl+ (fl* x x) (fl* y y))))

(define (difference v w angles)
  (define (part k angle?)
    (define d (fl- (vector-ref w k) (vector-ref v k)))
    (if angle? (whole-turns-less d) d))
  (values (part 1 (car angles)) (part 2 (cadr angles))))

;; ---------------------------------------------------------------------------
;; Crossings

;; Two neighbours on a branch.
(struct piece (from to))

(define (pieces points)
  (for/list ([v (in-list points)] [w (in-list (cdr points))]) (piece v w)))

;; Do two pieces cross?  The ends of each are on different sides of the line through the other.
(define (cross? a b angles)
  (define near (apart (piece-from a) (piece-from b) angles))
  (and (fl< near (fl+ (apart (piece-from a) (piece-to a) angles)
                      (apart (piece-from b) (piece-to b) angles)))
       (sides-differ? a b angles)
       (sides-differ? b a angles)))

(define (sides-differ? a b angles)
  (define-values (x y) (difference (piece-from a) (piece-to a) angles))
  (define (side v)
    (define-values (u w) (difference (piece-from a) v angles))
    (fl- (fl* x w) (fl* y u)))
  (fl< (fl* (side (piece-from b)) (side (piece-to b))) 0.0))

;; -> the crossing, or #f where Newton's method finds none between these points
(define (crossing u s a b angles)
  (define-values (low high) (values (vector-ref (piece-from a) 0) (vector-ref (piece-to a) 0)))
  (define-values (low* high*) (values (vector-ref (piece-from b) 0) (vector-ref (piece-to b) 0)))
  (define (miss p)
    (define-values (P Q) (values ((branch-curve u) (ref p 0)) ((branch-curve s) (ref p 1))))
    (up (less-turns (g:- (abscissa P) (abscissa Q)) (car angles))
        (less-turns (g:- (ordinate P) (ordinate Q)) (cadr angles))))
  (define (between? low x high)
    (define half (* 0.5 (- high low)))
    (<= (- low half) x (+ high half)))
  (if-raised exn:fail:mechanics? #f
    (define root
      (find-root miss (up (* 0.5 (+ low high)) (* 0.5 (+ low* high*))) #:tolerance 1e-8))
    (and (between? low (ref root 0) high) (between? low* (ref root 1) high*)
         ((branch-curve u) (ref root 0)))))

(define (less-turns d angle?)
  (if angle?
      (let ([number (real->double-flonum (comparand d))])
        (g:- d (- number (whole-turns-less number))))
      d))

;; ---------------------------------------------------------------------------

;; Complains unless the inverse undoes the map near the fixed point.
(define (check-inverse who map inverse at)
  (define-values (x y) (values (+ 1e-3 (ref at 0)) (+ 2e-3 (ref at 1))))
  (define back
    (image-of who map x y (lambda (x y) (image-of who inverse x y up))))
  (define off
    (max (abs (whole-turns-less (- (comparand (ref back 0)) x)))
         (abs (whole-turns-less (- (comparand (ref back 1)) y)))))
  (unless (< off 1e-6)
    (complain who (string-append "what was given as #:inverse does not undo the map\n  start: ~a"
                                 "\n  there and back: ~a")
              (value->text (up x y)) (value->text back))))

(define (check-asked who map p stable? inverse side length gap)
  (check-map who map)
  (check-argument who fixed-point? p "a fixed point, as find-fixed-point finds one")
  (unless (memq (fixed-point-kind p) '(hyperbolic reflection-hyperbolic))
    (complain who "only hyperbolic points have manifolds; this one is ~a\n  ~a"
              (fixed-point-kind p) (value->text (fixed-point-coordinates p))))
  (when stable?
    (unless inverse
      (complain who "the stable manifold is followed backwards: give the inverse map, #:inverse"))
    (check-map who inverse)
    (check-inverse who map inverse (fixed-point-coordinates p)))
  (unless (memv side '(1 -1)) (complain-of-argument who "one of the branches 1 and -1" side))
  (positive-number who length "a positive length")
  (positive-number who gap "a positive gap"))

(define (raise-too-long who far count)
  (raise-not-convergent who "the branch has more points than allowed" far #f #:show? #f
                        "points" count "length so far" far))
