#lang racket/base
;; Animations: what they are made of, what they print as, and what cannot be animated.

(require file/convertible
         (only-in mechanics up down evolve-trajectory coordinate velocity
                  [sin generic-sin] [- minus])
         mechanics/animate
         (only-in mechanics/show/animation/animation animation-film)
         (only-in mechanics/show/animation/on-demand why-no-pictures)
         mechanics/show/animation/film
         (only-in mechanics/show/animation/scenery make-scenery scenery->pict scenery-size)
         (only-in racket/math exact-ceiling)
         (only-in mechanics/show/animation/portrait-shapes
                  make-portrait portrait-dot portrait-shapes portrait-size)
         (only-in mechanics/show/animation/shapes spot-center stroke-points)
         (only-in racket/list last)
         (only-in mechanics/show/display/picture-advice advice)
         (only-in pict pict? pict-width pict-height pict->argb-pixels filled-rectangle blank)
         "../../support/checks.rkt" "../../support/messages.rkt" "../../support/skip.rkt")

(define drawable? (not (why-no-pictures)))
(define no-drawing "the shared libraries of racket/draw are not installed: no pictures")

;; θ̈ = −sin θ
(define (fall s)
  (up 1 (velocity s) (minus (generic-sin (coordinate s)))))
(define swing (evolve-trajectory fall (up 0 1 0) 4))

(define (schedule-of a) (film-schedule (animation-film a)))

(test-case "it prints as what it shows, and a terminal is told how to see it"
  (define a (animate swing (draw-pendulum)))
  (for ([form '("~a" "~s" "~v")])
    (check-equal? (format form a) "(animation from 0.0 to 4.0 of (draw-pendulum #:length 1))"))
  (check-equal? (convert a 'text) "(animation from 0.0 to 4.0 of (draw-pendulum #:length 1))")
  (check-equal? (advice a)
                (string-append "to see an animation a: (animation-show a), or "
                               "(animation-save a \"motion.gif\") or \"motion.html\""))
  (check-true (animation? a))
  (check-false (animation? swing)))

(test-case "pictures are taken at the rate and speed that are asked for, both ends among them"
  (define (times . options)
    (define s (schedule-of (keyword-apply animate '(#:frames-per-second #:speed) options
                                          (list swing (draw-pendulum)))))
    (for/list ([i (in-range (schedule-count s))]) (schedule-time s i)))
  (check-equal? (times 1 1) '(0.0 1.0 2.0 3.0 4.0))
  (check-equal? (times 2 2) '(0.0 1.0 2.0 3.0 4.0))
  (check-equal? (times 1 4) '(0.0 4.0))
  (check-equal? (times 1 100) '(0.0 4.0))
  (check-equal? (length (times 25 1)) 101)
  (check-equal? (length (times 25 1/2)) 201))

(test-case "a part of the motion, and backwards"
  (define s (schedule-of (animate swing (draw-pendulum) #:from 3 #:to 1)))
  (check-equal? (schedule-span s) -2.0)
  (check-equal? (schedule-time s 0) 3)
  (check-equal? (schedule-time s (- (schedule-count s) 1)) 1)
  (check-equal? (schedule-seconds s) 2.0))

(test-case "a function from the time to states is a motion, too"
  (define a (animate (lambda (t) (up t (* 2 t) 2)) (draw-pendulum) #:from 0 #:to 1))
  (check-equal? (format "~a" a) "(animation from 0 to 1 of (draw-pendulum #:length 1))")
  (define twice (animate (lambda (t) (up t (* 2 t) 2)) (draw-pendulum) #:from 0 #:to 4 #:speed 2
                         #:frames-per-second 1))
  (check-equal? (schedule-count (schedule-of twice)) 3))

(test-case "a trajectory in numbers of higher precision has its last picture"
  (define fine (evolve-trajectory fall (up 0 1 0) 1/4 #:precision 80))
  (define a (animate fine (draw-pendulum) #:trail #t #:phase-portrait #t))
  (when drawable? (check-pred pict? (animation-frame a 1/4))))

;; ---------------------------------------------------------------------------
;; Pictures

(define (pixels p) (pict->argb-pixels p))

(skip-unless drawable? no-drawing

  (test-case "a picture is the drawing at that time; beside it the phase portrait"
    (define d (draw-pendulum #:width 200))
    (define a (animate swing d))
    (check-equal? (pixels (animation-frame a 2)) (pixels (d (swing 2))))
    (check-not-equal? (pixels (animation-frame a 2)) (pixels (animation-frame a 1)))
    (define both (animation-frame (animate swing d #:phase-portrait #t) 2))
    (check-equal? (list (pict-width both) (pict-height both)) '(470.0 260.0)))

  (test-case "the trail grows; with a time it is that long at most"
    ;; pixels of the trail's color
    (define (length-of-trail a t)
      (define bytes (pixels (animation-frame a t)))
      (for/sum ([i (in-range 0 (bytes-length bytes) 4)])
        (define-values (r g b)
          (values (bytes-ref bytes (+ i 1)) (bytes-ref bytes (+ i 2)) (bytes-ref bytes (+ i 3))))
        (if (and (> r 190) (< 60 g 130) (< b 100)) 1 0)))
    (define (circling t) (up t t 1))
    (define all (animate circling (draw-pendulum) #:from 0 #:to 6 #:trail #t))
    (define some (animate circling (draw-pendulum) #:from 0 #:to 6 #:trail #t #:trail-time 1))
    (define lengths (for/list ([t '(0 1 2 4 6)]) (length-of-trail all t)))
    (check-equal? lengths (sort lengths <))
    (check-equal? (car lengths) 0)
    (check-true (> (cadr lengths) 50))
    (check-true (> (list-ref lengths 4) (* 4 (cadr lengths))))
    (check-= (length-of-trail some 6) (length-of-trail all 1) (* 0.3 (length-of-trail all 1)))
    ;; backwards: from the last time on
    (define back (animate circling (draw-pendulum) #:from 6 #:to 0 #:trail #t))
    (define a-while (animate circling (draw-pendulum) #:from 6 #:to 0 #:trail #t #:trail-time 1))
    (define one (length-of-trail all 1))
    (check-equal? (length-of-trail back 6) 0)
    (check-= (length-of-trail back 5) one (* 0.3 one))
    (check-= (length-of-trail a-while 5) one (* 0.3 one))
    (check-= (length-of-trail a-while 1) one (* 0.3 one))
    (check-true (> (length-of-trail back 0) (* 4 one))))

  (test-case "a drawing of one's own: pictures of several sizes, a trail in pixels"
    (define (grows s) (filled-rectangle (+ 10 (* 5 (coordinate s))) 10))
    (define a (animate (lambda (t) (up t t 1)) grows #:from 0 #:to 4
                       #:trail (lambda (s) (up (coordinate s) 5))))
    (for ([t '(0 2 4)])
      (check-equal? (pict-width (animation-frame a t)) 30.0)))

  (test-case "editors get pictures, animated where the format can be"
    (define a (animate swing (draw-pendulum #:width 60) #:frames-per-second 2))
    (check-equal? (subbytes (convert a 'gif-bytes) 0 6) #"GIF89a")
    (check-equal? (subbytes (convert a 'png-bytes) 1 4) #"PNG")
    (check-true (regexp-match? #rx"<svg " (convert a 'svg-bytes)))
    (check-equal? (convert a 'no-such-format 'default) 'default)))

;; ---------------------------------------------------------------------------
;; Mistakes

(define (no-picture s) 'none)
(define (often s) (blank 10))

(skip-unless drawable? no-drawing
  (test-case "the pictures are as large as is told, with a portrait and without"
    (for ([portrait? '(#f #t)])
      (define s (make-scenery (animation-film (animate swing (draw-pendulum #:width 100)
                                                       #:phase-portrait portrait?))))
      (define-values (width height) (scenery-size s))
      (define p (scenery->pict s 1.0))
      (check-equal? (list width height) (map exact-ceiling (list (pict-width p) (pict-height p))))))
  (test-case "a trail passes over points without a finite place"
    (define (gone s) (if (< 1 (coordinate s) 2) (up (coordinate s) +nan.0) (up (coordinate s) 1)))
    (define a (animate (lambda (t) (up t t 1)) (lambda (s) (blank 100 100)) #:from 0 #:to 3
                       #:trail gone))
    (check-pred pict? (animation-frame a 3))))

;; ---------------------------------------------------------------------------
;; The phase portrait

(define (portrait-of . points) (portrait-shapes (make-portrait points "x" "y")))

;; -> the least and the greatest abscissa and ordinate
(define (bounds-of points)
  (define (each choose part) (apply choose (map part points)))
  (define-values (x y) (values (lambda (p) (vector-ref p 0)) (lambda (p) (vector-ref p 1))))
  (list (each min x) (each max x) (each min y) (each max y)))

(test-case "the curve of a portrait nearly fills the box of its axes"
  (define shapes (portrait-of #(0.0 5.0) #(10.0 7.0) #(4.0 6.0)))
  (define-values (box curve) (values (stroke-points (car shapes)) (stroke-points (last shapes))))
  (define-values (l r b d) (apply values (bounds-of box)))
  (check-equal? box (list (vector l b) (vector r b) (vector r d) (vector l d)))
  (check-true (< 0.0 l (/ portrait-size 2) r portrait-size))
  (check-true (< 0.0 b (/ portrait-size 2) d portrait-size))
  (define-values (wide high) (values (- r l) (- d b)))
  (for ([outer (list l r b d)] [inner (bounds-of curve)] [size (list wide wide high high)])
    (check-true (< 0.02 (/ (abs (- inner outer)) size) 0.1))))

(test-case "what rests has a portrait, in the middle of its axes"
  (define p (make-portrait '(#(3.0 0.0) #(3.0 0.0)) "x" "y"))
  (define-values (l r b d) (apply values (bounds-of (stroke-points (car (portrait-shapes p))))))
  (define dot (spot-center (car (portrait-dot p #(3.0 0.0)))))
  (check-= (vector-ref dot 0) (/ (+ l r) 2) 1e-9)
  (check-= (vector-ref dot 1) (/ (+ b d) 2) 1e-9))

(says
 [(animate 3 (draw-pendulum))
  "animate: expected a trajectory, such as evolve-trajectory gives, or a function from the time "
  "to states\n  given: the number 3"]
 [(animate cons (draw-pendulum))
  "animate: expected a trajectory, such as evolve-trajectory gives, or a function from the time "
  "to states\n  given: the procedure `cons`"]
 [(animate (lambda (t) (up t t 1)) (draw-pendulum))
  "animate: a function of the time has no beginning and no end; say #:from and #:to"]
 [(animate (lambda (t) (up t t 1)) (draw-pendulum) #:from 0)
  "animate: a function of the time has no beginning and no end; say #:from and #:to"]
 [(animate swing 3)
  "animate: expected a drawing, a function from states to picts, such as (draw-pendulum)\n"
  "  given: the number 3"]
 [(animate swing (draw-pendulum-chain))
  "draw-pendulum-chain: draws a system of 2 coordinates; this state has 1\n"
  "  state: (up 0.0 1.0 0.0)"]
 [(animate swing (draw-pendulum) #:from 1 #:to 1)
  "animate: the animation would take no time\n  from: 1\n  to: 1"]
 [(animate swing (draw-pendulum) #:to 5)
  "trajectory: the time is outside the trajectory\n  time: 5\n  from: 0.0\n  to: 4.0"]
 [(animate swing (draw-pendulum) #:speed 0)
  "animate: expected a positive speed, in units of time per second\n"
  "  given: the number 0"]
 [(animate swing (draw-pendulum) #:frames-per-second 1000)
  "animate: expected from 1 to 100 frames per second\n  given: the number 1000"]
 [(animate swing (draw-pendulum) #:trail-time -1)
  "animate: expected a positive time of the trail, or #f\n  given: the number -1"]
 [(animate swing (draw-pendulum) #:trail 'bob)
  "animate: expected #t, #f, or a function from states to points, as trail\n  given: the symbol bob"]
 [(animate swing (draw-pendulum) #:trail velocity)
  "animate: a point of the trail is no point of the plane, such as (up x y) or (cons x y)\n"
  "  given: the number 0.0"]
 [(animate swing (make-drawing 0 1 0 1 no-picture) #:trail #t)
  "animate: this drawing does not say which point leaves a trail\n"
  "  #:trail takes a function from states to points, too"]
 [(animate swing (draw-pendulum) #:phase-portrait 1)
  "animate: there is no coordinate of that number\n  number: 1\n  coordinates: 1"]
 [(animate swing (draw-pendulum) #:phase-portrait 'yes)
  "animate: expected #t, #f, the number of a coordinate, or a phase-plane, as phase portrait\n"
  "  given: the symbol yes"]
 [(animate (lambda (t) (up t 0)) (draw-pendulum) #:from 0 #:to 1 #:phase-portrait #t)
  "animate: a phase portrait of states without velocities or momenta needs a (phase-plane x y)\n"
  "  state: (up 0 0)"]
 [(animate swing (draw-pendulum) #:title 3)
  "animate: expected a string as title\n  given: the number 3"]
 [(phase-plane 1 2)
  "phase-plane: expected a function of the state\n  given: the number 1"]
 [(animation-frame swing 1)
  "animation-frame: expected an animation, such as (animate trajectory (draw-pendulum))\n"
  "  given: (trajectory from 0.0 to 4.0), a function"]
 [(animation-frame (animate swing (draw-pendulum) #:to 1) 2)
  "animation-frame: the time is outside the animation\n  time: 2\n  from: 0.0\n  to: 1"])

(skip-unless drawable? no-drawing
  (test-case "a drawing that gives no pict is told with the state"
    (check-message (string-append "animate: the drawing gives no pict of this state\n"
                                  "  state: (up 0.0 1.0 0.0)\n  given: the symbol none")
                   (animate swing no-picture))
    (define (later s) (if (< (coordinate s) 0.5) (void) (blank 10)))
    (check-exn #rx"^animation: the drawing gives no pict of this state\n  state: [(]up "
               (lambda () (animation-frame (animate swing later) 2))))
  (test-case "the user's own error reaches the user"
    (define (fails s) (raise-user-error 'mine "broken"))
    (check-exn #rx"^mine: broken$" (lambda () (animate swing fails)))))
