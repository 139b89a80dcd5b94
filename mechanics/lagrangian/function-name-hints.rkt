#lang racket/base
;; The name of a function as a hint, where nothing else tells a Lagrangian from an energy.
;;
;; Both are functions of a state, and a question about the one has an answer for the other, too:
;; so a name that says which of them it is deserves a remark, or a question back.

(require "../generic/describe.rkt")

(provide called-Lagrangian? called-Hamiltonian? named?)

;; L, L-pendulum, (L-pendulum ...), and a difference T - V; not Lagrangian->energy
(define (called-Lagrangian? f)
  (regexp-match? #rx"^[(]?(L|Lagrangian)($|[_0-9 ]|-[^>])|^[(]- [(]?T[-_0-9a-z]* [(]?V"
                 (value->text f)))

(define (called-Hamiltonian? f)
  (regexp-match? #rx"^[(]?(H|Hamiltonian)($|[_0-9 ]|-[^>])" (value->text f)))

(define (named? f) (not (eq? (value->datum f) '<function>)))
