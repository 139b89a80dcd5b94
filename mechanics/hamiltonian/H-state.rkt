#lang racket/base
;; Hamiltonian states (t, q, p): the time, the coordinates and the momenta (SICM 3.1).
;;
;; The momenta are of the opposite orientation to the coordinates: p contracts with q̇ to a
;; number.  With one coordinate both are numbers, and nothing in the state tells it from a
;; local tuple (t, q, v).

(require (only-in "../calculus/literal-function.rkt" literal-down literal-up)
         "../error/complain.rkt" "../error/hint.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/scalar.rkt"
         "../generic/up-down.rkt" "../generic/wrong-argument.rkt"
         "../lagrangian/local-tuple.rkt"
         (only-in "../value/structure.rkt" flip s:dimension s:length s:map/r))

(provide ->H-state H-state? compatible-H-state?
         momentum momenta state->qp
         literal-Hamiltonian-state degrees-of-freedom
         ;; for the functions of states
         check-H-state check-state-like state-of-momenta? asked-for-momentum?)

(define (->H-state t q p) (up t q p))

;; Is x a triple whose momenta are dual to its coordinates?
(define (H-state? x)
  (and (triple? x) (scalar? (time x)) (dual? (coordinate x) (structure-ref x 2))))
(define compatible-H-state? H-state?)

;; Does x say that it has momenta?  With one coordinate that is not a tuple nothing says so.
(define (state-of-momenta? x) (and (H-state? x) (tuple? (coordinate x))))

(define (triple? x) (and (up? x) (= (s:length x) 3)))

(define (dual? q p)
  (if (tuple? q)
      (and (tuple? p) (same-shape? (flip q) p))
      (and (scalar? q) (scalar? p))))

;; ---------------------------------------------------------------------------
;; Taking apart

(define (momentum state)
  (note-asked! state)
  (unless (and (up? state) (> (s:length state) 2))
    (complain-of-argument 'momentum "a Hamiltonian state (up t q p)" state
                          (if (pointwise? state)
                              (string-append
                               (value-first-hint 'momentum)
                               "\n  the momenta of a Lagrangian L are ((partial 2) L)")
                              (list-hint state "(up t q p)"))))
  (define-values (q p) (values (structure-ref state 1) (structure-ref state 2)))
  (when (and (tuple? q) (tuple? p) (same-shape? q p)) (raise-not-dual 'momentum q p))
  p)

(define momenta momentum)

;; Is this very state asked for its momentum while the thunk runs?
(define (asked-for-momentum? state thunk)
  (define noted (watch state #f))
  (parameterize ([watched noted]) (thunk))
  (watch-asked? noted))

(struct watch (state [asked? #:mutable]) #:authentic)
(define watched (make-parameter #f))

(define (note-asked! state)
  (define w (watched))
  (when (and w (eq? state (watch-state w))) (set-watch-asked?! w #t)))

;; (up q p)
(define (state->qp state)
  (check-H-state 'state->qp state)
  (up (coordinate state) (structure-ref state 2)))

(define (degrees-of-freedom state)
  (check-H-state 'degrees-of-freedom state)
  (s:dimension (coordinate state)))

;; A state of n coordinates with components q^i and p_i; of one, q and p.
(define (literal-Hamiltonian-state n)
  (check-argument 'literal-Hamiltonian-state exact-positive-integer? n
                  "a number of coordinates, at least 1")
  (if (= n 1) (up 't 'q 'p) (up 't (literal-up 'q n) (literal-down 'p n))))

;; ---------------------------------------------------------------------------
;; Bad states

(define (check-H-state who state)
  (unless (triple? state)
    (complain-of-argument who "a Hamiltonian state (up t q p)" state
                          (list-hint state "(up t q p)")))
  (define-values (q p) (values (structure-ref state 1) (structure-ref state 2)))
  (unless (dual? q p) (raise-not-dual who q p)))

;; The state must have the shape of model.
(define (check-state-like who model state)
  (check-H-state who state)
  (unless (same-shape? state model)
    (complain who "expected a state like ~a; given ~a" (value->text model) (value->text state))))

(define (raise-not-dual who q p)
  (complain who "~a\n  coordinates: ~a\n  in their place: ~a~a"
            "the third part of a Hamiltonian state is the momenta, dual to the coordinates"
            (value->text q) (value->text p) (remedy q p)))

(define (remedy q p)
  (define (dual-like) (value->text (s:map/r (lambda (x) 'p) (flip q))))
  (cond [(not (tuple? q)) ""]
        [(pair? p) (list-hint p (dual-like))]
        [(and (tuple? p) (not (= (s:dimension q) (s:dimension p))))
         (format "\n  there are ~a coordinates and ~a momenta" (s:dimension q) (s:dimension p))]
        [(same-shape? q p)
         (format "\n  momenta are written ~a; velocities belong to a Lagrangian"
                 (value->text (flip p)))]
        [else (format "\n  momenta are written like ~a" (dual-like))]))
