#lang racket/base
;; Integrals of functions made by the generic arithmetic.
;;
;; Within a derivative the integrand, or a limit, may be a perturbed value.
;; Integration is linear, so the integral of f + f' ε + … is that of f plus ε times
;; that of f', and so on; and at a limit b + b' ε it is the integral up to b plus
;; f(b) b' ε, to higher order the Taylor series that this begins.  Where a gradient
;; is taken, the derivative by each variable is the integral of that of f.

(require "perturbed.rkt" "dual.rkt" "jet.rkt" "recorded.rkt" "tape.rkt" "derivative.rkt"
         "number.rkt"
         "../generic/arithmetic.rkt" "../generic/elementary.rkt"
         "../numeric/improper-quadrature.rkt")

(provide definite-integral integrate)

;; The integral of a function of one variable, to a tolerance relative to the
;; integral of its absolute value.
(define (definite-integral f low high [tolerance 1e-10])
  (check-function-of-one-variable 'definite-integral f)
  (integrate 'definite-integral f low high tolerance))

;; The same on behalf of `who`.
(define (integrate who f low high tolerance)
  (cond
    [(perturbed? low) (g:- (integrate who f (base low) high tolerance) (edge f low))]
    [(perturbed? high) (g:+ (integrate who f low (base high) tolerance) (edge f high))]
    [else (integrate-between who f (number who low) (number who high) tolerance)]))

(define (base limit) ((parts-value (parts-of limit)) limit))

;; What the ε of a limit b + δ adds: Σ f⁽ᵐ⁾(b) δᵐ⁺¹/(m+1)!, where δ to the power of
;; the order is the last that does not vanish.
(define (edge f limit)
  (define b (base limit))
  (define δ (g:- limit b))
  (define slopes (derivatives-at f b (if (jet? limit) (sub1 (jet-order limit)) 0)))
  (for/fold ([sum 0] [term 1] #:result sum) ([slope (in-list slopes)] [m (in-naturals 1)])
    (define next (g:/ (g:* term δ) m))
    (values (g:+ sum (g:* slope next)) next)))

;; Between numbers.  Where f turns out to be perturbed, its parts are integrated
;; one after the other.
(define (integrate-between who f low high tolerance)
  (define (integral g) (integrate-between who g low high tolerance))
  (define result
    (let/ec stop
      (define (sample x)
        (define y (f x))
        (cond [(real? y) y]
              [(perturbed? y) (stop y)]
              [else (number who y)]))
      (improper-quadrature sample low high #:tolerance tolerance #:name who)))
  (cond [(recorded? result) (integral-recorded integral f (recorded-tape result))]
        [(perturbed? result)
         (integral-by-parts integral f (perturbed-tag result) (if (jet? result) (jet-order result) #f))]
        [else result]))

;; The derivatives by all variables of the tape come from the same runs of f.
(define (integral-recorded integral f tape)
  (define runs (make-hasheqv))          ; x -> value there, and its derivatives
  (define (run x)
    (or (hash-ref runs x #f)
        (let ([r (call-with-values (lambda () (value-and-derivatives tape (f x))) cons)])
          (hash-set! runs x r)
          r)))
  (define value (integral (lambda (x) (car (run x)))))
  (for/fold ([sum value]) ([i (in-range (tape-inputs tape))])
    (define slope (integral (lambda (x) ((cdr (run x)) i))))
    (g:+ sum (g:* slope (record-input tape i 0)))))

;; order : of a jet, #f for a dual number
(define (integral-by-parts integral f tag order)
  (define ε (if order (displaced tag order 0) (perturb tag 0)))
  (for/fold ([sum 0]) ([k (in-range (add1 (or order 1)))])
    (define part (integral (lambda (x) (coefficient-part (f x) tag k))))
    (g:+ sum (if (eqv? k 0) part (g:* part (g:expt ε k))))))

;; The coefficient of εᵏ in x, for the ε of this tag.
(define (coefficient-part x tag k)
  (define (from x)
    (cond [(not (perturbed? x)) (if (eqv? k 0) x 0)]
          [(not (eqv? (perturbed-tag x) tag)) ((parts-map (parts-of x)) from x)]
          [(jet? x) (jet-coefficient x k)]
          [(eqv? k 0) (primal-part x tag)]
          [else (tangent-part x tag)]))
  (from x))
