#lang racket/base
;; Perturbation theory as a procedure (SICM 7.1–7.3).
;;
;; H = H₀(I) + ε H₁(θ, I) + ε² H₂(θ, I) + ⋯ with waves in the angles θ is transformed, order by
;; order, to one without angles (../Lie/Lie-triangle.rkt, homological.rkt).  Waves that cannot be
;; removed, or are not to be, stay: resonances.  All divisors are kept with the answer, for where
;; one is small the answer is worth nothing.

(require "../Lie/Lie-triangle.rkt" "homological.rkt" "perturbation-results.rkt" "Poisson-series.rkt"
         "symbols-for-decimals.rkt" "unperturbed.rkt"
         "../../algebra/expression/symbols.rkt"
         "../../calculus/expression-function.rkt"
         "../../error/complain.rkt"
         "../../generic/define-plain.rkt" "../../generic/describe.rkt"
         "../../generic/scalar.rkt" "../../generic/wrong-argument.rkt"
         "../../hamiltonian/H-state.rkt" "../../hamiltonian/Hamiltonian.rkt"
         "../../lagrangian/generic-state.rkt" "../../lagrangian/local-tuple.rkt"
         "../../value/shape.rkt" "../../value/simplify.rkt")

(provide perturbation-series)

;; H1 : a function of the state, or the list of H₁, H₂, …
;; resonances : lists of integers, of the waves to be kept
(define-plain (perturbation-series H0 H1 state #:order [order 1] #:parameter [parameter 'epsilon]
                                   #:keep [resonances '()])
  (define who 'perturbation-series)
  (define given (cons H0 (if (list? H1) H1 (list H1))))
  (check-arguments who given state order)
  (define-values (angles actions)
    (values (scalars (coordinate state)) (scalars (momentum state))))
  (check-resonances who resonances (length angles))
  (check-parameter who parameter given state)
  (define decimals (name-decimals (for/list ([H (in-list given)]) (H state))))
  (define h (in-waves who given state order decimals))
  (define frequencies (frequencies-of H0 state decimals))
  (define (number e) (simplify-strictly (with-decimals-back e decimals)))
  (define removals (make-vector order '()))
  (define (solve n hn)
    (define-values (W kept gone) (solve-homological hn frequencies (multiple-of resonances) number))
    (vector-set! removals (sub1 n) gone)
    (values W kept))
  (define-values (terms generators)
    (Lie-triangle h (lambda (F W) (series-bracket F W actions)) series-sum series-scale solve))
  (perturbation state given parameter terms generators (vector->list removals) decimals))

;; ω = ∂H₀/∂I, a list
(define (frequencies-of H0 state decimals)
  (define e (with-decimals-named (H0 state) decimals))
  (for/list ([I (in-list (scalars (momentum state)))]) (expression-derivative e I)))

;; Is k a multiple of one that is to be kept?
(define ((multiple-of resonances) k)
  (for/or ([r (in-list resonances)])
    (define ratio (for/first ([x (in-list k)] [y (in-list r)] #:unless (zero? y)) (/ x y)))
    (and ratio (equal? k (map (lambda (y) (* ratio y)) r)))))

;; ---------------------------------------------------------------------------
;; The arguments

(define (check-arguments who given state order)
  (for ([H (in-list given)]) (check-Hamiltonian who H))
  (check-H-state who state)
  (check-symbols who state "state")
  (check-argument who exact-positive-integer? order "the order, at least 1")
  (for ([H (in-list given)])
    ((number-valued who H) state)
    (check-parameters who H state "state"))
  (check-unperturbed who (car given) state))

;; ε must not stand in the Hamiltonians.
(define (check-parameter who parameter given state)
  (unless (scalar? parameter)
    (complain who "the parameter is a number or a symbol; given ~a"
              (describe-with-value parameter)))
  (when (for*/or ([e (in-list (cons state (map (lambda (H) (H state)) given)))]
                  [x (in-list (scalars e))])
          (and (symbol? parameter) (occurs? parameter x)))
    (complain who "the parameter ~a stands in the state or in a Hamiltonian, too; #:parameter ~a"
              parameter "gives it another name")))

(define (check-resonances who resonances n)
  (unless (and (list? resonances)
               (for/and ([r (in-list resonances)])
                 (and (list? r) (= (length r) n) (andmap exact-integer? r)
                      (not (andmap zero? r)))))
    (complain who
              "the waves to be kept are lists of ~a, one for each angle, such as ~s; given ~s"
              (if (= n 1) "one integer" (format "~a integers" n))
              (list (cons 1 (for/list ([_ (in-range (sub1 n))]) -1)))
              resonances)))

;; -> the list of the Poisson series of H₀, …, H_order
(define (in-waves who given state order decimals)
  (define angles (scalars (coordinate state)))
  (for/list ([k (in-range (add1 order))])
    (cond [(< k (length given))
           (define H (list-ref given k))
           (define e (H state))
           (define waves
             (expression->Poisson-series
              (with-decimals-named e decimals) angles
              (lambda (part) (raise-no-waves who H (with-decimals-back part decimals)))))
           (check-time who H e (time state))
           waves]
          [else (zero-series (length angles))])))

(define (check-time who H e t)
  (when (and (symbol? t) (occurs? t (simplify-strictly e)))
    (complain who
              (string-append "~a depends on the time ~a: periodic-extension makes it an angle"
                             "\n  its value: ~a")
              (value->text H) t (value->text e))))

(define (raise-no-waves who H part)
  (complain who
            (string-append "a perturbation is a sum of sines and cosines of integer multiples of "
                           "the angles, with coefficients in the momenta; in ~a there is ~a")
            (value->text H) (value->text part)))
