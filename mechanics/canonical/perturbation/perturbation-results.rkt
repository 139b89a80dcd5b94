#lang racket/base
;; The results of perturbation theory: the new Hamiltonian, the generators, the divisors and the
;; resonances that stayed.
;;
;; They are kept as Poisson series in the symbols of a state; functions of any state are made of
;; them by substitution.

(require racket/list
         "../../algebra/expression/flat-graph.rkt"
         "homological.rkt" "Poisson-series.rkt" "symbols-for-decimals.rkt"
         "../../calculus/expression-function.rkt"
         "../../generic/arithmetic.rkt" "../../generic/describe.rkt"
         "../../generic/elementary.rkt"
         "../../generic/function.rkt"
         "../../generic/value-struct.rkt" "../../generic/wrong-argument.rkt"
         "../../hamiltonian/H-state.rkt"
         "../../lagrangian/local-tuple.rkt"
         "../../value/shape.rkt" "../../value/simplify.rkt"
         "../../value/series/series-access.rkt")

(provide perturbation? perturbation-Hamiltonian perturbation-generators
         perturbation-divisors perturbation-resonances
         ;; for the theory, motions and verdicts
         (struct-out perturbation) check-perturbation actions-of angles-of term-function
         series->formula for-all-decimals)

;; state : of symbols; given : functions H₀, H₁, …; terms, Ws : Poisson series, of H' and
;; the Wₙ; removals : for each order the list of waves removed; decimals : the symbols that
;; stand for decimals in terms, Ws and removals, and these (symbols-for-decimals.rkt)
(value-struct perturbation (state given parameter terms Ws removals decimals)
  #:text perturbation->text)

(define (angles-of P) (scalars (coordinate (perturbation-state P))))
(define (actions-of P) (scalars (momentum (perturbation-state P))))

(define (check-perturbation who P)
  (check-argument who perturbation? P "what perturbation-series gives"))

;; ---------------------------------------------------------------------------
;; The results

;; A Poisson series as an expression, with the decimals put back
(define (series->formula P s)
  (in-numbers P (simplify-strictly (series->expression s (angles-of P)))))

;; An expression with the decimals put back.  Its factors are multiplied where it is no long sum,
;; of which decimals would become integers of a hundred digits.
(define (in-numbers P e)
  (define decimals (perturbation-decimals P))
  (define numbers (with-decimals-back e decimals))
  (if (or (null? decimals) (> (graph-size numbers) short)) numbers (simplify-strictly numbers)))

(define short 40)                       ; nodes of a graph

;; P with the names of its decimals left in their place, so that claims proved of it hold for
;; all numbers there
(define (for-all-decimals P)
  (define-values (state decimals) (values (perturbation-state P) (perturbation-decimals P)))
  (define (general H)
    (define e (with-decimals-named (H state) decimals))
    (lambda (at) (evaluate-at e state at)))
  (struct-copy perturbation P [given (map general (perturbation-given P))] [decimals '()]))

;; The function of the state that a Poisson series is.
(define (term-function P s)
  (define state (perturbation-state P))
  (define e (series->formula P s))
  (unary-function (lambda () (value->datum e)) (at)
    (check-state-like 'perturbation-series state at)
    (evaluate-at e state at)))

;; The series of functions H'₀ + ε H'₁ + ⋯ of the new state
(define (perturbation-Hamiltonian P)
  (check-perturbation 'perturbation-Hamiltonian P)
  (apply series
         (for/list ([s (in-list (perturbation-terms P))] [n (in-naturals)])
           (g:* (g:expt (perturbation-parameter P) n) (term-function P s)))))

;; The list of W₁, W₂, …, functions of the state
(define (perturbation-generators P)
  (check-perturbation 'perturbation-generators P)
  (for/list ([W (in-list (perturbation-Ws P))]) (term-function P W)))

;; ((order integers divisor) …) of all waves that were removed
(define (perturbation-divisors P)
  (check-perturbation 'perturbation-divisors P)
  (for*/list ([(gone n) (in-parallel (perturbation-removals P) (in-naturals 1))]
              [r (in-list gone)])
    (list n (removed-numbers r) (in-numbers P (removed-divisor r)))))

;; ((order integers term) …) of the waves that stayed, of which the integers are not all zero
(define (perturbation-resonances P)
  (check-perturbation 'perturbation-resonances P)
  (for*/list ([(s n) (in-parallel (perturbation-terms P) (in-naturals))]
              [k (in-list (wave-numbers s))]
              #:unless (andmap zero? k))
    (define w (hash-ref (series-waves s) k))
    (list n k (series->formula P (one-wave k (wave-cosine w) (wave-sine w))))))

;; ---------------------------------------------------------------------------
;; In words

(define (perturbation->text P)
  (define lines
    (for/list ([s (in-list (perturbation-terms P))] [n (in-naturals)])
      (format "  order ~a: ~a" n (value->text (series->formula P s)))))
  (define divided
    (for/list ([d (in-list (remove-duplicates (map cdr (perturbation-divisors P))))])
      (format "  divided by: ~a, of the wave ~a" (value->text (cadr d)) (car d))))
  (define kept
    (for/list ([r (in-list (perturbation-resonances P))])
      (format "  resonance: ~a, kept in order ~a" (cadr r) (car r))))
  (apply string-append
         (format "perturbation to order ~a~a" (length (perturbation-Ws P))
                 (if (eqv? 1 (perturbation-parameter P))
                     ""
                     (format " in ~a" (value->text (perturbation-parameter P)))))
         (for/list ([line (in-list (append lines divided kept))])
           (string-append "\n" line))))
