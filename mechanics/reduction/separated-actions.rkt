#lang racket/base
;; Actions and frequencies of motions that separate, in numbers (SICM 6.1).
;;
;; Each pᵢ(qⁱ) = m ± √R with R of the coordinate and the constants: between two zeros of R the
;; coordinate swings, and
;;
;;     Jᵢ = 1/2π ∮ pᵢ dqⁱ = 1/π ∫ √R dq,     ∂Jᵢ/∂α = 1/π ∫ (∂R/∂α)/(2 √R) dq.
;;
;; With q in the middle plus half the width times sin u both integrands are smooth and even about
;; the ends: the sum of their values at evenly spaced u converges with all powers of the spacing,
;; and no value at a zero of R is asked for.
;;
;; A coordinate that does not occur in H is an angle of 2π: its action is its momentum.
;; The frequencies are ∂E/∂Jᵢ, the row of the energy in the inverse of ∂J/∂α.

(require racket/list
         "ends-of-swing.rkt" "momentum-by-energy.rkt" "separation.rkt" "split.rkt"
         "../algebra/expression/symbols.rkt"
         "../calculus/expression-function.rkt"
         (only-in "../canonical/closed-form.rkt" derivative-of)
         "../error/complain.rkt" "../error/failure.rkt"
         "../generic/describe.rkt"
         "../generic/up-down.rkt"
         "../hamiltonian/H-state.rkt"
         "../lagrangian/local-tuple.rkt"
         "../numeric/constants.rkt"
         "../value/shape.rkt" "../value/simplify.rkt"
         "../value/linear/linear-algebra.rkt" "../value/linear/matrix.rkt")

(provide separation-actions separation-frequencies)

;; ---------------------------------------------------------------------------
;; For users

;; Of the motion through a state of numbers, of the shape of the coordinates
(define (separation-actions s state)
  (define who 'separation-actions)
  (define point (constants-at who s state))
  (like-coordinates s (lambda (x) (action who s x point state))))

(define (separation-frequencies s state)
  (define who 'separation-frequencies)
  (define point (constants-at who s state))
  (define constants (separation-constants s))
  (define slopes
    (for/list ([x (in-list (by-coordinate s))])
      (for/list ([c (in-list constants)]) (action-slope who s x c point state))))
  (define by-energy
    (solve-linear-left (transpose (apply matrix-by-rows slopes))
                       (apply up 1.0 (map (lambda (_) 0.0) (cdr constants)))))
  (define values (scalars by-energy))
  (scalars->structure (coordinate (separation-state s)) (lambda (k) (list-ref values k))))

(define (by-coordinate s)
  (for/list ([q (in-list (scalars (coordinate (separation-state s))))])
    (findf (lambda (x) (eq? (piece-q x) q)) (separation-pieces s))))

(define (like-coordinates s f)
  (define values (map f (by-coordinate s)))
  (scalars->structure (coordinate (separation-state s)) (lambda (k) (list-ref values k))))

;; -> ((constant . number) …)
(define (constants-at who s state)
  (check-H-state who state)
  (unless (andmap real? (scalars state))
    (complain who "expected a state in numbers; given ~a" (value->text state)))
  (unless (same-shape? state (separation-state s))
    (complain who "expected a state like ~a; given ~a" (value->text (separation-state s))
              (value->text state)))
  (check-swings who s)
  (for/list ([c (in-list (separation-constants s))] [f (in-list (separation-integrals s))])
    (define v (f state))
    (unless (real? v)
      (complain who "the parameters of ~a are to be numbers; there is ~a"
                (value->text (separation-H s)) (first (symbols-in v))))
    (cons c (exact->inexact v))))

;; Of one energy all would be that of it, whatever the state; and what is linear in its momentum
;; never turns.
(define (check-swings who s)
  (unless (symbol? (separation-energy s))
    (complain who (string-append "the separation is that of one energy, ~a; actions belong to one "
                                 "with a symbol for it, as E")
              (value->text (separation-energy s))))
  (for ([x (in-list (separation-pieces s))] #:unless (piece-cyclic? x))
    (when (eqv? 1 (degree-of x))
      (raise-no-answer who (string-append "the coordinate ~a does not turn back: its momentum is "
                                          "a function of it
  ~a = ~a")
                       (piece-q x) (piece-p x) (value->text (momentum-of x))))))

;; ---------------------------------------------------------------------------
;; One coordinate

(define (action who s x point state)
  (cond [(piece-cyclic? x) (cdr (assq (piece-constant x) point))]
        [else (between-turns who s x point state (lambda (R q) (sqrt (max 0.0 (R q)))))]))

(define (action-slope who s x c point state)
  (cond [(piece-cyclic? x) (if (eq? c (piece-constant x)) 1.0 0.0)]
        [else
         (define dR (number-function (derivative-of (radicand-expression x) c) x point))
         (check-swinging who s x point state)
         (between-turns who s x point state
                        (lambda (R q)
                          (define r (R q))
                          (if (> r 0.0) (/ (dR q) (* 2.0 (sqrt r))) 0.0)))]))

;; 1/π of the integral of (f R q) over the swing
(define (between-turns who s x point state f)
  (define R (number-function (radicand-expression x) x point))
  (define-values (low high) (turning-points who s x point state))
  (define-values (middle half) (values (* 1/2 (+ low high)) (* 1/2 (- high low))))
  (define (integrand u) (* (f R (+ middle (* half (sin u)))) half (cos u)))
  (average-over-half-turn who x integrand))

(define fewest 16)
(define most 8192)
(define closeness 1e-12)

;; (1/π) ∫ f du from −π/2 to π/2, by ever more points between the ends
(define (average-over-half-turn who x f)
  (define (average n)
    (for/fold ([sum 0.0] #:result (/ sum n)) ([k (in-range n)])
      (+ sum (f (* pi (- (/ (+ k 0.5) n) 0.5))))))
  (let double ([n fewest] [before +inf.0])
    (define value (average n))
    (define error (abs (- value before)))
    (cond [(<= error (* closeness (abs value))) value]
          [(>= n most)
           (raise-not-convergent who (format "the integral over the swing of ~a did not converge"
                                             (piece-q x))
                                 value error)]
          [else (double (* 2 n) value)])))

;; At rest a coordinate has an action, 0, but no slopes of it.
(define (check-swinging who s x point state)
  (define start (start-of s x state))
  (define-values (low high) (turning-points who s x point state))
  (unless (> (- high low) (* 1e-7 (+ 1.0 (abs start))))
    (complain who "the coordinate ~a rests at ~a: its frequency is that of a small swing about it"
              (piece-q x) start)))

;; R in p = m ± √R, an expression
(define (radicand-expression x)
  (define (f p) (evaluate-generically (piece-equation x) (list (cons (piece-p x) p))))
  (define-values (_middle R) (middle-and-radicand f 0))
  (simplify R))

(define ((number-function e x point) q)
  (define v (evaluate-generically e (cons (cons (piece-q x) q) point)))
  (if (real? v) (exact->inexact v) +nan.0))

(define (start-of s x state)
  (for/first ([q (in-list (scalars (coordinate (separation-state s))))]
              [value (in-list (scalars (coordinate state)))]
              #:when (eq? q (piece-q x)))
    (exact->inexact value)))

;; ---------------------------------------------------------------------------
;; Turning points

(define (turning-points who s x point state)
  (define r (radicand-of x point))
  (define start (start-of s x state))
  (define (turn direction)
    (or (turning-point r start direction) (raise-no-turn who x start)))
  (values (turn -1.0) (turn 1.0)))

(define (radicand-of x point)
  (define e (radicand-expression x))
  (define D (denominator-of e))
  (define (number-at e) (number-function e x point))
  (define (slope e) (number-at (derivative-of e (piece-q x))))
  (radicand (number-at e) (slope e) (number-at D) (slope D)))

(define (raise-no-turn who x start)
  (raise-no-answer who "the coordinate ~a does not turn back: its motion from ~a has no action"
                   (piece-q x) start))
