#lang racket/base
;; The Hamilton–Jacobi equation by separation of variables (SICM 6.1).
;;
;; H(q, ∂W/∂q) = E has a solution W = Σ Wᵢ(qⁱ), one term for each coordinate, if the equation
;; falls apart (separated-equation.rkt): pᵢ = DWᵢ(qⁱ) depends on its own coordinate and the
;; constants alone.
;; There are as many of these as coordinates: S = W − E t is a complete integral, and the constants,
;; as functions of the state, are conserved.

(require racket/string
         "momentum-by-energy.rkt" "separated-equation.rkt"
         "../calculus/expression-function.rkt"
         "../error/complain.rkt" "../error/failure.rkt"
         "../generic/arithmetic.rkt" "../generic/define-plain.rkt" "../generic/describe.rkt"
         "../generic/function.rkt" "../generic/on-demand.rkt" "../generic/printed-function.rkt"
         "../generic/scalar.rkt" "../generic/up-down.rkt" "../generic/value-struct.rkt"
         "../generic/wrong-argument.rkt"
         "../hamiltonian/H-state.rkt" "../hamiltonian/Hamiltonian.rkt"
         "../lagrangian/generic-state.rkt" "../lagrangian/local-tuple.rkt"
         "../value/assumptions.rkt" "../value/shape.rkt"
         "../value/simplify.rkt"
         "../verdict/prove-zero.rkt")

(require-on-demand ["../calculus/antiderivative.rkt" antiderivative]
                   ["../compile/definite-integral.rkt" definite-integral])

(provide separate-Hamilton-Jacobi separation?
         separation-momenta separation-constants separation-integrals separation-function
         verify-separation
         ;; for actions and frequencies
         (struct-out separation) check-separation pieces-by-coordinate momentum-of degree-of)

;; pieces : in the order in which they were found; the last has the energy for its constant
(value-struct separation (H state energy pieces)
  #:text separation->text)

;; state : of symbols; energy : a symbol, or a value for it
(define-plain (separate-Hamilton-Jacobi H state #:energy [energy 'E])
  (define who 'separate-Hamilton-Jacobi)
  (define e (checked-value who H state energy))
  (define-values (qs ps) (values (scalars (coordinate state)) (scalars (momentum state))))
  (define result (split (g:- e energy) qs ps (constant-name e energy)))
  (when (unsplit? result) (raise-not-separable who H result))
  (for ([x (in-list result)])
    (unless (memv (degree-of x) '(1 2)) (raise-no-momentum who H x)))
  (separation H state energy result))

(define (check-separation who s)
  (check-argument who separation? s "what separate-Hamilton-Jacobi gives"))

;; ---------------------------------------------------------------------------
;; The arguments: a Hamiltonian without explicit time, in which all momenta are, and an energy that
;; is constant

;; -> H at the state of symbols, an expression
(define (checked-value who H state energy)
  (check-Hamiltonian-and-state who H state)
  (check-symbols who state "state")
  (define e (simplify-strictly ((number-valued who H) state)))
  (check-parameters who H state "state")
  (check-motion who H state e)
  (check-energy who H state e energy)
  e)

(define (check-motion who H state e)
  (when (holds? e (time state))
    (complain who
              (string-append "~a depends on the time ~a; extended-Hamiltonian makes the time a "
                             "coordinate\n  its value: ~a")
              (value->text H) (time state) (value->text e)))
  (for ([p (in-list (scalars (momentum state)))] #:unless (holds? e p))
    (complain who
              "~a does not depend on the momentum ~a: its coordinate rests, and separates nothing"
              (value->text H) p)))

(define (check-energy who H state e energy)
  (unless (scalar? energy)
    (complain who "the energy is a symbol or a number; given ~a" (describe-with-value energy)))
  (when (or (holds? e energy) (memq energy (scalars state)))
    (complain who
              (string-append "the symbol ~a, for the energy, stands in ~a or in the state, too; "
                             "#:energy names another")
              energy (value->text H)))
  (for ([x (in-list (scalars state))] #:when (holds? energy x))
    (complain who "the energy is constant, and does not depend on the state; given ~a"
              (value->text energy))))

;; q -> alpha_q, primed where that is taken
(define ((constant-name e energy) q)
  (let retry ([name (format "alpha_~a" q)])
    (define symbol (string->symbol name))
    (if (or (holds? e symbol) (eq? symbol energy)) (retry (string-append name "prime")) symbol)))

;; ---------------------------------------------------------------------------
;; The results

(define (pieces-by-coordinate s)
  (for/list ([q (in-list (scalars (coordinate (separation-state s))))])
    (findf (lambda (x) (eq? (piece-q x) q)) (separation-pieces s))))

(define (momenta-by-coordinate s) (map momentum-of (pieces-by-coordinate s)))

;; The p of a piece, by its equation
(define (momentum-of x)
  (simplify (momentum-by-energy (lambda (p) (equation-at x p)) (degree-of x) 0 1)))

(define (degree-of x) (degree-in (lambda (p) (equation-at x p)) (piece-p x)))

;; ∂S/∂q, of the shape of the momenta: that of each coordinate with + of its root
(define (separation-momenta s)
  (check-separation 'separation-momenta s)
  (list->structure (momentum (separation-state s)) (momenta-by-coordinate s)))

;; The energy, and the others in the order found
(define (separation-constants s)
  (check-separation 'separation-constants s)
  (cons (separation-energy s) (filter values (map piece-constant (separation-pieces s)))))

;; The same as functions of the state
(define (separation-integrals s)
  (check-separation 'separation-integrals s)
  (define names (scalars (separation-state s)))
  (define H (separation-H s))
  (define (value-at at)
    (define start (cons (cons (separation-energy s) (H at)) (map cons names (scalars at))))
    (for/fold ([point start]) ([x (in-list (separation-pieces s))] #:when (piece-constant x))
      (cons (cons (piece-constant x) (evaluate-generically (piece-integral x) point)) point)))
  (cons H
        (for/list ([c (in-list (cdr (separation-constants s)))])
          (unary-function (lambda () c) (at)
            (check-state-like 'separation-integrals (separation-state s) at)
            (cdr (assq c (value-at at)))))))

;; S(t, q) = Σ ∫ pᵢ dqⁱ − E t.  zero : coordinates where integrals without a formula begin, or #f
(define-plain (separation-function s #:zero-at [zero #f])
  (define who 'separation-function)
  (check-separation who s)
  (define qs (scalars (coordinate (separation-state s))))
  (check-zero who s zero)
  (define terms
    (for/list ([p (in-list (momenta-by-coordinate s))] [q (in-list qs)] [k (in-naturals)])
      (primitive who p q (and zero (list-ref (scalars zero) k)))))
  (define (principal-function t q)
    (for/fold ([S (g:* -1 (separation-energy s) t)])
              ([W (in-list terms)] [x (in-list (scalars q))])
      (g:+ S (W x))))
  (make-function (procedure-rename principal-function who) 4
                 (call-datum who (separation-H s))))

;; ∫ p dq as a function, by a formula or by numbers from where it begins
(define (primitive who p q start)
  (define (at e x) (evaluate-generically e (list (cons q x))))
  (define formula (antiderivative p q (assumptions-in-force)))
  (cond [formula (lambda (x) (at formula x))]
        [start (lambda (x) (definite-integral (lambda (x) (at p x)) start x))]
        [else
         (raise-no-answer who
                          (string-append "no formula was found for the integral of the momentum "
                                         "of ~a\n  momentum: ~a"
                                         "\n  #:zero-at names where it is to begin, for numbers")
                          q (value->text p))]))

(define (check-zero who s zero)
  (define q (coordinate (separation-state s)))
  (when (and zero (not (same-shape? zero q)))
    (complain who "the integrals begin at coordinates like ~a; given ~a" (value->text q)
              (describe-with-value zero))))

;; Do the momenta found solve H(q, p(q)) = E?
(define (verify-separation s)
  (check-separation 'verify-separation s)
  (define state (separation-state s))
  (prove-zero (g:- ((separation-H s) (up (time state) (coordinate state) (separation-momenta s)))
                   (separation-energy s))
              #:variables (scalars (coordinate state))))

;; ---------------------------------------------------------------------------
;; Failure to separate

(define (raise-not-separable who H u)
  (define found (map piece-q (unsplit-pieces u)))
  (raise-no-answer
   who
   (string-append "the Hamilton–Jacobi equation of ~a was not found to separate in these "
                  "coordinates~a\n  what is left, with ~a: ~a = 0\n  other coordinates: "
                  "(compose H (F->CH F))")
   (value->text H)
   (if (null? found) "" (format "; ~a did" (string-join (map symbol->string found) ", ")))
   (string-join (map (lambda (o) (symbol->string (car o))) (unsplit-open u)) " and ")
   (value->text (unsplit-equation u))))

(define (raise-no-momentum who H x)
  (raise-no-answer who
                   (string-append "the equation of ~a alone was not solved for ~a, in which it is "
                                  "of a degree other than 1 and 2\n  equation: ~a = 0")
                   (piece-q x) (piece-p x) (value->text (piece-equation x))))

;; ---------------------------------------------------------------------------
;; In words

(define (separation->text s)
  (define lines
    (for/list ([x (in-list (separation-pieces s))])
      (format "\n  ~a: ~a = ~a~a" (piece-q x) (piece-p x) (value->text (momentum-of x))
              (if (or (not (piece-constant x)) (piece-cyclic? x))
                  ""
                  (format "\n     with ~a = ~a" (piece-constant x)
                          (value->text (piece-integral x)))))))
  (string-append "separated, with the energy " (value->text (separation-energy s)) ":"
                 (apply string-append lines)))
