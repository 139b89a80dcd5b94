#lang racket/base
;; Is F a total time derivative, and of what?  (SICM 1.6.4, exercises 1.27 and 1.28)
;;
;; F, a function of local tuples up to the k-th derivative, is D_t f for some f of
;; local tuples up to the one before if, and only if, the Euler–Lagrange expression
;; E[F] vanishes identically.  From
;;
;;   ∂_{j+1} D_t f = D_t ∂_{j+1} f + ∂_j f,       j = k, k − 1, ... 1,
;;
;; the derivatives of f follow one after the other: f_j for the j-th derivative of the
;; coordinates and f_t for the time are
;;
;;   f_{k-1} = ∂_{k+1}F,    f_{j-1} = ∂_{j+1}F − D_t f_j,    f_t = F − Σ f_j q^{(j+1)},
;;
;; and f is the integral of its gradient, from variable to variable if antiderivatives
;; are found, else along a straight line, with numbers.  No f_j depends on derivatives
;; from the k-th on, which may be 0 while it is evaluated.

(require racket/list
         "argument-order.rkt"
         "../algebra/expression/expression.rkt"
         "../calculus/antiderivative.rkt" "../calculus/derivative.rkt"
         "../calculus/expression-function.rkt" "../calculus/integral.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/refusal.rkt"
         "../generic/arithmetic.rkt" "../generic/define-plain.rkt" "../generic/describe.rkt"
         "../generic/function-check.rkt"
         "../generic/function.rkt" "../generic/sums-and-products.rkt"
         "../lagrangian/generic-state.rkt" "../lagrangian/Lagrange-equations.rkt"
         "../lagrangian/local-tuple.rkt" "../lagrangian/function-of-momenta.rkt"
         "../lagrangian/total-derivative.rkt"
         "../numeric/finite-number.rkt"
         "../value/assumptions.rkt" "../value/shape.rkt" "../value/structure.rkt"
         "../verdict/prove-zero.rkt" "../verdict/question-domain.rkt"
         "../verdict/surveyed-zero.rkt" "../verdict/verdict.rkt")

(provide verify-total-time-derivative gauge-function)

;; A verdict on E[F] at a local tuple of symbols, up to the highest derivative in F.
(define (verify-total-time-derivative F local)
  (check-question 'verify-total-time-derivative F local)
  (exactness 'verify-total-time-derivative F local))

;; The function f of local tuples with D_t f = F.  It prints as the program that computes
;; it, where a formula was found.
;; zero : the local tuple where f is 0 if it has to be evaluated by an integral
(define-plain (gauge-function F local #:zero-at [zero #f])
  (check-question 'gauge-function F local)
  (check-exact F (exactness 'gauge-function F local))
  (define short (trim-last-argument local))
  (define start (if zero (like zero short) (g:* 0 short)))
  (define slopes (gradient (scalar-valued 'gauge-function F) (order-of local)))
  (define formula (closed-form F slopes local))
  (define (name)
    (if formula
        `(lambda (,(value->datum short)) ,(value->datum formula))
        `(gauge-function ,(value->datum F))))
  (unary-function name (given)
    (define at (like given short))
    (if formula (evaluate-at formula short at) (line-integral F slopes start at))))

(define (check-question who F local)
  (check-order-of-arguments who '(F local) (list F local))
  (check-takes who F 1 "expected a function of the local tuple (up t q v)")
  (when (of-momenta? F) (raise-of-momenta who F))
  (check-generic-state who local)
  (check-parameters who F local))

;; The highest derivative in the local tuple.
(define (order-of local) (- (s:length local) 2))

(define (exactness who F local)
  (define n (order-of local))
  (define F-scalar (scalar-valued who F))
  (define longer (lengthened local (+ (* 2 n) 2)))
  (prove-residual-zero (lambda () ((Euler-Lagrange-operator F-scalar #:order n) longer))
                       (scalars longer)
                       #:domain (lambda () (values-at (list F) local))
                       #:order (add1 n)
                       #:about (gauge-claim #f F-scalar 1 local)))

(define (check-exact F v)
  (unless (proved? v)
    (raise-no-answer 'gauge-function
                     "~a ~a a total time derivative\n  its Euler-Lagrange expression: ~a~a"
                     (value->text F)
                     (if (refuted? v) "is not" "is not known to be")
                     (value->text (verdict-residual v))
                     (kinks->text v))))

;; ---------------------------------------------------------------------------
;; The gradient

;; Functions f_t, f_0, ... f_{k-1} of local tuples up to the derivative before the k-th.
(define (gradient F k)
  (define (at-length n f) (lambda (local) (f ((clip-state n) local))))
  (define by-coordinates
    (for/fold ([found '()]) ([j (in-range k 0 -1)])
      (define own (at-length (+ k 2) ((partial (add1 j)) F)))
      (cons (if (null? found) own (less own (Dt (car found)))) found)))
  (define along (padding (+ (* 2 k) 1)))
  (define slopes
    (for/list ([f (in-list by-coordinates)] [j (in-naturals)])
      (lambda (local) (f ((clip-state (- (+ (* 2 k) 1) j)) (along local))))))
  (define (by-time local)
    (define rates (cddr (structure->list (along local))))
    (for/fold ([sum ((at-length (+ k 2) F) (along local))])
              ([slope (in-list slopes)] [rate (in-list rates)])
      (g:- sum (g:* (slope local) rate))))
  (cons by-time slopes))

(define ((less f g) local) (g:- (f local) (g local)))

;; Local tuples extended to that length by zeros.
(define ((padding length) local)
  (define zero (g:* 0 (coordinate local)))
  (list->up (append (structure->list local) (make-list (- length (s:length local)) zero))))

(define (gradient-at slopes local)
  (append-map (lambda (slope) (scalars (slope local))) slopes))

;; ---------------------------------------------------------------------------
;; The integral

;; An expression for f at the local tuple without its last part, or #f.
(define (closed-form F slopes local)
  (define short (trim-last-argument local))
  (define f (potential (gradient-at slopes short) (scalars short) (assumptions-in-force)))
  (define (value at) (evaluate-at f short at))
  (and f (proved? (verify-equal ((Dt value) local) (F local))) f))

;; f at numbers, from `start` along a straight line.
(define (line-integral F slopes start at)
  (when (ormap symbolic? (scalars at)) (raise-no-closed-form F))
  (check-start F slopes start)
  (define way (g:- at start))
  (define (slope-along s)
    (g:for/sum ([slope (in-list (gradient-at slopes (g:+ start (g:* s way))))]
                [step (in-list (scalars way))])
      (g:* slope step)))
  (integrate 'gauge-function slope-along 0 1 1e-12))

;; The integrand may be 0/0 at the start and yet pass for 0 on all lines from there.
(define (check-start F slopes start)
  (unless (if-raised divided-by-zero? #f (andmap finite? (gradient-at slopes start)))
    (raise-no-answer 'gauge-function
                     (string-append "the integral for ~a cannot begin where it is not finite"
                                    "\n  begin: ~a"
                                    "\n  another place to begin is given as #:zero-at")
                     (value->text F) (value->text start))))

(define (raise-no-closed-form F)
  (raise-no-answer 'gauge-function
                   (string-append "~a is a total time derivative, "
                                  "but no formula for its integral was found"
                                  "\n  it can be evaluated at numbers")
                   (value->text F)))

(define (like given short)
  (define clipped ((clip-state (s:length short)) given))
  (unless (= (shape-length clipped) (shape-length short))
    (complain 'gauge-function "expected a local tuple like ~a; given ~a"
              (value->text short) (describe-with-value given)))
  clipped)
