#lang racket/base
;; Inertial frames of special relativity: charts (ct, x, y, z) of observers in uniform motion.
;;
;; A frame moves with v/c in a direction past its ancestor, in whose coordinates its origin is
;; given: its own coordinates, boosted and shifted by the origin, are those of the ancestor.  The
;; first ancestor, a base frame, is at rest.  All frames are charts of one spacetime, R4: a field
;; that is given in one has components in all.

(require "four-tuple.rkt" "../manifold-chart.rkt" "../manifold-point.rkt"
         "../standard-manifolds.rkt"
         "../../error/complain.rkt"
         "../../generic/arithmetic.rkt" "../../generic/describe.rkt" "../../generic/up-down.rkt"
         "../../generic/wrong-argument.rkt")

(provide base-frame-maker the-ether make-SR-frame SR-frame?
         make-SR-coordinates SR-name
         coordinates->event event->coordinates
         boost-direction v/c coordinate-origin)

;; From coordinates in the frame to places, with the data of the frame, #f for a base frame
(struct transport (to-place direction speed origin) #:authentic
  #:property prop:procedure (struct-field-index to-place))

(define (SR-frame? x) (and (coordinate-system? x) (transport? (coordinate-system-to x))))
(define (check-frame who x) (check-argument who SR-frame? x "a frame, such as the-ether"))

;; ---------------------------------------------------------------------------
;; Coordinates that know their frame

(define (make-SR-coordinates frame 4tuple)
  (check-frame 'make-SR-coordinates frame)
  (check-4tuple 'make-SR-coordinates 4tuple)
  (mark-coordinates frame 4tuple))

(define (SR-coordinates? x) (and (chart-of-coordinates x) #t))

;; The name of their frame
(define (SR-name coordinates)
  (check-argument 'SR-name SR-coordinates? coordinates "coordinates that know their frame")
  (value->datum (chart-of-coordinates coordinates)))

;; ---------------------------------------------------------------------------
;; Events, which are points of R4, and their coordinates in a frame

(define (coordinates->event ancestor frame direction v/c origin)
  (define there (general-boost2 direction v/c))
  (lambda (coordinates)
    (check-coordinates frame coordinates)
    ((point ancestor) (make-SR-coordinates ancestor (g:+ (there coordinates) origin)))))

(define (event->coordinates ancestor frame direction v/c origin)
  (define back (general-boost2 (g:negate direction) v/c))
  (lambda (event)
    (make-SR-coordinates frame (back (g:- ((chart ancestor) event) origin)))))

;; ---------------------------------------------------------------------------
;; Frames

;; from-place : place -> coordinates in the frame
(define (make-frame who name to-place from-place)
  (check-argument who symbol? name "the quoted name of a frame")
  (make-coordinate-system name R4 to-place from-place '(ct x y z)))

;; A base frame is its own ancestor, by name.
(define (base-frame-maker name [ancestor name])
  (unless (eq? name ancestor)
    (complain 'base-frame-maker "a base frame has no ancestor but itself\n  given: ~a and ~a"
              (value->text name) (value->text ancestor)))
  (define frame
    (make-frame 'base-frame-maker name (transport unmarked #f #f #f)
                (lambda (place) (make-SR-coordinates frame place))))
  frame)

(define (unmarked x) (up-of (tuple-elements x)))

(define the-ether (base-frame-maker 'the-ether))

;; origin : coordinates in the ancestor of the event at which the frame has ct = x = y = z = 0
(define (make-SR-frame name ancestor direction v/c origin)
  (define who 'make-SR-frame)
  (check-frame who ancestor)
  (check-boost who direction v/c)
  (define start (point-coordinates ((point ancestor) origin)))
  (define (told convert) (convert ancestor frame direction v/c start))
  (define to-place (transport (lambda (x) ((chart R4-rect) ((told coordinates->event) x)))
                              direction v/c start))
  (define (from-place place) ((told event->coordinates) ((point R4-rect) place)))
  (define frame (make-frame who name to-place from-place))
  frame)

(define ((said-of who part) frame)
  (check-frame who frame)
  (or (part (coordinate-system-to frame))
      (complain who "~a is a base frame: it is at rest, and has no ancestor" (value->text frame))))

(define boost-direction (said-of 'boost-direction transport-direction))
(define v/c (said-of 'v/c transport-speed))
(define coordinate-origin (said-of 'coordinate-origin transport-origin))
