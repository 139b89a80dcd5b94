#lang racket/base
;; Is a transformation canonical?  Residuals along which Hamilton's equations of the old state
;; go over into those of the new one (SICM 5.2).
;;
;; C takes new states to old ones.  With the vector fields D_s H = (1, ∂₂H, −∂₁H) of the
;; Hamiltonians, C is canonical for H and H' if moving in the new state and then transforming is
;; the same as transforming and then moving in the old one:
;;
;;     D_s H ∘ C − DC · D_s H' = 0.
;;
;; If H' = H∘C + K, the terms fall apart in one that is linear in DH and one without it: DC is
;; to keep J, which takes a gradient (a, b, c) to (0, c, −b), and K has to make up for the time
;; in C.

(require racket/list
         "transformation.rkt"
         "../algebra/expression/symbols.rkt"
         "../calculus/derivative.rkt"
         "../generic/arithmetic.rkt" "../generic/function.rkt"
         "../generic/printed-function.rkt" "../generic/wrong-argument.rkt"
         "../hamiltonian/H-state.rkt" "../hamiltonian/Hamilton-equations.rkt"
         "../hamiltonian/Hamiltonian.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/compose.rkt" "../value/shape.rkt" "../value/structure.rkt")

(provide canonical? compositional-canonical? canonical-H? canonical-K? qp-canonical?
         time-independent-canonical?
         T-func J-func Phi Phi* linear-function->multiplier
         multiplicative-transpose)

;; ---------------------------------------------------------------------------
;; Two Hamiltonians

;; ((canonical? C H H') state) : the residual, (up 0 (up 0 ...) (down 0 ...)) if it holds
(define (canonical? C H H-prime)
  (define checked (checked-transformation 'canonical? C))
  (check-Hamiltonian 'canonical? H)
  (check-Hamiltonian 'canonical? H-prime)
  (commutation (call-datum 'canonical? C H) checked
               (Hamiltonian->state-derivative H-prime) (Hamiltonian->state-derivative H)))

;; The same with the composition of H with C for the new Hamiltonian.
(define (compositional-canonical? C H)
  (composed-residual 'compositional-canonical? C H 1))

;; Without the clock (p. 348): the terms with the derivatives of H.
(define (canonical-H? C H) (composed-residual 'canonical-H? C H 0))

;; With H∘C for the new Hamiltonian, of which the derivatives are those of H at the old state, by
;; the chain rule: so H is differentiated once.  clock : the rate of the time, 0 or 1
(define (composed-residual who C H clock)
  (check-Hamiltonian who H)
  (define checked (checked-transformation who C))
  (define gradient (D H))
  (unary-function (call-datum who C H) (state)
    (define-values (image slopes) (image-and-slopes checked state))
    (void ((number-valued who H) image))
    (define DH (gradient image))
    (define new-rates
      (rates-of-state (for/list ([slope (in-list (cdr slopes))]) (g:* DH slope))))
    (define moved
      (for/fold ([sum (g:* clock (car slopes))])
                ([rate (in-list new-rates)] [slope (in-list (cdr slopes))])
        (g:+ sum (g:* rate slope))))
    (g:- (up clock (s:ref DH 2) (g:negate (s:ref DH 1))) moved)))

;; The derivatives by n coordinates and n momenta, in a list -> the rates of these coordinates and
;; momenta
(define (rates-of-state slopes)
  (define-values (by-q by-p) (split-at slopes (quotient (length slopes) 2)))
  (append by-p (map g:negate by-q)))

;; state ↦ old(C(state)) − DC new(state), for two fields of directions
(define (commutation datum C new old)
  (unary-function datum (state)
    (define-values (image moved) (value-and-derivative-along C state (new state)))
    (g:- (old image) moved)))

;; The terms without H (p. 348): K makes up for the time in C.
(define (canonical-K? C K)
  (define checked (checked-transformation 'canonical-K? C))
  (check-Hamiltonian 'canonical-K? K)
  (commutation (call-datum 'canonical-K? C K) checked (Hamiltonian->state-derivative K) T-func))

;; The terms with the derivatives of H, through J: a test of C although H occurs in it.
(define (qp-canonical? C H)
  (define checked (checked-transformation 'qp-canonical? C))
  (check-Hamiltonian 'qp-canonical? H)
  (define (direction H) (compose J-func (D H)))
  (commutation (call-datum 'qp-canonical? C H) checked
               (direction (compose H checked)) (direction H)))

;; ---------------------------------------------------------------------------
;; No Hamiltonian

;; ((time-independent-canonical? C) state) : J v − DC J (v DC) at a v of symbols (1st edition)
(define-printed (time-independent-canonical? C)
  (define who 'time-independent-canonical?)
  (define checked (checked-transformation who C))
  (lambda (state)
    (define slope ((D checked) state))
    (define v (unknown-gradient state (checked state)))
    (g:- (J-func v) (g:* slope (J-func (g:* v slope))))))

;; Symbols x0, x1, …, or, where C or the state is made of these, fresh symbols
(define (unknown-gradient state image)
  (define v (compatible-shape state))
  (define taken?
    (for*/or ([name (in-list (scalars v))] [x (in-list (scalars (up state image)))])
      (occurs? name x)))
  (if taken? (typical-object v) v))

;; ---------------------------------------------------------------------------
;; Linear functions of states

;; (1, 0, 0): the rate of a state of which only the time moves
(define (T-func state)
  (check-H-state 'T-func state)
  (up 1 (zero-like (coordinate state)) (zero-like (momentum state))))

;; The direction (0, c, −b) in which the gradient (a, b, c) of a Hamiltonian moves a state
(define (J-func gradient)
  (unless (and (down? gradient) (= (s:length gradient) 3))
    (complain-of-argument 'J-func "the derivative of a function of the state, (down a b c)"
                          gradient
                          (if (H-state? gradient)
                              "\n  of H at a state: (J-func ((D H) state))"
                              "")))
  (up 0 (s:ref gradient 2) (g:negate (s:ref gradient 1))))

;; v ↦ A v
(define (Phi A) (printed-function (Phi A) (v) (g:* A v)))

;; w ↦ w A
(define (Phi* A) (printed-function (Phi* A) (w) (g:* w A)))

;; The A by which the linear function F multiplies.
(define (linear-function->multiplier F argument) ((D F) argument))

;; (multiplicative-transpose w) : A ↦ the B with B w = w A
(define-printed (multiplicative-transpose w)
  (lambda (A)
    (linear-function->multiplier (Phi* A) w)))
