#lang racket/base
;; Special relativity (FDG, chapter 11): intervals and boosts, frames, the sum of velocities, the
;; twin who travels.

(require mechanics mechanics/geometry
         "../../support/checks.rkt" "../../support/messages.rkt" "../../support/session.rkt")

;; ---------------------------------------------------------------------------
;; 4-tuples and boosts

(define xi (make-4tuple 'ct (up 'x 'y 'z)))

(test-case "a 4-tuple has a time and a way"
  (check-equal? xi (up 'ct 'x 'y 'z))
  (check-equal? (4tuple->ct xi) 'ct)
  (check-equal? (4tuple->space xi) (up 'x 'y 'z)))

(test-case "intervals"
  (check-prints (proper-time-interval xi)
                '(sqrt (+ (expt ct 2) (* -1 (expt x 2)) (* -1 (expt y 2)) (* -1 (expt z 2)))))
  (check-equal? (proper-time-interval (up 5 3 0 0)) 4)
  (check-equal? (proper-space-interval (up 3 0 5 0)) 4)
  (check-equal? (proper-time-interval (up 5/13 3/13 0 0)) 4/13)
  (check-equal? (proper-time-interval (up 5 3 4 0)) 0))

(test-case "a boost along x"
  (define root '(sqrt (- 1 (expt v 2))))
  (check-prints ((general-boost (up 'v 0 0)) xi)
                `(up (/ (+ ct (* v x)) ,root) (/ (+ (* ct v) x) ,root) y z)))

(test-case "intervals are the same for all observers"
  (define boosted ((general-boost (up 'vx 'vy 'vz)) xi))
  (check-prints (- (proper-space-interval boosted) (proper-space-interval xi)) 0)
  (check-identity (proper-space-interval boosted) (proper-space-interval xi))
  (check-identity (proper-time-interval boosted) (proper-time-interval xi)))

(test-case "a boost is one along an axis, turned"
  (define beta (up 'bx 'by 'bz))
  (define R (compose (Rx 'theta) (Ry 'phi) (Rz 'psi)))
  (define R-inverse (compose (Rz (- 'psi)) (Ry (- 'phi)) (Rx (- 'theta))))
  (check-identity ((general-boost beta) xi)
                  ((compose (extended-rotation R-inverse)
                            (general-boost (R beta))
                            (extended-rotation R))
                   xi)))

(test-case "a boost by direction and speed"
  (check-identity ((general-boost2 (up 2/7 3/7 6/7) 'v) xi)
                  ((general-boost (* 'v (up 2/7 3/7 6/7))) xi))
  (check-prints ((compose (general-boost2 (up -2/7 -3/7 -6/7) 'v)
                          (general-boost2 (up 2/7 3/7 6/7) 'v))
                 xi)
                '(up ct x y z)))

(test-case "no boost at all, in numbers: nothing is divided by 0"
  (check-equal? ((general-boost (up 0 0 0)) (up 1 2 3 4)) (up 1 2 3 4)))

(test-case "a Racket vector is a tuple here, too"
  (check-equal? (proper-time-interval #(5 3 0 0)) 4)
  (check-equal? ((general-boost #(3/5 0 0)) #(1 0 0 0)) (up 5/4 3/4 0 0)))

;; ---------------------------------------------------------------------------
;; Frames

(define (at frame . coordinates) (make-SR-coordinates frame (apply up coordinates)))

(test-case "coordinates know their frame"
  (define A (make-SR-frame 'A the-ether (up 1 0 0) 'va/c (at the-ether 0 0 0 0)))
  (check-equal? (SR-name (at A 'ct 'x 'y 'z)) 'A)
  (check-equal? (SR-name (at the-ether 'ct 'x 'y 'z)) 'the-ether)
  (check-equal? (SR-name ((chart A) ((point the-ether) (up 1 2 3 4)))) 'A)
  (check-equal? (SR-name ((chart the-ether) ((point A) (up 1 2 3 4)))) 'the-ether))

(test-case "a frame says what it was made of"
  (define A (make-SR-frame 'A the-ether (up 0 1 0) 'va/c (at the-ether 'cta 'xa 'ya 'za)))
  (check-equal? (boost-direction A) (up 0 1 0))
  (check-equal? (v/c A) 'va/c)
  (check-equal? (coordinate-origin A) (up 'cta 'xa 'ya 'za))
  (check-equal? (format "~a ~s ~v" A A A) "A A A"))

(test-case "to the event and back"
  (define A (make-SR-frame 'A the-ether (up 1 0 0) 'va/c (at the-ether 'cta 'xa 'ya 'za)))
  (define B (make-SR-frame 'B A (up 3/5 0 4/5) 'vb/c (at A 'ctb 'xb 'yb 'zb)))
  (for ([frame (list the-ether A B)] [other (list A B the-ether)])
    (define event ((point frame) (at frame 'ct 'x 'y 'z)))
    (check-prints ((chart frame) ((point other) ((chart other) event))) '(up ct x y z))))

(test-case "an event of the ether in a frame"
  (define A (make-SR-frame 'A the-ether (up 1 0 0) 'va/c (at the-ether 'cta 'xa 'ya 'za)))
  (define gamma (/ 1 (sqrt (- 1 (square 'va/c)))))
  (define-values (dct dx) (values (- 'ct 'cta) (- 'x 'xa)))
  (check-identity ((chart A) ((point the-ether) (at the-ether 'ct 'x 'y 'z)))
                  (up (* gamma (- dct (* 'va/c dx))) (* gamma (- dx (* 'va/c dct)))
                      (- 'y 'ya) (- 'z 'za)))
  (define start (at the-ether 'cta 'xa 'ya 'za))
  (check-identity ((event->coordinates the-ether A (up 1 0 0) 'va/c start)
                   ((coordinates->event the-ether A (up 1 0 0) 'va/c start)
                    (at A 'ct 'x 'y 'z)))
                  (up 'ct 'x 'y 'z)))

(test-case "the metric is the same in all frames"
  (define A (make-SR-frame 'A the-ether (up 2/7 3/7 6/7) 'v (at the-ether 'ct0 'x0 'y0 'z0)))
  (check-identity (make-Minkowski-metric A) SR-metric)
  (let-coordinates ([(up ct x y z) A])
    (check-identity SR-metric
                    (make-metric (lambda (u v) (+ (* -1 (dct u) (dct v)) (* (dx u) (dx v))
                                                  (* (dy u) (dy v)) (* (dz u) (dz v))))))))

(test-case "velocities add by Poincaré's formula"
  (define home (base-frame-maker 'home 'home))
  (define A (make-SR-frame 'A home (up 1 0 0) 'va/c (at home 0 0 0 0)))
  (define B (make-SR-frame 'B A (up 1 0 0) 'vb/c (at A 0 0 0 0)))
  (define B-origin ((chart home) ((point B) (at B 'ct 0 0 0))))
  (define sum '(/ (+ va/c vb/c) (+ 1 (* va/c vb/c))))
  (check-prints (/ (ref B-origin 1) (ref B-origin 0)) sum)
  (check-prints (add-v/cs 'va/c 'vb/c) sum)
  (check-equal? (add-v/cs 1/2 1/2) 4/5))

;; ---------------------------------------------------------------------------
;; The twin who travels at 24/25 of the speed of light for 25 years of those at home, and back.
;; Years are the unit of ct.

(test-case "the twin paradox"
  (define home (base-frame-maker 'home 'home))
  (define start ((point home) (at home 0 0 0 0)))
  (define outgoing
    (make-SR-frame 'outgoing home (up 1 0 0) 24/25 ((chart home) start)))
  (define turning ((point home) (at home 25 24 0 0)))
  (check-equal? (- ((chart outgoing) turning) ((chart outgoing) start)) (up 7 0 0 0))
  (define halfway ((point home) (at home 25 0 0 0)))
  (define (between a b frame) (- ((chart frame) b) ((chart frame) a)))
  (check-equal? (proper-time-interval (between start turning outgoing)) 7)
  (check-equal? (proper-time-interval (between start turning home)) 7)
  (check-equal? (proper-time-interval (between start halfway home)) 25)
  (check-equal? (proper-time-interval (between start halfway outgoing)) 25)

  (define home-at-outgoing-turning ((point outgoing) (at outgoing 7 (* 7 -24/25) 0 0)))
  (check-equal? ((chart home) home-at-outgoing-turning) (up 49/25 0 0 0))

  (define incoming (make-SR-frame 'incoming home (up -1 0 0) 24/25 ((chart home) turning)))
  (define end ((point home) (at home 50 0 0 0)))
  (check-equal? (between turning end incoming) (up 7 0 0 0))
  (define home-at-incoming-turning
    ((point incoming) (at incoming 0 (* 7 -24/25) 0 0)))
  (check-equal? ((chart home) home-at-incoming-turning) (up 1201/25 0 0 0))

  ;; The event at home when the traveller turns jumps by 46.08 years.
  (check-equal? (between home-at-outgoing-turning home-at-incoming-turning home)
                (up 1152/25 0 0 0))
  (check-equal? (proper-time-interval (between start end home)) 50))

;; ---------------------------------------------------------------------------

(define A (make-SR-frame 'A the-ether (up 1 0 0) 1/2 (up 0 0 0 0)))

(says
 [(make-4tuple 'ct (up 'x 'y))
  "make-4tuple: expected the way in space, an up tuple of 3\n  given: (up x y), an up tuple of 2"]
 [(4tuple->ct (up 1 2 3))
  "4tuple->ct: expected a 4-tuple (up ct x y z)\n  given: (up 1 2 3), an up tuple of 3"]
 [(4tuple->space 3)
  "4tuple->space: expected a 4-tuple (up ct x y z)\n  given: the number 3"]
 [(proper-time-interval (up 3 5 0 0))
  "proper-time-interval: no clock is at both events: they have a proper-space-interval\n"
  "  given: (up 3 5 0 0), an up tuple of 4"]
 [(proper-space-interval (up 5 3 0 0))
  "proper-space-interval: one clock can be at both events: they have a proper-time-interval\n"
  "  given: (up 5 3 0 0), an up tuple of 4"]
 [(general-boost 1/2)
  "general-boost: expected the velocity divided by c, an up tuple of 3\n  given: the number 1/2"]
 [(general-boost (up 1 0 0))
  "general-boost: an observer is slower than light: expected v/c less than 1\n"
  "  its square is: 1"]
 [(general-boost2 (up 1 1 0) 1/2)
  "general-boost2: a direction is a unit vector; the square of this one is 2\n"
  "  given: (up 1 1 0), an up tuple of 3"]
 [(general-boost2 (up 1/2 0 0) 1/2)
  "general-boost2: a direction is a unit vector; the square of this one is 1/4\n"
  "  given: (up 1/2 0 0), an up tuple of 3"]
 [(general-boost2 1 1/2)
  "general-boost2: expected the direction, an up tuple of 3\n  given: the number 1"]
 [(extended-rotation 'theta)
  "extended-rotation: expected a rotation, such as (Rx 'theta)\n  given: the symbol theta"]
 [(make-SR-frame 'B 'home (up 1 0 0) 1/2 (up 0 0 0 0))
  "make-SR-frame: expected a frame, such as the-ether\n  given: the symbol home"]
 [(base-frame-maker "home")
  "base-frame-maker: expected the quoted name of a frame\n  given: \"home\", a string"]
 [(make-SR-frame "B" the-ether (up 1 0 0) 1/2 (up 0 0 0 0))
  "make-SR-frame: expected the quoted name of a frame\n  given: \"B\", a string"]
 [(make-SR-frame 'B the-ether (up 1 0 0) 2 (up 0 0 0 0))
  "make-SR-frame: an observer is slower than light: expected v/c less than 1\n"
  "  its square is: 4"]
 [(make-SR-frame 'B A (up 1 0 0) 1/2 (make-SR-coordinates the-ether (up 0 0 0 0)))
  "point: these coordinates are in the-ether, not in A\n"
  "  given: (up 0 0 0 0), an up tuple of 4"]
 [((point the-ether) (make-SR-coordinates A (up 1 2 3 4)))
  "point: these coordinates are in A, not in the-ether\n"
  "  given: (up 1 2 3 4), an up tuple of 4"]
 [(make-SR-coordinates R4-rect (up 1 2 3 4))
  "make-SR-coordinates: expected a frame, such as the-ether\n"
  "  given: R4-rect"]
 [(SR-name (up 1 2 3 4))
  "SR-name: expected coordinates that know their frame\n"
  "  given: (up 1 2 3 4), an up tuple of 4"]
 [(v/c 'home)
  "v/c: expected a frame, such as the-ether\n  given: the symbol home"]
 [(v/c the-ether)
  "v/c: the-ether is a base frame: it is at rest, and has no ancestor"]
 [(boost-direction the-ether)
  "boost-direction: the-ether is a base frame: it is at rest, and has no ancestor"]
 [(coordinate-origin the-ether)
  "coordinate-origin: the-ether is a base frame: it is at rest, and has no ancestor"]
 [(base-frame-maker 'home 'elsewhere)
  "base-frame-maker: a base frame has no ancestor but itself\n  given: home and elsewhere"])
