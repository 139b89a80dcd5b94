#lang racket/base
;; 4-tuples of special relativity: intervals between events, boosts and rotations.
;;
;; A 4-tuple (up ct x y z) is a difference of two events: c times the time between them, and the
;; way.  All observers in uniform motion agree on (ct)² − x·x: its root is c times the time that
;; a clock shows which is at both events.  The boost by β = v/c, with γ = 1/√(1 − β²),
;;
;;     ct ↦ γ (ct + β·x)         x ↦ x + γ β ct + γ²/(γ + 1) β (β·x),
;;
;; takes the components for an observer who moves with v to those for one at rest.

(require "../../error/complain.rkt"
         "../../generic/arithmetic.rkt" "../../generic/describe.rkt" "../../generic/elementary.rkt"
         "../../generic/up-down.rkt" "../../generic/wrong-argument.rkt"
         (only-in "../../value/structure.rkt" dot-product))

(provide make-4tuple 4tuple->ct 4tuple->space check-4tuple
         proper-time-interval proper-space-interval
         general-boost general-boost2 extended-rotation add-v/cs
         check-boost)

;; ---------------------------------------------------------------------------
;; 4-tuples

(define (4tuple? x) (up-of-size? x 4))
(define (3tuple? x) (up-of-size? x 3))
(define (up-of-size? x n) (and (up? x) (= (vector-length (tuple-elements x)) n)))

(define (check-4tuple who x)
  (check-argument who 4tuple? x "a 4-tuple (up ct x y z)"))
(define (check-3tuple who x what)
  (check-argument who 3tuple? x (string-append what ", an up tuple of 3")))

(define (make-4tuple ct space)
  (check-3tuple 'make-4tuple space "the way in space")
  (up-of (list->vector (cons ct (vector->list (tuple-elements space))))))

(define (4tuple->ct xi)
  (check-4tuple '4tuple->ct xi)
  (vector-ref (tuple-elements xi) 0))

(define (4tuple->space xi)
  (check-4tuple '4tuple->space xi)
  (apply up (cdr (vector->list (tuple-elements xi)))))

;; ---------------------------------------------------------------------------
;; Intervals

(define (square-of-time xi)
  (define x (4tuple->space xi))
  (g:- (g:square (4tuple->ct xi)) (dot-product x x)))

(define (proper-time-interval xi)
  (check-4tuple 'proper-time-interval xi)
  (root-of 'proper-time-interval (square-of-time xi) xi
           "no clock is at both events: they have a proper-space-interval"))

(define (proper-space-interval xi)
  (check-4tuple 'proper-space-interval xi)
  (root-of 'proper-space-interval (g:negate (square-of-time xi)) xi
           "one clock can be at both events: they have a proper-time-interval"))

(define (root-of who square xi why-not)
  (when (and (real? square) (< square 0))
    (complain who "~a\n  given: ~a" why-not (describe-with-value xi)))
  (g:sqrt square))

;; ---------------------------------------------------------------------------
;; Boosts

(define (general-boost beta)
  (check-3tuple 'general-boost beta "the velocity divided by c")
  (define beta^2 (dot-product beta beta))
  (check-speed 'general-boost beta^2)
  (boost beta beta^2))

;; direction : a unit vector
(define (general-boost2 direction v/c)
  (check-boost 'general-boost2 direction v/c)
  (boost (g:* v/c direction) (g:square v/c)))

(define (boost beta beta^2)
  (define gamma (g:/ 1 (g:sqrt (g:- 1 beta^2))))
  (define along (g:/ (g:square gamma) (g:+ gamma 1)))
  (lambda (xi)
    (define-values (ct x) (values (4tuple->ct xi) (4tuple->space xi)))
    (define beta*x (dot-product beta x))
    (make-4tuple (g:* gamma (g:+ ct beta*x))
                 (g:+ x (g:* (g:+ (g:* gamma ct) (g:* along beta*x)) beta)))))

(define (check-speed who beta^2)
  (when (and (real? beta^2) (>= beta^2 1))
    (complain who "an observer is slower than light: expected v/c less than 1\n  its square is: ~a"
              beta^2)))

(define (check-boost who n v/c)
  (check-3tuple who n "the direction")
  (define length^2 (dot-product n n))
  (when (and (real? length^2) (> (abs (- length^2 1)) 1e-12))
    (complain who "a direction is a unit vector; the square of this one is ~a\n  given: ~a"
              length^2 (describe-with-value n)))
  (check-speed who (g:square v/c)))

;; rotation : a function of up tuples of 3
(define (extended-rotation rotation)
  (check-argument 'extended-rotation procedure? rotation "a rotation, such as (Rx 'theta)")
  (lambda (xi) (make-4tuple (4tuple->ct xi) (rotation (4tuple->space xi)))))

;; The velocity, of one in the same direction that itself moves, divided by c
(define (add-v/cs v1/c v2/c)
  (g:/ (g:+ v1/c v2/c) (g:+ 1 (g:* v1/c v2/c))))
