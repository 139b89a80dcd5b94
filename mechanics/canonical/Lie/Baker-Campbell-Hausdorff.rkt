#lang racket/base
;; The exponent of a product of exponentials, exp(A) exp(B) = exp(Z) (SICM 6.5, p. 451).
;;
;; Z = Z₁ + Z₂ + ⋯ with Zₙ of order n in A and B.  Differentiating exp(Z) as A and B grow in
;; proportion gives (Varadarajan, Lie Groups, 2.15), with the Bernoulli numbers Bₙ,
;;
;;     Z₁ = A + B
;;     (n + 1) Zₙ₊₁ = ½ [A − B, Zₙ] + Σₚ B₂ₚ/(2p)! Σ [Z_{k₁}, [ ⋯ [Z_{k₂ₚ}, A + B] ⋯ ]],
;;
;; where the k add up to n: brackets alone.  For operators these are commutators.  Hamiltonians
;; stand for their Lie derivatives, and [L_f, L_g] = L_{g, f} by Jacobi's identity.  The inner sums
;; come again from order to order, and are kept.

(require (only-in math/number-theory bernoulli-number)
         "../../algebra/expression/expression.rkt"
         "../../calculus/expression-function.rkt"
         "../../error/complain.rkt" "../../error/refusal.rkt"
         "../../generic/arithmetic.rkt" "../../generic/describe.rkt" "../../generic/function.rkt"
         "../../hamiltonian/H-state.rkt" "../../hamiltonian/Poisson-bracket.rkt"
         "../../value/operator.rkt" "../../value/shape.rkt" "../../value/simplify.rkt"
         "../../value/series/coefficients.rkt" "../../value/series/series.rkt")

(provide Baker-Campbell-Hausdorff)

;; A, B : two operators, or two functions of the state
;; -> the series of the Zₙ, beginning with 0
(define (Baker-Campbell-Hausdorff A B)
  (define bracket
    (cond [(and (operator? A) (operator? B)) commutator]
          [(and (pointwise? A) (accepts? A 1) (pointwise? B) (accepts? B 1))
           (lambda (f g) (memoized-function (Poisson-bracket g f)))]
          [else
           (complain 'Baker-Campbell-Hausdorff
                     "expected two operators, or two Hamiltonians; given ~a and ~a"
                     (describe-with-value A) (describe-with-value B))]))
  (define sums (make-hash))             ; (r . n) : the nested sums
  (define terms
    (make-coefficients
     (lambda (n)
       (case n
         [(0) 0]
         [(1) (g:+ A B)]
         [else (term bracket A B n (lambda (k) (coefficient terms k)) sums)]))))
  (series-of terms))

;; Zₙ of those before
(define (term bracket A B n Z sums)
  (define m (sub1 n))
  (define half (g:* 1/2 (bracket (g:- A B) (Z m))))
  (define sum
    (for*/fold ([sum half]) ([r (in-range 2 n 2)]
                             [nested (in-value (nested-sum bracket (g:+ A B) Z r m sums))]
                             #:when nested)
      (g:+ sum (g:* (/ (bernoulli-number r) (factorial r)) nested))))
  (g:* (/ 1 n) sum))

;; Σ [Z_{k₁}, [ ⋯ [Z_{kᵣ}, X] ⋯ ]] over k₁ + ⋯ + kᵣ = n, all at least 1; #f if there is none
(define (nested-sum bracket X Z r n sums)
  (define (sum)
    (for/fold ([sum #f]) ([k (in-range 1 (add1 n))])
      (define inner (nested-sum bracket X Z (sub1 r) (- n k) sums))
      (define part (and inner (bracket (Z k) inner)))
      (cond [(not part) sum]
            [sum (g:+ sum part)]
            [else part])))
  (if (= r 0)
      (and (= n 0) X)
      (hash-ref! sums (cons r n) sum)))

;; ---------------------------------------------------------------------------
;; Brackets of brackets run the functions below them anew, twice as often at each level; memoized
;; functions, which are called at a state of symbols once, do not.  A function that fails at
;; symbols is called at each state.

(define (memoized-function F)
  (define function-for (by-shape (lambda (state) (work-out F state)) #:lasting? (lambda (f) #f)))
  (unary-function (lambda () (value->datum F)) (state)
    (check-H-state 'Baker-Campbell-Hausdorff state)
    ((function-for state) state)))

;; -> a function of states of this shape
(define (work-out F state)
  (define place (symbols-like state "z"))
  (define value
    (if-raised raised? #f
      (define value (F place))
      (and (expression? value) (simplify-strictly value))))
  (if value (lambda (at) (evaluate-at value place at)) F))
