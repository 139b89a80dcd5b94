#lang racket/base
;; Where an integrand that is being differentiated takes another branch, and how these places
;; move.
;;
;; With ∫ f(x, a) dx from 0 to 1, f = 1 for x < a and 0 elsewhere, ∂f/∂a is 0 wherever it is
;; defined, and the derivative of the integral is 1: Leibniz' rule asks for the jump of f,
;; times dc/da, at each place c(a) where it jumps.  Divided at c, all pieces have smooth
;; integrands, and moving ends; so |x − a| is right to any order, too.
;;
;; Places are found from the choices made at points in between (generic/branches.rkt), by
;; halving; and c as a perturbed value from the number s that is chosen by, which is 0 there,
;;
;;     c ← c − s(c, a)/s',
;;
;; in the arithmetic of perturbed values, where s' from differences will do: repeated often
;; enough, the steps make right what it lacks.

(require "perturbed.rkt"
         "../error/failure.rkt"
         "../generic/arithmetic.rkt" "../generic/branches.rkt")

(provide moving-places)

;; a value that was chosen by, the choice, and the number between two choices
(struct choice (value made between) #:authentic)

;; The places between two numbers where f changes its choices, in order.
(define (moving-places who f low high)
  (define points (points-between low high))
  (define made (map (lambda (x) (choices f x)) points))
  (for/list ([x (in-list points)] [cs (in-list made)]
             [y (in-list (cdr points))] [ds (in-list (cdr made))]
             #:unless (alike? cs ds))
    (place who f x cs y ds)))

(define points-wanted 101)

(define (points-between low high)
  (define (at t)
    (cond [(and (rational? low) (rational? high)) (+ low (* t (- high low)))]
          [(rational? low) (+ low (/ t (- 1.0 t)))]
          [(rational? high) (- high (/ (- 1.0 t) t))]
          [else (/ (- (* 2.0 t) 1.0) (* t (- 1.0 t)))]))
  (for/list ([k (in-range points-wanted)])
    (exact->inexact (at (/ (+ k 0.5127) points-wanted)))))

;; All choices at x, in order; up to where f fails, as |u|' does at 0
(define (choices f x)
  (define made '())
  (define (note! value choice-made between)
    (set! made (cons (choice value choice-made between) made)))
  (with-handlers ([no-value? void])
    (parameterize ([current-branches note!]) (f x)))
  (reverse made))

(define (alike? cs ds) (not (first-difference cs ds)))

;; Which choice differs first, or #f; 0 is no choice of its own.
(define (first-difference cs ds)
  (for/first ([c (in-list cs)] [d (in-list ds)] [k (in-naturals)]
              #:unless (equal? (choice-made c) (choice-made d)))
    k))

(define (place who f x cs y ds)
  (define middle (* 0.5 (+ x y)))
  (cond [(or (<= middle x) (>= middle y)) (moving-root who f x y cs ds)]
        [else
         (define es (choices f middle))
         (if (alike? cs es)
             (place who f middle es y ds)
             (place who f x cs middle es))]))

;; x, y : next to each other
(define (moving-root who f x y cs ds)
  (define k (first-difference cs ds))
  (define (nth choices) (list-ref choices k))
  (define middle ((choice-between (nth cs)) (choice-made (nth cs)) (choice-made (nth ds))))
  (define (s x)
    (let/ec return
      (define left k)
      (define (note! value made between)
        (when (= left 0) (return (g:- value middle)))
        (set! left (- left 1)))
      (parameterize ([current-branches note!]) (f x))
      (raise-unclear who x)))
  (define h (* 1e-6 (+ 1.0 (abs x))))
  (define slope (/ (- (innermost (s (+ x h))) (innermost (s (- x h)))) (* 2.0 h)))
  (when (or (not (rational? slope)) (= slope 0.0)) (raise-unclear who x))
  (for/fold ([c x]) ([_ (in-range newton-steps)]) (g:- c (g:/ (s c) slope))))

(define newton-steps 6)

(define (raise-unclear who x)
  (raise-singular who
                  (string-append "the integral has no derivative found: how the place moves where "
                                 "the integrand takes another branch is not clear")
                  x "at" x))
