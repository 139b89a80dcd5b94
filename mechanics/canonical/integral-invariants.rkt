#lang racket/base
;; Integral invariants (SICM 5.3, pp. 362–364; 5.5.1, p. 402).
;;
;; A curve of states s(λ), closed, has the integral ∮ p dq, which canonical transformations keep:
;; Poincaré's invariant.  With the time it is Poincaré and Cartan's, ∮ p dq − H dt.  A patch of
;; states has Σ ∬ dqⁱ dpᵢ, the areas of its projections with their signs.

(require "../calculus/derivative.rkt" "../calculus/perturbed-value.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/define-plain.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/on-demand.rkt"
         "../generic/printed-function.rkt"
         "../hamiltonian/H-state.rkt" "../hamiltonian/Hamiltonian.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/shape.rkt")

(require-on-demand ["../compile/definite-integral.rkt" definite-integral])

(provide loop-integral loop-integrand)

;; loop : λ ↦ state;  the integral of p dq, or of p dq − H dt, from low to high
(define-plain (loop-integral loop low high #:Hamiltonian [H #f] #:tolerance [tolerance 1e-10])
  (check-loop 'loop-integral loop)
  (when H (check-Hamiltonian 'loop-integral H))
  (check-closed loop low high)
  (definite-integral (loop-integrand loop H) low high tolerance))

;; λ ↦ p Dq − H Dt
(define (loop-integrand loop [H #f])
  (check-loop 'loop-integrand loop)
  (printed-function (loop-integrand loop) (x)
    (define-values (state rate) (value-and-derivative-along loop x 1))
    (unless (H-state? state)
      (complain 'loop-integral "a loop gives states (up t q p), but ~a gives ~a"
                (value->text loop) (describe-with-value state)))
    (define action (g:* (momentum state) (coordinate rate)))
    (if H (g:- action (g:* (H state) (time rate))) action)))

;; A coordinate that is an angle may come back a turn on; momenta come back as they were.
(define (check-closed loop low high)
  (when (and (real? low) (real? high) (not (= low high)))
    (define-values (start end) (values (loop low) (loop high)))
    (when (and (H-state? start) (H-state? end))
      (unless (same? (momenta-of start) (momenta-of end))
        (complain 'loop-integral
                  (string-append "the curve is not closed: its momenta are others at its end"
                                 "\n  ~a: ~a\n  ~a: ~a\n  once round is from 0 to (* 2 pi) where the "
                                 "curve is of sines and cosines")
                  (value->text low) (value->text start) (value->text high) (value->text end))))))

(define (momenta-of state)
  (for/list ([p (in-list (scalars (momentum state)))]) (comparand (innermost p))))

;; As far as they are numbers.
(define (same? ps qs)
  (for/and ([p (in-list ps)] [q (in-list qs)])
    (or (not (rational? p))
        (not (rational? q))
        (<= (abs (- p q)) (* 1e-6 (+ 1 (abs p) (abs q)))))))

(define (check-loop who loop)
  (unless (and (of-functions? loop) (accepts? loop 1))
    (complain who "expected a loop, a function of one parameter with states as values; given ~a"
              (describe-function loop))))
