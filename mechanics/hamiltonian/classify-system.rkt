#lang racket/base
;; Is a function a Hamiltonian or a Lagrangian, when a question is asked that both can answer?
;;
;; With several coordinates the state tells, if there is one: momenta are a down tuple.  So does
;; the function: one that takes (t, q, p) with a down tuple p and refuses velocities is a
;; Hamiltonian.  With one coordinate p and v are numbers; known to be Hamiltonians are then only
;; functions that were made as Hamiltonians (known-Hamiltonians.rkt), that are literal with a
;; signature of momenta, or that ask their state for its `momentum`.  A function that takes the
;; third part of its argument by a pattern tells nothing.

(require "H-state.rkt" "known-Hamiltonians.rkt"
         "../calculus/literal-function.rkt"
         "../error/complain.rkt" "../error/refusal.rkt"
         "../generic/describe.rkt" "../generic/function-check.rkt" "../generic/up-down.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/shape.rkt" (only-in "../value/structure.rkt" flip ref s:length))

(provide Hamiltonian-told? told-by-state?)

;; q : coordinates
(define (Hamiltonian-told? f q)
  (or (declared-Hamiltonian? f)
      (and (takes-arguments? f 1)
           (if (literal-function? f) (literal-takes-momenta? f q) (takes-momenta? f q)))))

;; state : the state of the question; one that leaves it open is refused where its third part is
;; named like a momentum
(define (told-by-state? who f state)
  (cond [(state-of-momenta? state) #t]
        [(or (not (has-velocities? state)) (tuple? (coordinate state))) (declared-Hamiltonian? f)]
        [(Hamiltonian-told? f (coordinate state)) #t]
        [else
         (when (open? state) (raise-open who f state))
         #f]))

(define (has-velocities? state)
  (and (local-tuple? state) (> (s:length state) 2)))

;; ---------------------------------------------------------------------------
;; By the function's arguments

(define (literal-takes-momenta? f q)
  (define (takes? third) (literal-function-takes? f (list (up 't q third))))
  (if (tuple? q)
      (and (takes? (flip q)) (not (takes? q)))
      (and (takes? (down 'p)) (not (takes? (up 'v))))))

;; f may fail at symbols; whether it asked for the momentum before it failed tells nevertheless.
(define (takes-momenta? f q)
  (define state (unknowns-like (up 't q (if (tuple? q) (flip (adopt q)) q))))
  (define value #f)
  (define asked?
    (asked-for-momentum? state (lambda () (set! value (if-raised raised? #f (f state))))))
  (or asked?
      (and (tuple? q) value (not (if-raised raised? #f (f (unknowns-like (up 't q q))))))))

;; ---------------------------------------------------------------------------
;; States that leave it open

;; (up t q p), with one coordinate
(define (open? state)
  (define third (ref state 2))
  (and (symbol? third) (regexp-match? #rx"^p([_^0-9].*)?$" (symbol->string third))))

(define (raise-open who f state)
  (complain who
            (string-append
             "with one coordinate nothing tells a Hamiltonian from a Lagrangian, and the "
             "third part of the state is named like a momentum"
             "\n  given: ~a at ~a"
             "\n  a Hamiltonian is made known by (make-Hamiltonian ~a)"
             "\n  of a Lagrangian, give the velocity another name")
            (value->text f) (value->text state) (value->text f)))
