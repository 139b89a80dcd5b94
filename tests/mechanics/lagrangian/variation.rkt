#lang racket/base
;; V6: the variation operator δ_η obeys the rules of a derivation of functions
;; of paths, and commutes with the derivative by time (SICM 1.5.1, exercise 1.8).

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/value/compose
         mechanics/value/operator
         mechanics/value/structure
         mechanics/calculus/derivative
         mechanics/calculus/literal-function
         mechanics/value/signature
         mechanics/lagrangian/local-tuple
         mechanics/lagrangian/variation
         mechanics/lagrangian/Lagrange-equations
         (only-in mechanics/book L-free-particle)
         "../support/checks.rkt" "../support/same.rkt" "../support/systems.rkt")

(define q (literal-function 'q))
(define eta (literal-function 'eta))
(define delta-eta (delta eta))

;; f and g: functions of paths, made of unknown functions of the local tuple.
(define F (literal-function 'F (-> (UP Real Real Real) Real)))
(define G (literal-function 'G (-> (UP Real Real Real) Real)))
(define (f q) (compose F (Gamma q)))
(define (g q) (compose G (Gamma q)))

(define-check (check-at-t left right)
  (define a (left 't))
  (define b (right 't))
  (with-check-info (['left a] ['right b])
    (unless (same? a b) (fail-check))))

(define (vary h) ((delta-eta h) q))

(test-case "the variation of the path is η, of its derivative Dη"
  (check-at-t (vary (lambda (q) q)) eta)
  (check-at-t (vary (lambda (q) (D q))) (D eta))
  (check-at-t (vary (lambda (q) ((g:expt D 3) q))) ((g:expt D 3) eta)))

(test-case "the variation of a function of the local tuple"
  (define local (Gamma q))
  (check-at-t (vary f)
              (lambda (t)
                (g:+ (g:* (((partial 1) F) (local t)) (eta t))
                     (g:* (((partial 2) F) (local t)) ((D eta) t))))))

(test-case "sums, differences, constant multiples"
  (check-at-t (vary (g:+ f g)) (g:+ (vary f) (vary g)))
  (check-at-t (vary (g:- f g)) (g:- (vary f) (vary g)))
  (check-at-t (vary (g:* 'c g)) (g:* 'c (vary g)))
  (check-at-t (vary (lambda (q) (lambda (t) 'c))) (lambda (t) 0)))

(test-case "the product rule"
  (check-at-t (vary (g:* f g)) (g:+ (g:* (vary f) (g q)) (g:* (f q) (vary g)))))

(test-case "the quotient rule"
  (check-at-t (vary (g:/ f g))
              (g:/ (g:- (g:* (vary f) (g q)) (g:* (f q) (vary g))) (g:square (g q)))))

(test-case "the chain rule"
  (define phi (literal-function 'phi))
  (define (h q) (compose phi (g q)))
  (check-at-t (vary h) (g:* (compose (D phi) (g q)) (vary g))))

(test-case "variation commutes with the derivative by time"
  (check-at-t (D (vary f)) (vary (lambda (q) (D (f q))))))

(test-case "variations commute with each other"
  (define delta-zeta (delta (literal-function 'zeta)))
  (check-at-t ((delta-zeta (delta-eta f)) q) ((delta-eta (delta-zeta f)) q))
  (check-at-t (((g:* delta-zeta delta-eta) f) q) ((delta-eta (delta-zeta f)) q)))

(test-case "the first variation of the action integrand is Lagrange's, up to a total derivative"
  ;; δL = D(∂₂L η) - (D ∂₂L - ∂₁L) η along the path
  (define L (literal-function 'L (Lagrangian)))
  (define momentum (compose ((partial 2) L) (Gamma q)))
  (check-at-t (vary (lambda (q) (compose L (Gamma q))))
              (g:- (D (g:* momentum eta))
                   (g:* ((Lagrange-equations L) q) eta))))

(test-case "paths of several coordinates"
  (define eta2 (up eta (literal-function 'zeta)))
  (define (kinetic q) (compose (L-free-particle 'm) (Gamma q)))
  (define path literal-plane-path)
  (check-at-t (((delta eta2) kinetic) path)
              (g:* 'm (g:+ (g:* (D (ref path 0)) (D (ref eta2 0)))
                           (g:* (D (ref path 1)) (D (ref eta2 1)))))))

(test-case "a variation may be a known function, and a path too"
  (define variation (delta (lambda (t) (g:* t (g:- t 1)))))
  (check-equal? (((variation (lambda (q) (g:square q))) (lambda (t) (g:* 2 t))) 3) 72))

(test-case "δ is an operator, and prints as what was typed"
  (check-pred operator? delta-eta)
  (check-equal? (format "~a" delta-eta) "(delta eta)")
  (check-equal? (format "~a" (delta-eta f)) "((delta eta) f)")
  (check-equal? (format "~a" ((delta-eta f) q)) "(((delta eta) f) q)")
  (check-equal? (format "~a" (g:* 2 (g:expt delta-eta 2))) "(* 2 (expt (delta eta) 2))"))

(test-case "what is no variation, or no function of paths, is refused"
  (check-exn
   #rx"^delta: expected a variation: a function of time, or a tuple of them\n  given: the symbol eta"
   (lambda () (delta 'eta)))
  (check-exn #rx"^delta: expected a function of paths\n  given: the number 3"
             (lambda () (delta-eta 3))))
