#lang racket/base
;; Normal forms near an equilibrium (Birkhoff 1927; with resonances Gustavson 1966).
;;
;; H = Σ ωⱼ (qⱼ² + pⱼ²)/2 + h₃ + h₄ + ⋯, with hₙ of degree n in coordinates and momenta, is
;; transformed degree by degree (../Lie/Lie-triangle.rkt).  In z = q + i p and w = q − i p the
;; monomial zᵃ wᵇ is removed by dividing by i ω·(a − b): it stays if that is 0, which it always is
;; for a = b, and otherwise is a resonance of the frequencies.

(require racket/list
         "../Lie/Lie-triangle.rkt" "complex-polynomial.rkt" "vanishing-divisor.rkt"
         "../../algebra/expression/expression.rkt" "../../algebra/expression/symbols.rkt"
         "../../calculus/derivative.rkt" "../../calculus/expression-function.rkt"
         "../../error/complain.rkt"
         "../../generic/arithmetic.rkt" "../../generic/define-plain.rkt"
         "../../generic/describe.rkt" "../../generic/function.rkt"
         "../../generic/value-struct.rkt" "../../generic/wrong-argument.rkt"
         "../../hamiltonian/H-state.rkt" "../../hamiltonian/Hamiltonian.rkt"
         "../../lagrangian/generic-state.rkt" "../../lagrangian/local-tuple.rkt"
         "../../value/shape.rkt" "../../value/simplify.rkt" "../../value/rewrite.rkt"
         "../../value/series/series-access.rkt")

(provide Birkhoff-normal-form normal-form? normal-form-Hamiltonian normal-form-generators
         normal-form-resonances
         ;; for transformations and verdicts
         normal-form-state normal-form-given normal-form-terms normal-form-Ws
         check-normal-form polynomial-function)

;; given, terms : the polynomials of degree 2, 3, … of H and of its normal form; Ws : of degree
;; 3, …; divisors : ((degree k . ω·k) …)
(value-struct normal-form (state frequencies given terms Ws divisors)
  #:text normal-form->text)

(define (check-normal-form who N)
  (check-argument who normal-form? N "what Birkhoff-normal-form gives"))

(provide-parts normal-form? "what Birkhoff-normal-form gives"
  normal-form-frequencies normal-form-divisors)

;; ---------------------------------------------------------------------------

;; H near the state where all coordinates and momenta vanish, with numbers for parameters;
;; state : of symbols; degree : of the last terms, at least 3
(define-plain (Birkhoff-normal-form H state #:degree [degree 4])
  (define who 'Birkhoff-normal-form)
  (check-arguments who H state degree)
  (define-values (qs ps) (values (scalars (coordinate state)) (scalars (momentum state))))
  (define n (length qs))
  (define h (homogeneous-parts who H state degree))
  (define frequencies (oscillators who (car h) n))
  (define divisors '())
  (define-values (terms Ws)
    (Lie-triangle h (polynomial-bracket n) polynomial-sum polynomial-scale
                  (lambda (order f)
                    (define-values (W kept gone) (solve-monomials f frequencies))
                    (set! divisors (append divisors (map (lambda (g) (cons (+ order 2) g)) gone)))
                    (values W kept))))
  (normal-form state frequencies h terms Ws (remove-duplicates divisors)))

;; {Σ ω z w/2, W} + f = kept;  -> W, kept, ((a − b . ω·(a − b)) …)
(define (solve-monomials f frequencies)
  (for/fold ([W (hash)] [kept (hash)] [gone '()]) ([(exponents c) (in-hash f)])
    (define k (exponent-differences exponents))
    (define d (apply + (map * k frequencies)))
    (if (vanishing? d frequencies)
        (values W (hash-set kept exponents c) gone)
        (values (hash-set W exponents (/ (* 0+1i c) d)) kept
                (if (positive? (first-nonzero k)) (cons (cons k d) gone) gone)))))

(define (first-nonzero k) (or (findf (lambda (x) (not (zero? x))) k) 0))

;; ---------------------------------------------------------------------------
;; The arguments

(define (check-arguments who H state degree)
  (check-Hamiltonian-and-state who H state)
  (check-symbols who state "state")
  (check-parameters who H state "state")
  (unless (and (exact-integer? degree) (> degree 2))
    (complain-of-argument who "the degree of the last terms, at least 3" degree)))

;; The polynomials of degree 2, …, of the Taylor series of H at the origin.
(define (homogeneous-parts who H state degree)
  (define-values (q p t) (values (coordinate state) (momentum state) (time state)))
  (define (along s) (H (->H-state t (g:* s q) (g:* s p))))
  (check-time-free who H state)
  (define taylor
    (for/list ([d (in-list (values-at-origin who H along degree))] [k (in-naturals)])
      (g:/ d (for/product ([i (in-range 1 (add1 k))]) i))))
  (define-values (qs ps) (values (scalars q) (scalars p)))
  (define parts
    (for/list ([e (in-list (cdr taylor))])
      (expression->polynomial (expand e) qs ps (lambda (part) (raise-no-number who H part)))))
  (unless (zero? (hash-count (car parts)))
    (complain who
              (string-append "the origin is no equilibrium of ~a: the terms of degree 1 are ~a"
                             "\n  move it there, by a translation of coordinates and momenta")
              (value->text H) (value->text (simplify (cadr taylor)))))
  (cdr parts))

;; The derivatives by s of H at s q, s p, at 0
(define (values-at-origin who H along degree)
  (with-handlers ([exn:fail:contract:divide-by-zero?
                   (lambda (e)
                     (complain who "~a has no Taylor series at the origin: it divides by zero there"
                               (value->text H)))])
    (derivatives-at along 0 degree)))

(define (check-time-free who H state)
  (define e (simplify-strictly (H state)))
  (when (occurs? (time state) e)
    (complain who "~a depends on the time ~a, and has no normal form; its value: ~a"
              (value->text H) (time state) (value->text e))))

(define (raise-no-number who H part)
  (complain who
            (string-append "the coefficients of the series of ~a are to be numbers; there is ~a"
                           "\n  give the parameters as numbers")
            (value->text H) (value->text part)))

;; The ω of Σ ω (q² + p²)/2
(define (oscillators who quadratic n)
  (for/list ([j (in-range n)])
    (define c (hash-ref quadratic (pair-of j n) 0))
    (for ([(exponents _) (in-hash quadratic)])
      (unless (for/or ([i (in-range n)]) (equal? exponents (pair-of i n)))
        (raise-no-oscillators who quadratic n)))
    (when (zero? c) (raise-no-oscillators who quadratic n))
    (* 2 (real-part c))))

(define (pair-of j n)
  (for/list ([k (in-range (* 2 n))]) (if (or (= k j) (= k (+ n j))) 1 0)))

(define (raise-no-oscillators who quadratic n)
  (define (names mark) (for/list ([j (in-range n)]) (string->symbol (format "~a_~a" mark j))))
  (complain who
            (string-append "the terms of degree 2 are to be oscillators, the sum of "
                           "ω (q² + p²)/2 for each coordinate; they are ~a\n"
                           "  scale coordinates and momenta, or go over to normal modes")
            (value->text (simplify (polynomial->expression quadratic (names "q") (names "p"))))))

;; ---------------------------------------------------------------------------
;; The results

;; The series of functions of the new state, by degree from 2 on
(define (normal-form-Hamiltonian N)
  (check-normal-form 'normal-form-Hamiltonian N)
  (apply series (map (lambda (f) (polynomial-function N f)) (normal-form-terms N))))

(define (normal-form-generators N)
  (check-normal-form 'normal-form-generators N)
  (map (lambda (f) (polynomial-function N f)) (normal-form-Ws N)))

(define (polynomial-function N f)
  (define e (polynomial-expression N f))
  (define state (normal-form-state N))
  (unary-function (lambda () (value->datum e)) (at)
    (check-state-like 'Birkhoff-normal-form state at)
    (evaluate-at e state at)))

(define (polynomial-expression N f)
  (define state (normal-form-state N))
  (define e (polynomial->expression f (scalars (coordinate state)) (scalars (momentum state))))
  (if (expression? e) (simplify e) e))

;; The integers k with k·ω = 0 of the monomials that stayed beside those of a = b
(define (normal-form-resonances N)
  (check-normal-form 'normal-form-resonances N)
  (remove-duplicates
   (for*/list ([f (in-list (normal-form-terms N))]
               [exponents (in-list (hash-keys f))]
               [k (in-value (exponent-differences exponents))]
               #:when (positive? (first-nonzero k)))
     k)))

;; ---------------------------------------------------------------------------
;; In words

(define (normal-form->text N)
  (define terms
    (for/list ([f (in-list (normal-form-terms N))] [degree (in-naturals 2)])
      (format "\n  degree ~a: ~a" degree (value->text (polynomial-expression N f)))))
  (define resonances (normal-form-resonances N))
  (string-append (format "normal form to degree ~a, of frequencies ~a"
                         (add1 (length terms)) (normal-form-frequencies N))
                 (apply string-append terms)
                 (if (null? resonances) "" (format "\n  resonances: ~a" resonances))))
