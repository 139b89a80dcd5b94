#lang racket/base
;; The Lie derivative with respect to H, L F = {F, H}, as an operator (SICM 6.4, p. 448); and with
;; the explicit time, ∂₀F + {F, H}, the rate of F along the motion.
;;
;; Lie series are made of its powers, and brackets of brackets of functions would run
;; H and F anew at each level, twice as often every time.  So F and the rates ∂₂H, −∂₁H are
;; evaluated once, at a state of symbols; each power is then the derivative of one expression in
;; that direction, simplified before the next is taken, and evaluated at the states asked about.
;; Of one that swells when it is simplified, as a power of a sum whose terms are multiplied out,
;; the derivative as it stands is kept: the next would be that of thousands of terms.  Where
;; functions make nothing of symbols, brackets of functions have to do.

(require (only-in racket/vector vector-append)
         "../../algebra/expression/expression.rkt" "../../algebra/expression/flat-graph.rkt"
         "../../calculus/derivative.rkt"
         "../../error/complain.rkt" "../../error/refusal.rkt"
         "../../generic/arithmetic.rkt" "../../generic/describe.rkt" "../../generic/function.rkt"
         "../../generic/on-demand.rkt" "../../generic/printed-function.rkt"
         "../../generic/up-down.rkt"
         "../../hamiltonian/H-state.rkt" "../../hamiltonian/Hamilton-equations.rkt"
         "../../hamiltonian/Hamiltonian.rkt" "../../hamiltonian/Poisson-bracket.rkt"
         "../../value/operator.rkt" "../../value/shape.rkt"
         "../../value/simplify.rkt")

(require-on-demand ["../../calculus/expression-function.rkt" evaluate-at])

(provide Lie-derivative Lie-derivative-procedure flow-derivative
         ;; for values made of it
         on-quantity)

;; F ↦ {F, H}
(define (Lie-derivative H) (derivation-of 'Lie-derivative H 0))

;; The same as a function, which the book makes an operator of (p. 448)
(define-printed (Lie-derivative-procedure H)
  (define who 'Lie-derivative-procedure)
  (check-Hamiltonian who H)
  (lambda (F)
    (check-quantity who F)
    (Poisson-bracket F H)))

;; F ↦ ∂₀F + {F, H}
(define (flow-derivative H) (derivation-of 'flow-derivative H 1))

(define (derivation-of who H rate)
  (check-Hamiltonian who H)
  (define d (derivation who H rate (make-ephemeron-hasheq)))
  (make-primitive-operator (on-quantity who (lambda (F) (image d F 1)))
                           (call-datum who H)
                           #:iterate (lambda (n) (lambda (F) (image d F n)))))

;; act, for a single function of the state; the state itself, in its place or beside it, is refused
(define (on-quantity who act)
  (case-lambda
    [(F)
     (check-quantity who F)
     (unless (ormap procedure? (scalars F))
       (raise-no-quantity who (describe-with-value F)))
     (act F)]
    [Fs (raise-no-quantity who (format "~a arguments" (length Fs)))]))

(define (raise-no-quantity who given)
  (complain who "it takes a function of the state, and what it gives the state: ~a; given ~a"
            "((operator F) state)" given))

;; rate : of the time, 0 or 1;  chains : F ↦ (state ↦ its chain)
(struct derivation (who H rate chains) #:authentic)

;; The function LⁿF
(define (image d F n)
  (check-quantity (derivation-who d) F)
  (unary-function (lambda () (image->datum d F n)) (state)
    (check-H-state (derivation-who d) state)
    (define c (chain-of d F state))
    (if c
        (value-in c n state)
        ((by-brackets d F n) state))))

(define (image->datum d F n)
  (define L (list (derivation-who d) (value->datum (derivation-H d))))
  (list (if (= n 1) L (list 'expt L n)) (value->datum F)))

;; ---------------------------------------------------------------------------
;; Powers at symbols

;; place : a state of symbols; direction : in which it moves, or #f where there is no formula;
;; values : F, LF, L²F, … there, growing
(struct chain (place direction [values #:mutable]) #:authentic)

;; -> the chain of F for states of this shape, or #f where there is no formula
(define (chain-of d F state)
  (define chain-at
    (hash-ref! (derivation-chains d) F
               (lambda ()
                 (by-shape (lambda (state) (new-chain d F state)) #:lasting? (lambda (c) #f)))))
  (define c (chain-at state))
  (and (chain-direction c) c))

(define (new-chain d F state)
  (define place (symbols-like state "z"))
  (define-values (direction value)
    (if-raised raised? (values #f #f)
      (define-values (velocity force)
        ((flow-direction (derivation-who d) (derivation-H d)) place))
      (define value (F place))
      (values (and (formula? value)
                   (up (derivation-rate d)
                       (simplified-unless-swollen velocity)
                       (simplified-unless-swollen force)))
              (simplified-unless-swollen value))))
  (chain place direction (vector value)))

;; Is x made of expressions, so that it can be evaluated elsewhere?
(define (formula? x) (andmap expression? (scalars x)))

;; LⁿF at a state
(define (value-in c n state)
  (evaluate-at (power-in c n) (chain-place c) state))

(define (power-in c n)
  (define known (chain-values c))
  (define end (sub1 (vector-length known)))
  (cond [(<= n end) (vector-ref known n)]
        [else
         (define next (slope c (vector-ref known end)))
         (set-chain-values! c (vector-append known (vector next)))
         (power-in c n)]))

(define (slope c value)
  (define (at state) (evaluate-at value (chain-place c) state))
  (define-values (_value rate) (value-and-derivative-along at (chain-place c) (chain-direction c)))
  (simplified-unless-swollen rate))

;; x with each scalar simplified, unless the simplified form is large and has swollen
(define (simplified-unless-swollen x) (s:map/r smaller-form x))

(define (smaller-form e)
  (define simple (simplify-strictly e))
  (define size (graph-size simple))
  (if (and (> size large) (> size (* swelling (graph-size e)))) e simple))

(define large 500)                      ; nodes of a graph
(define swelling 4)

;; ---------------------------------------------------------------------------
;; Powers as brackets of functions

(define (by-brackets d F n)
  (for/fold ([F F]) ([_ (in-range n)])
    (define slope (Poisson-bracket F (derivation-H d)))
    (if (eqv? (derivation-rate d) 0) slope (g:+ ((partial 0) F) slope))))
