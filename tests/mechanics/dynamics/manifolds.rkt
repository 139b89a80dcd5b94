#lang racket/base
;; Manifolds of hyperbolic points as curves, and where they cross.

(require mechanics
         mechanics/book
         "../support/checks.rkt" "../support/close.rkt" "../support/messages.rkt")

(define K 1.4)
(define T (standard-map K))
(define inverse (standard-map-inverse K))
(define saddle (find-fixed-point T (up 0 0)))

(define (lengths points)
  (for/list ([p points] [q (cdr points)])
    (define turned ((principal-value :pi) (- p q)))
    (sqrt (square turned))))

(test-case "the curve is as long as asked for, and has no gaps"
  (define steps (lengths (invariant-manifold T saddle #:length 8 #:gap 0.02)))
  (check-true (< (apply max steps) 0.020001))
  (check-close (apply + steps) 8 0.05))

(test-case "it begins within a gap of the fixed point"
  (for ([gap '(0.05 1e-4)])
    (define first-one (car (invariant-manifold T saddle #:length (* 10 gap) #:gap gap)))
    (check-true (< 0 (euclidean-norm first-one) gap))))

(test-case "all its points come from the fixed point"
  (for ([p (invariant-manifold T saddle #:length 6 #:gap 0.3)])
    (define back ((iterated-map inverse 15) (abscissa p) (ordinate p) make-point void))
    (check-true ((torus-near? 2e-3) back (make-point 0 0)) (format "~a ~a" p back))))

(test-case "points of the stable one go there"
  (for ([p (invariant-manifold T saddle #:stable? #t #:inverse inverse #:length 6 #:gap 0.3)])
    (define end ((iterated-map T 15) (abscissa p) (ordinate p) make-point void))
    (check-true ((torus-near? 2e-3) end (make-point 0 0)))))

(define crossings
  (homoclinic-points T saddle #:inverse inverse #:branch 1 #:stable-branch -1 #:length 9))

(test-case "homoclinic points go there in both directions"
  (check-true (>= (length crossings) 3))
  (for ([p crossings])
    (for ([map (list T inverse)])
      (check-true
       (for/or ([n 20])
         ((torus-near? 2e-3) ((iterated-map map n) (abscissa p) (ordinate p) make-point void)
                             (make-point 0 0)))))))

;; In the plane of which the torus is rolled up the branches meet a whole turn apart.
(test-case "they are the same whatever the gap, and where angles are not brought back by turns"
  (define (unrolled x y return fail)
    (define next (+ y (* K (sin x))))
    (return (+ x next) next))
  (define (back x y return fail)
    (define before (- x y))
    (return before (- y (* K (sin before)))))
  (define (found map inverse gap)
    (homoclinic-points map (find-fixed-point map (up 0 0)) #:inverse inverse #:branch 1
                       #:stable-branch -1 #:length 9 #:gap gap))
  (for ([others (list (found T inverse 0.03) (found unrolled back 0.05))])
    (check-equal? (length others) (length crossings))
    (for ([p others])
      (check-true (for/or ([q crossings]) ((torus-near? 1e-6) p q))))))

;; The map is (reflection in θ = π after kicks) its own inverse: one crossing is on that line.
(test-case "one of them is on the line of symmetry"
  (check-true (for/or ([p crossings]) (< (abs (- (abscissa p) :pi)) 1e-9))))

(test-case "the image of one is another"
  (define near? (torus-near? 1e-7))
  (define (image p) (T (abscissa p) (ordinate p) make-point void))
  (check-true (for*/or ([p crossings] [q crossings]) (near? (image p) q))))

(test-case "of a motion: the pendulum upside down, whose manifolds tangle"
  (define omega (* 4.2 (sqrt 9.8)))
  (define strobe (driven-pendulum-map 1 1 9.8 0.05 omega))
  (define top (find-fixed-point strobe (up :pi 0)))
  (define tangle
    (homoclinic-points strobe top #:inverse (driven-pendulum-map 1 1 9.8 0.05 (- omega))
                       #:branch 1 #:stable-branch -1 #:length 12 #:gap 0.2))
  (check-true (> (length tangle) 0)))

(define center (find-fixed-point T (up 3 0)))

(says
 [(invariant-manifold T center)
  "invariant-manifold: only hyperbolic points have manifolds; this one is elliptic\n"
  "  (up 3.141592653589793 " (number->string (ordinate (fixed-point-coordinates center))) ")"]
 [(invariant-manifold T saddle #:stable? #t)
  "invariant-manifold: the stable manifold is followed backwards: give the inverse map, #:inverse"]
 [(invariant-manifold T (up 0 0))
  "invariant-manifold: expected a fixed point, as find-fixed-point finds one\n  given: (up 0 0), "
  "an up tuple of 2"]
 [(invariant-manifold T saddle #:branch 2)
  "invariant-manifold: expected one of the branches 1 and -1\n  given: the number 2"]
 [(invariant-manifold T saddle #:length -1)
  "invariant-manifold: expected a positive length\n  given: the number -1"])

(test-case "an inverse that is none is found out"
  (define K (standard-map 1.4))
  (check-exn (regexp (string-append "^homoclinic-points: what was given as #:inverse does not undo "
                                    "the map\n  start: \\(up 0.001 0.002\\)\n  there and back: "))
             (lambda ()
               (homoclinic-points K (find-fixed-point K (up 0 0)) #:inverse (standard-map 1.4)))))

(test-case "whichever way it goes astray"
  (for* ([dx '(-0.1 0 0.1)] [dy '(-0.1 0 0.1)] #:unless (= dx dy 0))
    (define (astray x y return fail)
      (inverse x y (lambda (x y) (return (+ x dx) (+ y dy))) fail))
    (check-exn #rx"#:inverse does not undo the map"
               (lambda () (invariant-manifold T saddle #:stable? #t #:inverse astray)))))
