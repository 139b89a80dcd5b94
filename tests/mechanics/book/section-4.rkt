#lang racket/base
;; SICM 4.3 to 4.6 (pp. 302-330): manifolds, Poincaré and Birkhoff, invariant curves.

(require mechanics
         mechanics/scmutils
         mechanics/book
         racket/stream
         "../support/checks.rkt" "../support/close.rkt" "../support/messages.rkt")

(define (fail) 'no-image)

;; ---------------------------------------------------------------------------
;; 4.3 Homoclinic tangles

(define T (standard-map 0.6))

(test-case "p. 308: what is multiplied by A along the curve is moved by the map"
  (fixed-point-eigen T 0 0 1e-10
                     (lambda (A dx dy B ex ey)
                       (define curve (unstable-manifold T 0 0 dx dy A 1e-8))
                       (for ([s '(0.01 0.3 2.0 -0.2)])
                         (define p (curve s))
                         (check-true ((torus-near? 1e-6)
                                      (T (abscissa p) (ordinate p) make-point fail)
                                      (curve (* A s))))))))

(test-case "near the fixed point the curve is straight, and it begins there"
  (define curve (unstable-manifold T 0 0 1 2 2.13066238629181 1e-6))
  (check-equal? (curve 0) (make-point 0 0))
  (check-close (curve 1e-7) (up 1e-7 2e-7) 1e-20))

(test-case "the multiplier of a map that turns over is negative, and taken with its sign"
  (define (over x y return fail) (return (* -2.0 x) (* -0.5 y)))
  (define curve (unstable-manifold over 0 0 1 0 -2.0 1e-3))
  (for ([s '(0.5 3.0 -7.0)]) (check-close (curve s) (up s 0) 1e-12)))

(test-case "nearness in the plane, on a cylinder, on a torus"
  (define-values (p q r) (values (make-point 3.14 0.1) (make-point -3.14 0.1)
                                 (make-point -3.14 (+ 0.1 :2pi))))
  (define (near which) (list ((which 0.05) p p) ((which 0.05) p q) ((which 0.05) p r)))
  (check-equal? (near plane-near?) '(#t #f #f))
  (check-equal? (near cylinder-near?) '(#t #t #f))
  (check-equal? (near torus-near?) '(#t #t #t))
  (check-true ((plane-near? 0.1) (cons 1 2) (make-point 1.05 2))))

;; ---------------------------------------------------------------------------
;; 4.5 The Poincaré-Birkhoff theorem

;; In K = 0 the action 2 pi/3 turns thrice to where it was.
(test-case "p. 321: a point that is mapped radially"
  (define thrice (iterated-map (standard-map 0.3) 3))
  (for ([phi '(0.5 1.0 2.0)])
    (define J (radially-mapping-points thrice 1.8 2.4 phi 1e-13))
    (check-close ((principal-value :pi) (- (car (thrice phi J list fail)) phi)) 0 1e-11))
  (check-close (radially-mapping-points (iterated-map (standard-map 0) 3) 1.8 2.3 1.0 1e-14)
               (/ :2pi 3) 1e-13))

(test-case "the rotor of the text: the fixed points of the sixth iterate are on both curves"
  (define rotor (driven-pendulum-map 1 1 0 0.1 (* 4.2 (sqrt 9.8))))
  (define six (iterated-map rotor 6))
  (define (moved phi)
    (define J (radially-mapping-points six 1.7 2.9 phi 1e-10))
    (- (cadr (six phi J list fail)) J))
  ;; the curve and its image cross between angles where the shift has different signs
  (define signs (for/list ([k (in-range 24)]) (> (moved (+ 0.05 (* k (/ :2pi 24)))) 0)))
  (define changes
    (for/sum ([a signs] [b (append (cdr signs) (list (car signs)))]) (if (eq? a b) 0 1)))
  (check-true (and (even? changes) (>= changes 2)) (format "~a" changes)))

;; ---------------------------------------------------------------------------
;; 4.6 Invariant curves

(define golden (- 1 (/ 1 golden-ratio)))

(test-case "p. 326: the golden curve of K = 0.95"
  (check-close (find-invariant-curve (standard-map 0.95) golden 0 2.0 2.2 1e-5) 2.1144605 3e-6)
  (check-close (find-invariant-curve (standard-map 0.95) golden 0 2.0 2.2 1e-11)
               2.1144605494391726 3e-11))

(test-case "p. 327: an orbit with a greater action is ahead, with a lesser one behind"
  (define (way J) (which-way? golden 0 J (standard-map 0.95)))
  (check-equal? (map way '(2.0 2.1144605 2.11446055 2.2)) '(-1 -1 1 1))
  (check-equal? (which-way? 1/4 0 (/ :2pi 4) (standard-map 0) 1000) 0))

(test-case "streams of positions say the same, and after how many points"
  (define (positions T J) (position-stream :2pi (orbit-stream T 0.0 J) '()))
  (define (compared J)
    (compare-streams (positions (circle-map golden) J) (positions (standard-map 0.95) J) 0))
  (for ([J '(2.0 2.1 2.11 2.12 2.2)])
    (check-equal? (positive? (compared J))
                  (negative? (which-way? golden 0.0 J (standard-map 0.95)))))
  (check-true (> (abs (compared 2.1145)) (abs (compared 2.12)) (abs (compared 2.2)) 1)))

(test-case "an orbit as a stream, which ends where there is no image"
  (define (down x y return fail) (if (> y 0) (return x (- y 1)) (fail)))
  (check-equal? (stream->list (orbit-stream down 'a 2)) '((a 2) (a 1) (a 0)))
  (check-equal? (stream->list (position-stream :2pi (list '(3 0) '(1 0) '(2 0) '(4 0)) '()))
                '(0 0 1 3))
  (check-equal? (compare-streams '(1 2 3) '(1 2 3) 0) 0)
  (check-equal? ((circle-map 1/4) 0 'J list fail) (list (/ :2pi 4) 'J)))

;; ---------------------------------------------------------------------------

(define (hole x y return fail) (fail))

(says
 [(find-invariant-curve (standard-map 0.95) golden 0 2.2 2.4 1e-5)
  "find-invariant-curve: the orbits from both ends are ahead of the rotation: no curve is "
  "between them\n  rotation number: 0.3819660112501052\n  actions: 2.2 and 2.4"]
 [(which-way? 0.3 1 2 hole)
  "which-way?: the map has no image of a point that is needed\n  map: hole\n"
  "  point: (up 1.0 2.0)"]
 [(unstable-manifold T 0 0 1 1 0.47 1e-8)
  "unstable-manifold: the multiplier of an unstable direction is greater than 1 in size; "
  "given the number 0.47\n"
  "  a stable manifold is the unstable one of the inverse map, with 1/A"]
 [(abscissa '(1 2))
  "abscissa: expected a point of the plane, such as (make-point x y)\n  given: (1 2), a list"]
 [(plane-near? -1)
  "plane-near?: expected a distance, a positive number\n  given: the number -1"]
 [(radially-mapping-points (standard-map 0) 0.1 0.2 1.0 1e-8)
  "radially-mapping-points: the map turns the angle the same way at both actions; one between "
  "them need not keep it\n  angle: 1.0\n  at the action 0.1 it turns by 0.10000000000000009\n"
  "  at the action 0.2 it turns by 0.19999999999999996"]
 [(fixed-point-eigen T 0 0 1e-8 (lambda (x) x))
  "fixed-point-eigen: expected a procedure of two multipliers, each with a direction: "
  "(lambda (A dx dy B dx dy) ...)\n  given: a function without a name"]
 [(compare-streams 1 '() 0)
  "compare-streams: expected a stream, as orbit-stream makes one\n  given: the number 1"])

(test-case "numbers as scmutils has them"
  (check-close golden-ratio (/ (+ 1 (sqrt 5)) 2) 1e-15)
  (check-equal? :phi golden-ratio)
  (check-equal? (+ 1.0 (/ *machine-epsilon* 2)) 1.0)
  (check-true (> (+ 1.0 *machine-epsilon*) 1.0))
  (check-equal? (map floor->exact '(2.7 -2.7 3)) '(2 -3 3))
  (check-equal? (list (close-enuf? 1 1.000001 1e-5) (close-enuf? 1 1.1 1e-5)) '(#t #f)))
