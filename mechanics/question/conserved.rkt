#lang racket/base
;; Quantities along the motions of a Lagrangian: how fast do they change, and do
;; they at all?  (SICM 1.8)
;;
;; Along a motion the accelerations are a = M⁻¹ f, with M = ∂₂∂₂L and f the rest of
;; Lagrange's equations M a − f = 0, so that the rate of Q(t, q, v) is
;;
;;   Q̇ = ∂₀Q + ∂₁Q v + ∂₂Q a.
;;
;; For the quantities one asks about, M need not be inverted: ∂₂Q = w M with a w that
;; is known, and ∂₂Q a = w f.  Of a function of time and coordinates w is 0, of the
;; energy v, of a momentum a unit vector.
;;
;; Without an inverse of M several w may do, with rates that agree along motions only: if
;; one of the rates vanishes, Q is conserved; if none does, nothing is refuted.

(require "argument-order.rkt" "Hamiltonian-questions.rkt" "question-remarks.rkt"
         "regular-masses.rkt"
         "question-meaning.rkt"
         "../algebra/expression/expression.rkt"
         "../algebra/zero/vanishing.rkt"
         "../calculus/derivative.rkt" "../calculus/verdict-with-decimals.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/function-check.rkt"
         "../generic/function.rkt" "../generic/printed-function.rkt" "../generic/scalar.rkt"
         (only-in "../hamiltonian/known-Hamiltonians.rkt" declared-Hamiltonian?)
         (only-in "../hamiltonian/Hamiltonian.rkt" check-quantity)
         (only-in "../hamiltonian/classify-system.rkt" told-by-state?)
         "../lagrangian/external-force.rkt" "../lagrangian/generic-state.rkt"
         "../lagrangian/Lagrange-equations.rkt" "../lagrangian/local-tuple.rkt"
         "../lagrangian/state-derivative.rkt" "../lagrangian/total-derivative.rkt"
         "../value/assumptions.rkt" "../value/shape.rkt"
         "../value/structure.rkt"
         (only-in "../value/matrix/matrix.rkt" matrix-by-rows)
         "../verdict/derivative-survey.rkt" "../verdict/prove-zero.rkt"
         "../verdict/question-domain.rkt"
         "../verdict/verdict.rkt")

(provide rate-of-change verify-conserved
         ;; for certificates
         multipliers-of)

;; Does Q keep its value along every motion?  A verdict on its rate of change at a
;; local tuple (up t q v) of symbols, or at a state (up t q p) if L is a Hamiltonian.
(define (verify-conserved L Q local #:force [force #f])
  (check-order-of-arguments 'verify-conserved '(L Q local) (list L Q local))
  (check-Hamiltonian-first 'verify-conserved L Q)
  (if (told-by-state? 'verify-conserved L local)
      (conserved-by-Hamiltonian 'verify-conserved L Q local force)
      (conserved-by-Lagrangian L Q local force)))

(define (conserved-by-Lagrangian L Q local force)
  (check-arguments 'verify-conserved L Q)
  (define outside (external-force 'verify-conserved force #f))
  (check-generic-states 'verify-conserved local L Q outside)
  (define state (state-of local))
  (define (domain) (values-at (list L Q outside) state))
  (define (within) (values-at (list L outside) state)) ; motions cross poles of Q
  (define conditions '())
  (define (note-acceleration!) (set! conditions (regular-conditions (masses L state) state)))
  (define find-rate (rate 'verify-conserved L Q force note-acceleration!))
  (define-values (change survey)
    (survey-derivatives (lambda () (find-rate state)) (scalars state)
                        #:domain within #:functions domain))
  (define v
    (verdict-with-decimals
     (prove-zero change #:variables (scalars local) #:domain domain
                 #:surveys (list (survey-of-values (Q state)) survey) #:resting-on conditions
                 #:remarks (lambda () (append (remarks-on-quantity Q state) (remarks-on-kind L Q)
                                              (remarks-on-order L Q state)))
                 #:meaning (lambda () (meaning-of-quantity L Q state force))
                 #:about (conserved-claim L Q state outside #f)
                 #:again (lambda (change)
                           (verify-conserved (change L) (change Q) local
                                             #:force (and force (change force)))))
     (lambda () (Q state))))
  ;; a mass matrix without an inverse is refused: the state may be that of no motion
  (when (refuted? v)
    (call-with-quantity-last 'verify-conserved L Q state
                             (lambda () ((Lagrangian->acceleration L #:force force) state))))
  v)

;; The second derivatives by the velocities, as a matrix
(define (masses L state)
  (apply matrix-by-rows (mass-matrix (scalar-valued 'verify-conserved L) state 1)))

;; With one coordinate nothing tells a Hamiltonian from a Lagrangian.
(define (remarks-on-kind L Q)
  (if (eq? L Q)
      (list (string-append "it was taken for a Lagrangian; with (make-Hamiltonian H) "
                           "for H it is a Hamiltonian"))
      '()))

;; (t, q, v) ↦ Q̇, of the shape of Q's value; of a Hamiltonian (t, q, p) ↦ Q̇
(define (rate-of-change L Q #:force [force #f])
  (check-Hamiltonian-first 'rate-of-change L Q)
  (if (declared-Hamiltonian? L)
      (check-quantity 'rate-of-change Q)
      (check-arguments 'rate-of-change L Q))
  (define at (rate 'rate-of-change L Q force))
  (unary-function (apply call-datum 'rate-of-change L Q (force->datum force)) (local)
    (cond [(told-by-state? 'rate-of-change L local)
           ((rate-by-Hamiltonian 'rate-of-change L Q force) local)]
          [else
           (check-local-tuple 'rate-of-change local)
           (at (state-of local))])))

(define (state-of local) ((clip-state 3) local))

(define (check-arguments who L Q)
  (check-Lagrangian who L)
  (unless (takes-arguments? Q 1)
    (complain who "a quantity is a function of the local tuple (up t q v); given ~a~a"
              (describe-function Q)
              (if (and (procedure? L) (scalar? Q))
                  "\n  the Lagrangian comes first, then the quantity"
                  ""))))

;; ---------------------------------------------------------------------------
;; The rate at a state

;; note-acceleration! : called where the rate needs accelerations, and so an inverse of the masses
(define ((rate who L Q force [note-acceleration! void]) state)
  (call-with-quantity-last who L Q state
                           (lambda () (rate-at who L Q force state note-acceleration!))))

(define (rate-at who L Q force state note-acceleration!)
  (define L-scalar (scalar-valued who L))
  (let rate-of ([Q Q] [value (Q state)])
    (cond [(tuple? value)
           (s:generate (s:length value) (structure-orientation value)
                       (lambda (i)
                         (rate-of (lambda (local) (s:ref (Q local) i)) (s:ref value i))))]
          [else (scalar-rate who L-scalar Q force state note-acceleration!)])))

(define (scalar-rate who L Q force state note-acceleration!)
  (define v (velocity state))
  (define slope (((partial 2) Q) state))
  (define-values (value drift)
    (value-and-derivative-along Q state (up 1 v (g:* 0 v))))
  (define multipliers (multipliers-of L slope state))
  (define (with-acceleration)
    (note-acceleration!)
    (g:+ drift (g:* slope ((Lagrangian->acceleration L #:force force) state))))
  (cond [(null? multipliers) (with-acceleration)]
        [else
         (define f (applied-force who L force state))
         (define rates (for/list ([w (in-list multipliers)]) (g:+ drift (g:* f w))))
         (if (null? (cdr rates))
             (car rates)
             (or (findf vanishing? rates) (car rates)))]))

;; f = ∂₁L + force − ∂₀∂₂L − ∂₁∂₂L v, the negative of Lagrange's equations without accelerations.
(define (applied-force who L force state)
  (define-values (t q v) (state-parts state))
  (define inside (g:negate ((Euler-Lagrange-operator L) (up t q v (g:* 0 v)))))
  (if force
      (g:+ inside (force-like who inside ((external-force who force #f) state)))
      inside))

;; The simple multipliers w with slope = w M.
(define (multipliers-of L slope state)
  (define M (((partial 2) ((partial 2) L)) state))
  (for/list ([w (in-list (simple-multipliers (velocity state)))]
              #:when (vanishing? (g:- slope (g:* M w))))
    w))

;; Zero, the velocities, and the unit vectors.
(define (simple-multipliers v)
  (list* (g:* 0 v) v
         (for/list ([k (in-range (shape-length v))]) (unit-structure v k))))

(define (vanishing? x)
  (define A (assumptions-in-force))
  (for/and ([e (in-list (scalars x))]) (and (expression? e) (vanishes? e A))))
