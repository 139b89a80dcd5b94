#lang racket/base
;; Bounds on the growth of fractions, counted in terms, never in time.
;;
;; All arithmetic is charged to a meter as it happens (polynomial/work-budget.rkt), and
;; presentation, which looks at terms again and again, in the end.  A step that
;; would take more than a bound is an obstacle: the expression is left
;; unexpanded there.  The bounds are far above the needs of mechanics, and low
;; enough for a session to go on: a full tank lasts about a second.  When it is
;; empty only small steps are made.

(require "../polynomial/fraction.rkt" "../polynomial/polynomial.rkt")

(provide obstacle? raise-obstacle
         make-fuel fuel-meter fuel-empty? call-nested
         begin-step! end-steps! within-a-step check-expansion check-sum
         spend-on-terms! spend-on-nodes! readable?)

(struct obstacle ())
(define (raise-obstacle) (raise (obstacle)))

;; nested? : is this the argument of a kernel?
(struct fuel (meter [nested? #:mutable]) #:authentic)

(define (make-fuel [amount 5000000]) (fuel (make-meter amount) #f))

(define (fuel-empty? tank) (<= (meter-left (fuel-meter tank)) 0))

;; The thunk's value, found within the closer bounds of a kernel's argument.
(define (call-nested tank thunk)
  (define outer (fuel-nested? tank))
  (set-fuel-nested?! tank #t)
  (begin0 (thunk)
          (set-fuel-nested?! tank outer)))

;; Limits of a step's cost and of the terms in a sum: outside; in an argument; and
;; when the tank is empty.
(struct limits (step sum) #:authentic)
(define outer-limits (limits 1000000 200000))
(define inner-limits (limits 20000 100))
(define small-limits (limits 1000 30))

(define (current-limits tank)
  (cond [(fuel-empty? tank) small-limits]
        [(fuel-nested? tank) inner-limits]
        [else outer-limits]))

;; Begins a step, which ends where the next one begins.
(define (begin-step! tank)
  (meter-allow! (fuel-meter tank) (limits-step (current-limits tank))))

(define (end-steps! tank) (meter-allow-all! (fuel-meter tank)))

;; The value of (thunk), or #f if it would cost more than a step of an argument may.
(define (within-a-step tank thunk)
  (meter-allow! (fuel-meter tank) (limits-step inner-limits))
  (begin0 (with-handlers ([overspent? (lambda (x) #f)]) (thunk))
          (end-steps! tank)))

;; How much dearer than arithmetic are presentation and the finding of kernels.
(define presentation-factor 1000)
(define finding-factor 20)

(define (spend-on-terms! tank n)
  (meter-charge! (fuel-meter tank) (* presentation-factor n)))

(define (spend-on-nodes! tank n)
  (meter-charge! (fuel-meter tank) (* finding-factor n)))

;; A sum of more terms than these is no longer read by anyone.
(define readable-terms 3000)

(define (readable? f) (<= (numerator-size f) readable-terms))

;; Foreseen, since the product with the last factor costs most:
;; (a₁ + ... + aₙ)^k has (n + k - 1 choose k) terms.
(define (check-expansion tank f k)
  (define n (numerator-size f))
  (define bound (limits-step (current-limits tank)))
  (let loop ([i 1] [terms 1])
    (cond [(> (* terms n) bound) (raise-obstacle)]
          [(and (< i k) (> n 1)) (loop (+ i 1) (/ (* terms (+ n i -1)) i))]
          [else (void)])))

(define (check-sum tank fs)
  (define terms (apply + (map numerator-size fs)))
  (when (> terms (limits-sum (current-limits tank))) (raise-obstacle))
  (meter-charge! (fuel-meter tank) terms))

(define (numerator-size f) (poly-term-count (fraction-numerator f)))
