#lang racket/base
;; Invariant circles to rounding, and how fast orbits go around.

(require racket/flonum
         mechanics
         mechanics/book
         mechanics/numeric/Fourier
         mechanics/numeric/periodic-function
         "../support/checks.rkt" "../support/close.rkt" "../support/messages.rkt")

(define golden (- 1 (/ 1 golden-ratio)))

(test-case "Fourier transforms: of two terms, and back"
  (define n 16)
  (define f (for/flvector ([j n]) (fl+ 2.0 (flcos (fl* 3.0 (node-angle j n))))))
  (define-values (re im) (values (flvector-copy f) (make-flvector n)))
  (fourier-transform! re im)
  (check-close re (for/list ([k n]) (case k [(0) 32] [(3 13) 8] [else 0])) 1e-13)
  (inverse-fourier-transform! re im)
  (check-close re f 1e-15))

(define (sampled f [n 64]) (for/flvector ([j n]) (f (node-angle j n))))
(define (bell t) (flexp (flsin t)))

(define (alone both f . more)
  (define-values (g zero) (apply both f (make-flvector (flvector-length f)) more))
  g)

(test-case "periodic functions: slopes, shifts, values between, and sums that come back"
  (check-close (alone both-slopes (sampled bell))
               (sampled (lambda (t) (fl* (flcos t) (bell t)))) 1e-13)
  (check-close (alone both-shifted (sampled bell) 0.7)
               (sampled (lambda (t) (bell (fl+ t 0.7)))) 1e-14)
  (check-close ((periodic-value-at (sampled bell)) 0.1234) (bell 0.1234) 1e-14)
  (define g (periodic-unshifted (sampled bell) 2.4))
  (define m (periodic-mean (sampled bell)))
  (check-close (for/list ([u g] [v (alone both-shifted g 2.4)]) (- u v))
               (for/list ([u (sampled bell)]) (- u m)) 1e-14))

(test-case "the golden curve of K = 0.95, to rounding"
  (define c (invariant-circle (standard-map 0.95) golden))
  (check-true (< (invariant-circle-error c) 1e-14))
  (check-close (invariant-circle-ordinate c 0) 2.1144605494391726 4e-13))

(test-case "the residual is what the map misses its circle by, at other angles as well"
  (define c (invariant-circle (standard-map 0.9) golden))
  (define (miss theta)
    (define there ((standard-map 0.9) (ref (c theta) 0) (ref (c theta) 1) up void))
    (define on (c (+ theta (* :2pi golden))))
    (for/list ([k 2]) (abs ((principal-value :pi) (- (ref there k) (ref on k))))))
  (check-true (< (invariant-circle-error c) 1e-14))
  (for ([j 40])
    (check-true (< (apply max (miss (* 0.157 j))) (+ 3e-14 (invariant-circle-error c))))))

;; A motion is not computed to rounding; more terms do not help then.
(test-case "a circle of a motion, as far as the motion is known"
  (define T (driven-pendulum-map 1 1 9.8 0.002 (* 4.2 (sqrt 9.8))))
  (define c (invariant-circle T 0.2360679774997896 #:from 16.5 #:to 17.0
                              #:most-modes 256))
  (check-true (< (invariant-circle-error c) 1e-9))
  (check-close (rotation-value (rotation-number T (c 0) 1000)) 0.2360679774997896 1e-8))

(test-case "on a circle the map is a rotation, at any angle"
  (define c (invariant-circle (standard-map 0.6) golden))
  (for ([theta '(0.0 1.234 3.0 5.5)])
    (define there ((standard-map 0.6) (ref (c theta) 0) (ref (c theta) 1) up void))
    (check-true ((torus-near? 1e-12) there (c (+ theta (* :2pi golden)))))))

(test-case "without kicks circles are straight"
  (define c (invariant-circle (standard-map 0) golden))
  (check-close (c 1.0) (up 1.0 (* :2pi golden)) 1e-9))

(test-case "of the driven pendulum, a motion: a circle of rotations"
  (define T (driven-pendulum-map 1 1 9.8 0.002 (* 4.2 (sqrt 9.8))))
  (define rotation (rotation-value (rotation-number T (up 0 14) 2000)))
  (check-true (< 0 rotation 1)))

(test-case "circles that have broken up are told"
  (check-exn (lambda (e) (and (exn:fail:mechanics:not-convergent? e)
                              (regexp-match? #rx"it may have broken up" (exn-message e))))
             (lambda () (invariant-circle (standard-map 1.1) golden #:most-modes 256)))
  (check-exn #rx"with so many terms; it may have broken up\n  rotation number: 0.381"
             (lambda () (invariant-circle (standard-map 0.9) golden #:most-modes 8))))

(test-case "of a motion that is chaotic there it is told before long, with the reason"
  (define T (driven-pendulum-map 1 1 9.8 0.1 (* 2 (sqrt 9.8))))
  (define periods 0)
  (define (counted x y return fail)
    (set! periods (+ periods 1))
    (T x y return fail))
  (for ([rotation (list golden (- 1 golden))] [low '(6 2)] [high '(7 6)])
    (check-exn (lambda (e)
                 (and (exn:fail:mechanics:not-convergent? e)
                      (regexp-match? #rx"on no curve,\n  as where the motion is chaotic"
                                     (exn-message e))))
               (lambda () (invariant-circle counted rotation #:from low #:to high))))
  (check-true (< periods 50000) (format "~a periods" periods)))

(test-case "up to which parameter a circle is found: nearer to where it breaks up with more terms"
  (define (limit most)
    (invariant-circle-limit standard-map golden 0.93 1.0 #:tolerance 0.01 #:most-modes most))
  (define-values (few many) (values (limit 512) (limit 2048)))
  (check-true (< (car few) (car many) 0.971635406))
  (check-true (< 0 (- (cadr many) (car many)) 0.01))
  (check-true (invariant-circle? (invariant-circle (standard-map (car many)) golden
                                                   #:most-modes 2048))))

(test-case "rotation numbers of regular orbits"
  (define r (rotation-number (standard-map 0.95) (up 0 2.1144605494391726)))
  (check-true (rotation-regular? r))
  (check-close (rotation-value r) golden 1e-11)
  ;; a rotation
  (check-close (rotation-value (rotation-number (circle-map 0.3) (up 1 2) 1000)) 0.3 1e-12))

(test-case "around a center they tend to the angle of its multipliers"
  (define center (find-fixed-point (standard-map 0.6) (up 3 0)))
  (define r (rotation-number (standard-map 0.6) (up 3.14159 0.0) #:about (up :pi 0)))
  (check-close (abs (rotation-value r)) (/ (fixed-point-rotation-angle center) :2pi) 1e-9)
  (check-close (rotation-value (rotation-number (Henon-map 1.32) (up 1e-4 0) #:about (up 0 0)))
               (/ 1.32 :2pi) 1e-7))

(test-case "of a short regular orbit it is said how many steps would do"
  (define (turning n) (rotation-number (standard-map 0.95) (up 0 2.1144605494391726) n))
  (define short (turning 100))
  (check-true (rotation-regular? short))
  (check-true (> (rotation-steps-needed short) 100))
  (check-regexp-match (regexp (string-append
                               "^rotation number about 0[.][0-9]+: 100 steps are too few to tell it "
                               "better\n  over parts of them it differs by [0-9.e-]+; "
                               (number->string (rotation-steps-needed short)) " steps would do$"))
                      (format "~a" short))
  (define enough (turning (rotation-steps-needed short)))
  (check-equal? (rotation-steps-needed enough) (rotation-steps-needed short))
  (check-true (< (rotation-error enough) 1e-5)))

(test-case "a chaotic orbit is said not to look regular"
  (define r (rotation-number (standard-map 1.4) (up 0.1 0.1)))
  (check-false (rotation-regular? r))
  (check-false (rotation-steps-needed r))
  (check-false (rotation-regular? (rotation-number (standard-map 1.4) (up 0.1 0.1) 200)))
  (check-regexp-match #rx"^rotation number about 0[.]4[0-9]*, if there is one:\n  the orbit does"
                      (format "~a" r)))

(define (limit-of . arguments) (apply invariant-circle-limit arguments))

(says
 [(limit-of standard-map golden 0.5 0.6)
  "invariant-circle-limit: the circle is there at both ends\n"
  "  rotation number: 0.3819660112501052\n  greatest parameter: 0.6"]
 [(limit-of (standard-map 0.5) golden 0.5 0.6)
  "invariant-circle-limit: expected a family of maps, a function of one parameter such as "
  "standard-map\n  given: the procedure `standard-map`, which takes 4 arguments"]
 [(limit-of standard-map 1/3 0.5 1.0)
  "invariant-circle-limit: a circle that is kept has an irrational rotation number; this is 1/3\n"
  "  given: 0.3333333333333333\n"
  "  (periodic-points map 3 region) finds what is left of such a circle"]
 [(limit-of (lambda (k) k) golden 0.5 1.0)
  "invariant-circle-limit: expected a map, a procedure of two coordinates and of two procedures\n"
  "  given: the number 0.5"]
 [(limit-of standard-map golden 'low 0.6)
  "invariant-circle-limit: expected a real number as the parameter\n  given: the symbol low"]
 [(invariant-circle-limit standard-map golden 0.9 1.0 #:tolerance 0)
  "invariant-circle-limit: expected a tolerance, a positive number\n  given: the number 0"]
 [(invariant-circle-modes 3)
  "invariant-circle-modes: expected a circle, as invariant-circle finds one\n"
  "  given: the number 3"])

(define (hole x y return fail) (if (< x 3) (return (+ x 1) y) (fail)))

(says
 [(invariant-circle (standard-map 0.5) golden #:from 'low)
  "invariant-circle: expected a real number\n  given: the symbol low"]
 [(invariant-circle (standard-map 0.5) golden #:from 2.7 #:to 3.0)
  "invariant-circle: the orbits from both ends are ahead of the rotation: no curve is "
  "between them\n  rotation number: 0.3819660112501052\n  actions: 2.7 and 3.0\n"
  "  #:from and #:to say between which ordinates it is, at the abscissa 0"]
 [(rotation-number hole (up 0.5 0))
  "rotation-number: the map has no image of a point that is needed\n  map: hole\n"
  "  point: (up 3.5 0.0)"]
 [(rotation-number (standard-map 0.5) (up 0 0) 3)
  "rotation-number: expected "
  "the length of the orbit, an integer of 100 or more\n  given: the number 3"])

(define (shrinking theta I return fail)
  (define next (+ (* 0.9 I) 0.3 (* 0.5 (sin theta))))
  (return ((principal-value :2pi) (+ theta next)) next))

(test-case "a map that does not keep areas has none: its determinant is told"
  (check-exn (regexp (string-append
                      "^invariant-circle: the map does not keep areas, which invariant circles need"
                      "\n  determinant of its derivatives: 0[.](8999|9).*\n  off by: 0[.](0999|1).*\n"
                      "  at: \\(up 0.1 "))
             (lambda () (invariant-circle shrinking 0.38 #:most-modes 256))))
