#lang racket/base
;; Events along a motion in numbers of higher precision.
;;
;; States within a step are dear, each being the end of a step of its own; so the sign
;; of the event's function is looked at where a cubic guesses them, and only between two
;; places where it differs is its zero found, by the Illinois method, as for flonums
;; (event.rkt).

(require "event.rkt" "precise.rkt"
         "../generic/compare.rkt"
         (only-in "../numeric/flvector.rkt" finite?))

(provide crossings)

(define places '(0 1/8 1/4 3/8 1/2 5/8 3/4 7/8 1))

;; The times in a step at which the event happens, in their order; (complain t state)
;; where its function has no real value.
(define (crossings m s e tolerance complain)
  (define (value t state)
    (define x (comparand ((event-f e) state)))
    (if (finite? x) (inexact->exact x) (complain t state)))
  (define (time theta)
    (exact-time m (+ (stretch-from s) (* theta (- (stretch-to s) (stretch-from s))))))
  (define (at t) (value t (stretch-state m s t)))
  (define (guess theta)
    (if (memv theta '(0 1)) (at (time theta)) (value (time theta) (stretch-guess m s theta))))
  (define (zero a b)
    (define-values (ga gb) (values (at a) (at b)))
    (and (crosses? ga gb (event-direction e))
         (zero-between m at a ga b gb tolerance)))
  (let loop ([a 0] [ga (guess 0)] [places (cdr places)])
    (cond
      [(null? places) '()]
      [else
       (define b (car places))
       (define gb (guess b))
       (define found
         (and (crosses? ga gb (event-direction e))
              (or (zero (time a) (time b))
                  (zero (stretch-from s) (stretch-to s))))) ; the guess was not good enough
       (define more (loop b gb (cdr places)))
       (if found (cons found more) more)])))

;; #f at a pole, where the values grow.
(define (zero-between m g a ga b gb tolerance)
  (define size (max (abs ga) (abs gb)))
  (let loop ([a a] [ga ga] [b b] [gb gb] [count 0])
    (define c (if (= ga gb) b (exact-time m (- b (* gb (/ (- b a) (- gb ga)))))))
    (cond [(or (= gb 0) (= count 100) (<= (abs (- c b)) (* tolerance (+ 1 (abs b)))))
           (and (<= (abs gb) size) c)]
          [else
           (define gc (g c))
           (if (< (* gc gb) 0)
               (loop b gb c gc (+ count 1))
               (loop a (/ ga 2) c gc (+ count 1)))])))
