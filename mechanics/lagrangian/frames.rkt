#lang racket/base
;; Rotations of space, and frames of reference that turn or accelerate
;; (SICM 1.6, p. 48, and 1.8.5, p. 91).
;;
;; A frame is a coordinate transformation for F->C: its coordinates at a time are
;; turned or moved to the coordinates of another frame at that time.

(require "local-tuple.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/elementary.rkt"
         "../generic/function.rkt" "../generic/printed-function.rkt" "../generic/up-down.rkt"
         "../value/structure.rkt")

(provide Rx Ry Rz
         rotating->inertial inertial->rotating
         accelerated->inertial inertial->accelerated)

;; ---------------------------------------------------------------------------
;; Rotations of a tuple (x, y, z) about an axis, from one of the others to the next

(define (Rx angle) (rotation 'Rx angle 1 2))
(define (Ry angle) (rotation 'Ry angle 2 0))
(define (Rz angle) (rotation 'Rz angle 0 1))

;; The rotation by the angle that turns the axis i towards the axis j.
(define (rotation who angle i j)
  (unary-function (call-datum who angle) (q)
    (unless (and (tuple? q) (= (s:length q) 3))
      (raise-wrong-size who "a tuple of 3 coordinates" q))
    (when (local-tuple-of-tuples? q) (raise-local-tuple who angle q))
    (turn q angle i j)))

;; A local tuple has three parts too.
(define (local-tuple-of-tuples? q)
  (ormap tuple? (structure->list q)))

(define (raise-local-tuple who angle q)
  (complain who
            (string-append "expected a tuple of 3 coordinates; given ~a"
                           "\n  of a local tuple: (compose (~a ~a) coordinate)")
            (describe-with-value q) who (value->text angle)))

(define (turn q angle i j)
  (define c (g:cos angle))
  (define s (g:sin angle))
  (define a (ref q i))
  (define b (ref q j))
  (define parts
    (for/vector #:length (s:length q) ([x (in-list (structure->list q))] [k (in-naturals)])
      (cond [(= k i) (g:- (g:* c a) (g:* s b))]
            [(= k j) (g:+ (g:* s a) (g:* c b))]
            [else x])))
  (same-orientation (adopt q) parts))

;; ---------------------------------------------------------------------------
;; Frames

;; From axes that turn at the rate Omega, about z if there is one, to axes that do
;; not and that agree with them at the time 0.
(define (rotating->inertial Omega)
  (rotating-frame 'rotating->inertial Omega Omega))

(define (inertial->rotating Omega)
  (rotating-frame 'inertial->rotating Omega (g:negate Omega)))

(define (rotating-frame who Omega rate)
  (unary-function (call-datum who Omega) (local)
    (define q (coordinate local))
    (unless (and (tuple? q) (memv (s:length q) '(2 3)))
      (raise-wrong-size who "a local tuple with 2 or 3 coordinates" local))
    (turn q (g:* rate (time local)) 0 1)))

;; From a frame with the constant acceleration a, at rest and in place at the time 0.
(define (accelerated->inertial a)
  (accelerated-frame 'accelerated->inertial a 1/2))

(define (inertial->accelerated a)
  (accelerated-frame 'inertial->accelerated a -1/2))

(define (accelerated-frame who a half)
  (unary-function (call-datum who a) (local)
    (g:+ (coordinate local) (g:* half (g:square (time local)) a))))

(define (raise-wrong-size who expected given)
  (complain who "expected ~a; given ~a" expected (describe-with-value given)))
