#lang racket/base
;; Invariant circles to rounding.

(require racket/flonum
         mechanics
         mechanics/book
         mechanics/dynamics/invariant-curve/circle-equation
         mechanics/numeric/Fourier
         mechanics/numeric/periodic-function
         "../../support/checks.rkt" "../../support/close.rkt" "../../support/messages.rkt")

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
(test-case "on a circle the map is a rotation, at any angle"
  (define c (invariant-circle (standard-map 0.6) golden))
  (for ([theta '(0.0 1.234 3.0 5.5)])
    (define there ((standard-map 0.6) (ref (c theta) 0) (ref (c theta) 1) up void))
    (check-true ((torus-near? 1e-12) there (c (+ theta (* :2pi golden)))))))

;; Of the angle θ the map goes on to θ + ω, on the curve x = a cos θ, y = cos θ
(test-case "the curve to begin with is that of an orbit, between whose points it is straight"
  (define-values (a omega) (values 0.1 (* :2pi golden)))
  (define (on-curve x y return fail)
    (define next (+ (- x (* a y)) omega))
    (return (+ next (* a (cos next))) (cos next)))
  (define-values (curve gap) (curve-of-orbit on-curve 0.0 omega))
  (define-values (x y) (curve 50))
  (check-close x (sampled (lambda (t) (fl* a (flcos t))) 50) 1e-7)
  (check-close y (sampled flcos 50) 1e-6)
  (check-true (< 0 gap 1e-3)))

(test-case "an orbit that wanders about lies on no curve"
  (define chaos (standard-map 1.5))
  (check-regexp-match
   (pregexp (string-append
             "^invariant-circle: no invariant circle was found: the orbit that turns most like it "
             "lies on no curve,\n  as where the motion is chaotic; it may have broken up\n"
             "  rotation number: 0.381\\d+\n  start of the orbit: \\(up 0.0 1[.]9\\d+\\)$"))
   (message-of (invariant-circle chaos golden) exn:fail:mechanics?))
  (check-regexp-match
   (pregexp (string-append
             "^invariant-circle-limit: no circle was found at the first of the two parameters, "
             "where it is to be\n  first: 1.5\n  second: 2.0\n"
             "  why: no invariant circle was found: "))
   (message-of (invariant-circle-limit standard-map golden 1.5 2.0) exn:fail:mechanics?)))

;; Actions above ω turn faster by (J − ω)(J − ω + 3/4), which vanishes at ω - 3/4 as well.
(test-case "it is looked for half a radian on either side of the angle by which it turns"
  (define omega (* :2pi golden))
  (define (twist x y return fail)
    (define J (+ y (* 0.05 (sin x))))
    (return ((principal-value :2pi) (+ x omega (* (- J omega) (+ (- J omega) 3/4)))) J))
  (define c (invariant-circle twist golden))
  (check-close (ref (c 1.0) 1) omega 0.2))

(test-case "circles that have broken up are told"
  (define (check-missing K most text)
    (check-exn (lambda (e)
                 (and (exn:fail:mechanics:not-convergent? e)
                      (not (exn:fail:mechanics:not-convergent-value e))
                      (regexp-match? (pregexp text) (exn-message e))))
               (lambda () (invariant-circle (standard-map K) golden #:most-modes most))))
  (check-missing 1.1 256 "it may have broken up")
  (check-missing 0.9 8
                 (string-append "with so many terms; it may have broken up\n  rotation number: "
                                "0.381\\d+\n  residual: [0-9.e-]+\n  terms: \\d+$")))

(test-case "up to which parameter a circle is found: nearer to where it breaks up with more terms"
  (define (limit most)
    (invariant-circle-limit standard-map golden 0.93 1.0 #:tolerance 0.01 #:most-modes most))
  (define-values (few many) (values (limit 512) (limit 2048)))
  (check-true (< (car few) (car many) 0.971635406))
  (check-true (< 0 (- (cadr many) (car many)) 0.01))
  (check-true (invariant-circle? (invariant-circle (standard-map (car many)) golden
                                                   #:most-modes 2048))))

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
 [(invariant-circle-limit standard-map golden 0.5 1.0 #:from 2.7 #:to 3.0)
  "invariant-circle-limit: the orbits from both ends are ahead of the rotation: no curve is "
  "between them\n  rotation number: 0.3819660112501052\n  actions: 2.7 and 3.0\n"
  "  #:from and #:to say between which ordinates it is, at the abscissa 0"]
 [(invariant-circle-modes 3)
  "invariant-circle-modes: expected a circle, as invariant-circle finds one\n"
  "  given: the number 3"])

(says
 [(invariant-circle (standard-map 0.5) golden #:from 'low)
  "invariant-circle: expected a real number\n  given: the symbol low"]
 [(invariant-circle (standard-map 0.5) golden #:from 2.7 #:to 3.0)
  "invariant-circle: the orbits from both ends are ahead of the rotation: no curve is "
  "between them\n  rotation number: 0.3819660112501052\n  actions: 2.7 and 3.0\n"
  "  #:from and #:to say between which ordinates it is, at the abscissa 0"])

;; By the series of x and y at the n angles and in the middle between them
(test-case "whatever Newton's method comes to, the residual is that at the angles and between them"
  (define-values (n omega) (values 64 (* :2pi golden)))
  (define (off u v) (abs ((principal-value :pi) (- u v))))
  (for ([K '(0.5 1.1 1.3)])
    (define map (standard-map K))
    (define-values (x y residual)
      (solve-circle (circle-equation 'test map 1.0 omega)
                    (make-flvector n 0.0) (make-flvector n omega)))
    (define-values (x-at y-at) (values (periodic-value-at x) (periodic-value-at y)))
    (define missed
      (for/fold ([most 0.0]) ([j (* 2 n)])
        (define t (* (exact->inexact j) (/ :pi n)))
        (define there (map (+ t (x-at t)) (y-at t) up void))
        (max most (off (ref there 0) (+ t omega (x-at (+ t omega))))
             (off (ref there 1) (y-at (+ t omega))))))
    (check-= residual missed (+ 1e-12 (* 1e-6 missed)) (format "~a" K))))

(define (with-a-hole x y return fail) (if (< 3 x 3.1) (fail) (return (+ x y) y)))

(test-case "where a curve leads over a hole of the map who asked is told"
  (define equation (circle-equation 'invariant-circle with-a-hole 1.0 2.4))
  (check-regexp-match
   #rx"^invariant-circle: the map has no image of a point that is needed\n  map: with-a-hole\n"
   (message-of (solve-circle equation (make-flvector 128 0.0) (make-flvector 128 1.0)))))

;; It was told as a mistake of flvectors.
(test-case "a curve over a gap, where the map gives no numbers, is no circle"
  (define (with-a-gap x y return fail) (return (+ x y) (if (< 3 x 3.1) +nan.0 y)))
  (define equation (circle-equation 'invariant-circle with-a-gap 1.0 2.4))
  (define-values (x y residual)
    (solve-circle equation (make-flvector 128 0.0) (make-flvector 128 1.0)))
  (check-equal? residual +inf.0))

(define (shrinking theta I return fail)
  (define next (+ (* 0.9 I) 0.3 (* 0.5 (sin theta))))
  (return ((principal-value :2pi) (+ theta next)) next))

(test-case "a map that does not keep areas has none: its determinant is told"
  (check-exn (regexp (string-append
                      "^invariant-circle: the map does not keep areas, which invariant circles need"
                      "\n  determinant of its derivatives: 0[.](8999|9).*\n  off by: 0[.](0999|1).*\n"
                      "  at: \\(up 0.1 "))
             (lambda () (invariant-circle shrinking 0.38 #:most-modes 256))))
