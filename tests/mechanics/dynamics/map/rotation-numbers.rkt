#lang racket/base
;; How fast orbits go around, and whether they are regular.

(require racket/stream
         mechanics
         mechanics/book
         "../../support/checks.rkt" "../../support/close.rkt" "../../support/messages.rkt")

(define golden (- 1 (/ 1 golden-ratio)))

(test-case "rotation numbers of regular orbits"
  (define r (rotation-number (standard-map 0.95) (up 0 2.1144605494391726)))
  (check-true (rotation-regular? r))
  (check-close (rotation-value r) golden 1e-11)
  ;; a rotation
  (define rotation (rotation-number (circle-map 0.3) (up 1 2) 1000))
  (check-close (rotation-value rotation) 0.3 1e-12)
  (check-close (rotation-value (rotation-number (circle-map 0.999) (up 1 2) 100)) 0.999 1e-12)
  ;; rounding of a thousand steps
  (check-true (< (* (sqrt 1000) 2e-16) (rotation-error rotation) 1e-12)))

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

(test-case "of the driven pendulum, a motion: a circle of rotations"
  (define T (driven-pendulum-map 1 1 9.8 0.002 (* 4.2 (sqrt 9.8))))
  (define rotation (rotation-value (rotation-number T (up 0 14) 2000)))
  (check-true (< 0 rotation 1)))

(test-case "the place of each point of an orbit among those before it, and where two orders part"
  (define angles '(3 1 2 4 2.5 1.5))
  (check-equal? (stream->list (position-stream :2pi (map list angles angles) '()))
                '(0 0 1 3 2 1))
  (check-equal? (compare-streams '(1 2 3) '(1 2 4) 10) 12)
  (check-equal? (compare-streams '(1 2 4) '(1 2 3) 10) -12))

(define (hole x y return fail) (if (< x 3) (return (+ x 1) y) (fail)))

(says
 [(rotation-number hole (up 0.5 0))
  "rotation-number: the map has no image of a point that is needed\n  map: hole\n"
  "  point: (up 3.5 0.0)"]
 [(rotation-number (standard-map 0.5) (up 0 0) 3)
  "rotation-number: expected "
  "the length of the orbit, an integer of 100 or more\n  given: the number 3"])
