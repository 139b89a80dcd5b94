#lang racket/base
;; The Lie derivative with respect to H, L F = {F, H}, as an operator (SICM 6.4, p. 448); and with
;; the explicit time, ∂₀F + {F, H}, the rate of F along the motion.
;;
;; Powers of it are what Lie series are made of, and brackets of brackets of functions would run
;; H and F anew at each level, twice as often every time.  So F and the rates ∂₂H, −∂₁H are
;; evaluated once, at a state of symbols; each power is then the derivative of one expression in
;; that direction, simplified before the next is taken, and evaluated at the states asked about.
;; Of one that swells when it is simplified, as a power of a sum whose terms are multiplied out,
;; the derivative as it stands is kept: the next would be that of thousands of terms.  Where
;; functions make nothing of symbols, brackets of functions have to do.

(require "../../algebra/expression/expression.rkt" "../../algebra/expression/flat-graph.rkt"
         "../../calculus/derivative.rkt"
         "../../error/complain.rkt" "../../error/refusal.rkt"
         "../../generic/arithmetic.rkt" "../../generic/describe.rkt" "../../generic/function.rkt"
         "../../generic/on-demand.rkt" "../../generic/up-down.rkt"
         "../../hamiltonian/H-state.rkt" "../../hamiltonian/Hamilton-equations.rkt"
         "../../hamiltonian/Hamiltonian.rkt" "../../hamiltonian/Poisson-bracket.rkt"
         "../../value/assumptions.rkt" "../../value/operator.rkt" "../../value/shape.rkt"
         "../../value/simplify.rkt" "../../value/symbols-like.rkt")

(require-on-demand ["../../calculus/expression-function.rkt" evaluate-generically])

(provide Lie-derivative Lie-derivative-procedure flow-derivative
         ;; for what is made of it
         on-quantity graph-size)

;; F ↦ {F, H}
(define (Lie-derivative H) (derivation-of 'Lie-derivative H 0))

;; The same as a function, which the book makes an operator of (p. 448)
(define (Lie-derivative-procedure H)
  (define who 'Lie-derivative-procedure)
  (check-Hamiltonian who H)
  (unary-function (lambda () (list who (value->datum H))) (F)
    (check-quantity who F)
    (Poisson-bracket F H)))

;; F ↦ ∂₀F + {F, H}
(define (flow-derivative H) (derivation-of 'flow-derivative H 1))

(define (derivation-of who H rate)
  (check-Hamiltonian who H)
  (define d (derivation who H rate (make-weak-hasheq)))
  (make-primitive-operator (on-quantity who (lambda (F) (image d F 1)))
                           (lambda () (list who (value->datum H)))
                           #:iterate (lambda (n) (lambda (F) (image d F n)))))

;; act, for a single function of the state; given the state as well, or in its place, it says so
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

;; rate : of the time, 0 or 1;  chains : F ↦ its powers at symbols
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
;; values : F, LF, L²F, … there, growing;  declared : the assumptions they were simplified under
(struct chain (place direction [values #:mutable] declared) #:authentic)

;; -> chain for states of that shape and what is assumed now, or #f
(define (chain-of d F state)
  (define known (hash-ref (derivation-chains d) F #f))
  (define c
    (if (and known
             (same-shape? state (chain-place known))
             (equal? (assumptions 'declared) (chain-declared known)))
        known
        (let ([c (new-chain d F state)])
          (hash-set! (derivation-chains d) F c)
          c)))
  (and (chain-direction c) c))

(define (new-chain d F state)
  (define place (symbols-like state "z"))
  (define-values (direction value)
    (with-handlers ([raised? (lambda (e) (values #f #f))])
      (define-values (velocity force)
        ((flow-direction (derivation-who d) (derivation-H d)) place))
      (define value (F place))
      (values (and (formula? value)
                   (up (derivation-rate d)
                       (simplified-unless-swollen velocity)
                       (simplified-unless-swollen force)))
              (simplified-unless-swollen value))))
  (chain place direction (vector value) (assumptions 'declared)))

;; Is it made of numbers and expressions, so that it can be evaluated elsewhere?
(define (formula? x)
  (for/and ([leaf (in-list (scalars x))]) (or (number? leaf) (expression? leaf))))

;; LⁿF at a state
(define (value-in c n state)
  (define formula (power-in c n))
  (define point (map cons (scalars (chain-place c)) (scalars state)))
  (define xs (list->vector (scalars formula)))
  (scalars->structure formula (lambda (k) (evaluate-generically (vector-ref xs k) point))))

(define (power-in c n)
  (define known (chain-values c))
  (define last (sub1 (vector-length known)))
  (cond [(<= n last) (vector-ref known n)]
        [else
         (define next (slope c (vector-ref known last)))
         (set-chain-values! c (list->vector (append (vector->list known) (list next))))
         (power-in c n)]))

(define (slope c value)
  (define names (scalars (chain-place c)))
  (define xs (list->vector (scalars value)))
  (define (at state)
    (define point (map cons names (scalars state)))
    (scalars->structure value (lambda (k) (evaluate-generically (vector-ref xs k) point))))
  (define-values (_value rate) (value-and-derivative-along at (chain-place c) (chain-direction c)))
  (simplified-unless-swollen rate))

;; The smaller of a scalar and its simplified form, where that is large; of structures each
(define (simplified-unless-swollen x)
  (define xs (list->vector (scalars x)))
  (scalars->structure x (lambda (k) (smaller-form (vector-ref xs k)))))

(define (smaller-form e)
  (define simple (simplify-strictly e))
  (define size (graph-size simple))
  (if (and (> size large) (> size (* swelling (graph-size e)))) e simple))

(define large 500)                      ; nodes of a graph
(define swelling 4)

(define (graph-size e) (if (node? e) (tape-length (expression->plain-tape e)) 1))

;; ---------------------------------------------------------------------------
;; Powers as brackets of functions

(define (by-brackets d F n)
  (define bracketed
    (for/fold ([F F]) ([_ (in-range n)])
      (define slope (Poisson-bracket F (derivation-H d)))
      (if (eqv? (derivation-rate d) 0) slope (g:+ ((partial 0) F) slope))))
  bracketed)
