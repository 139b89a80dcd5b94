#lang racket/base
;; Poisson brackets (SICM 3.2): {f, g} = ∂₁f ∂₂g − ∂₂f ∂₁g.
;;
;; That is the derivative of f in the direction (0, ∂₂g, −∂₁g) in which g as a Hamiltonian
;; would move the state.  Of functions with structures as values the bracket is the structure
;; of the brackets of their components: like f, of structures like g.

(require "H-state.rkt" "Hamiltonian.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/printed-function.rkt" "../generic/scalar.rkt"
         "../value/structure.rkt")

(provide Poisson-bracket rate-of-quantity)

(define-printed (Poisson-bracket f g)
  (check-bracketed f)
  (check-bracketed g)
  (lambda (state)
    (check-H-state 'Poisson-bracket state)
    (define value (g state))
    (if (scalar? value)
        (bracket-with-scalar f g state)
        (bracket-with-structure f g (f state) value state))))

;; A state may be applied, as any tuple, but is no tuple of functions.
(define (check-bracketed f)
  (check-quantity 'Poisson-bracket f)
  (unless (of-functions? f)
    (complain 'Poisson-bracket
              (string-append "it takes functions of the state, and what it gives the state: "
                             "((Poisson-bracket f g) state); given ~a")
              (describe-with-value f))))

(define (bracket-with-scalar f g state)
  (along f state 0 (((partial 2) g) state) (g:negate (((partial 1) g) state))))

(define (bracket-with-structure f g f-value g-value state)
  (let outer ([f f] [value f-value])
    (if (tuple? value)
        (components f value outer)
        (let inner ([g g] [value g-value])
          (cond [(tuple? value) (components g value inner)]
                [(scalar? value) (bracket-with-scalar f g state)]
                [else (raise-no-scalar g value)])))))

;; The structure of (go component-of-f its-value).
(define (components f value go)
  (s:generate (s:length value) (structure-orientation (adopt value))
              (lambda (i) (go (lambda (state) (s:ref (f state) i)) (s:ref value i)))))

(define (raise-no-scalar g value)
  (complain 'Poisson-bracket "the value of ~a is to be a number or a structure of numbers; it is ~a"
            (value->text g) (describe-with-value value)))

;; The rate of Q where the state moves at the rates ∂₂H and −∂₁H: {Q, H} + ∂₀Q.
(define (rate-of-quantity Q state velocity force) (along Q state 1 velocity force))

(define (along f state rate velocity force)
  (define-values (value slope)
    (value-and-derivative-along f state (up rate velocity force)))
  slope)
