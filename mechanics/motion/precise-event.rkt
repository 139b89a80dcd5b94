#lang racket/base
;; Events along a motion in numbers of higher precision.
;;
;; States within a step are dear, each being the end of a step of its own; so the sign
;; of the event's function is looked at where a cubic guesses them, and only between two
;; places where it differs is its zero found, by the Illinois method, as for flonums
;; (event/sign-change.rkt).

(require "precise-run.rkt"
         "event/event.rkt" "event/sign-change.rkt"
         "../generic/compare.rkt"
         "../numeric/finite-number.rkt")

(provide crossings)

;; Where a step is looked at, after its beginning.
(define places '(1/8 1/4 3/8 1/2 5/8 3/4 7/8 1))

;; -> the crossings within a step, in the order of their times; up to the place where the event's
;; function has no real value
(define (crossings m s e tolerance)
  (define (time theta) (time-within m s theta))
  (let loop ([a 0] [ga (guess m s e 0)] [later places])
    (cond
      [(not ga) (list (crossing (time a) (undefined e) #f))]
      [(null? later) '()]
      [else
       (define b (car later))
       (define gb (guess m s e b))
       (define (rest) (loop b gb (cdr later)))
       (define found
         (and gb
              (crosses? ga gb (event-direction e))
              (or (zero m s e (time a) (time b) tolerance)
                  ;; the guess was not good enough
                  (zero m s e (stretch-from s) (stretch-to s) tolerance))))
       (if found (cons found (rest)) (rest))])))

(define (time-within m s theta)
  (exact-time m (+ (stretch-from s) (* theta (- (stretch-to s) (stretch-from s))))))

(define (guess m s e theta)
  (value-of e (if (memv theta '(0 1))
                  (stretch-state m s (time-within m s theta))
                  (stretch-guess m s theta))))

;; The value of the event's function, exact; #f where it is not real.
(define (value-of e state)
  (define x (comparand ((event-f e) state)))
  (and (finite? x) (inexact->exact x)))

;; The crossing between two times, or #f; where the function has no real value on the way to
;; it, the place of that.
(define (zero m s e a b tolerance)
  (let/ec return
    (define (at t)
      (or (value-of e (stretch-state m s t)) (return (crossing t (undefined e) #f))))
    (define-values (ga gb) (values (at a) (at b)))
    (define near (* tolerance (+ 1 (abs b))))
    (define t
      (and (crosses? ga gb (event-direction e))
           (zero-between at a ga b gb #:near near
                         #:close? (lambda (a b c) (<= (abs (- c b)) near))
                         #:rounded (lambda (t) (exact-time m t)))))
    (and t (crossing t e #f))))
