#lang racket/base
;; The phase portrait beside a mechanism shows one function of the state against another.

(require "drawn-state.rkt"
         "../../error/complain.rkt"
         "../../generic/describe.rkt" "../../generic/up-down.rkt"
         "../../generic/value-struct.rkt" "../../generic/wrong-argument.rkt"
         "../../lagrangian/local-tuple.rkt"
         "../plot/plotted-number.rkt")

(provide phase-plane phase-plane? phase-plane-x-label phase-plane-y-label
         plane-of-coordinate plane-point-at)

;; x, y : state -> number
(value-struct phase-plane (x y x-label y-label)
  #:datum (lambda (p)
            `(phase-plane ,(procedure-datum (phase-plane-x p))
                          ,(procedure-datum (phase-plane-y p))))
  #:constructor-name new-phase-plane
  #:omit-define-syntaxes)

(define (phase-plane x y #:x-label [x-label "x"] #:y-label [y-label "y"])
  (for ([f (in-list (list x y))]) (check-function-of-state 'phase-plane f))
  (for ([text (in-list (list x-label y-label))])
    (check-argument 'phase-plane string? text "a string as label"))
  (new-phase-plane x y x-label y-label))

;; Coordinate i against its velocity, or its momentum if the state has momenta.
;; names : of the coordinates, as far as they are known; first : the state at the start
(define (plane-of-coordinate who i names first)
  (check-planar who first)
  (define count (vector-length (slot-components who first 1)))
  (unless (and (exact-nonnegative-integer? i) (< i count))
    (complain-showing who "there is no coordinate of that number"
                      "number" i
                      "coordinates" count))
  (define name (if (< i (length names)) (list-ref names i) (format "q_~a" i)))
  (define ((component slot) state) (vector-ref (slot-components who state slot) i))
  (new-phase-plane (component 1) (component 2) name
                   (if (momenta? first) (format "p(~a)" name) (format "d~a/dt" name))))

(define (check-planar who state)
  (unless (and (local-tuple? state) (>= (structure-length (adopt state)) 3))
    (complain-showing
     who "a phase portrait of states without velocities or momenta needs a (phase-plane x y)"
     "state" state)))

(define (momenta? state)
  (define v (vector-ref (tuple-elements (adopt state)) 2))
  (and (tuple? v) (down? v)))

;; -> a vector of two flonums
(define (plane-point-at p who state)
  (define (number f axis)
    (coordinate-of who (lambda () (format "the ~a of the phase portrait" axis)) (f state)))
  (vector (number (phase-plane-x p) "abscissa") (number (phase-plane-y p) "ordinate")))
