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

;; What happens within a step, in order, at times; up to where the event's function has no
;; real value.
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
;; it, that is what is found.
(define (zero m s e a b tolerance)
  (let/ec return
    (define (at t)
      (or (value-of e (stretch-state m s t)) (return (crossing t (undefined e) #f))))
    (define-values (ga gb) (values (at a) (at b)))
    (define t
      (and (crosses? ga gb (event-direction e))
           (zero-between m at a ga b gb tolerance)))
    (and t (crossing t e #f))))

;; #f at a pole, where the values grow.
(define (zero-between m g from at-from to at-to tolerance)
  (define size (max (abs at-from) (abs at-to)))
  (let loop ([a from] [ga at-from] [b to] [gb at-to] [count 0])
    (define c (if (= ga gb) b (exact-time m (- b (* gb (/ (- b a) (- gb ga)))))))
    (cond [(= gb 0) (first-zero m g from at-from b tolerance)]
          [(or (= count 100) (<= (abs (- c b)) (* tolerance (+ 1 (abs b)))))
           (and (<= (abs gb) size) c)]
          [else
           (define gc (g c))
           (if (< (* gc gb) 0)
               (loop b gb c gc (+ count 1))
               (loop a (/ ga 2) c gc (+ count 1)))])))

;; g is 0 at b, and perhaps before, as in event/sign-change.rkt.
(define (first-zero m g a ga b tolerance)
  (define near (* tolerance (+ 1 (abs b))))
  (define (before? t) (> (* ga (g t)) 0))
  (if (before? (exact-time m ((if (< a b) - +) b near)))
      b
      (let loop ([a a] [b b])
        (define middle (exact-time m (/ (+ a b) 2)))
        (cond [(<= (abs (- a b)) near) b]
              [(before? middle) (loop middle b)]
              [else (loop a middle)]))))
