#lang racket/base
;; Questions whose answer says less than it seems to: a constant is conserved, a Lagrangian
;; that forgets its state has every path for a solution, and 't in a path of t is a constant.

(require "../algebra/expression/symbols.rkt"
         "../error/refusal.rkt"
         (only-in "../hamiltonian/H-state.rkt" state->qp)
         "../lagrangian/local-tuple.rkt"
         "../value/shape.rkt"
         "../verdict/question-domain.rkt")

(provide remarks-on-solution remarks-on-states remarks-on-quantity)

;; L : Lagrangian of order n; q : path -> list of strings
(define (remarks-on-solution L q n)
  (define t (string->uninterned-symbol "t"))
  (define local ((Gamma q (+ n 2)) t))
  (append (remarks-on-path t (coordinate local))
          (remarks-on-Lagrangian L local)))

;; states : time -> (up t q p)
(define (remarks-on-states H states)
  (define t (string->uninterned-symbol "t"))
  (define state (states t))
  (define anything (unknowns-like state))
  (append (remarks-on-path t (state->qp state))
          (if (depends? H anything)
              '()
              (list "the Hamiltonian is a constant: every state rests"))))

(define (remarks-on-path t position)
  (define es (expressions-of position))
  (define (speaks-of? s) (for/or ([e (in-list es)]) (occurs? s e)))
  (cond [(null? es) '()]
        [(speaks-of? t)
         (if (speaks-of? 't) (list "the symbol t in the path is a constant, not its argument") '())]
        [(speaks-of? 't)
         (list "the path does not depend on its argument; the symbol t in it is a constant")]
        [else (list "the path does not depend on the time")]))

(define (remarks-on-Lagrangian L local)
  (define state (unknowns-like local))
  (if (depends? L state)
      '()
      (list (string-append "the Lagrangian depends neither on time nor on coordinates nor on "
                           "velocities: every path solves its equations"))))

;; Q : a quantity, state : of symbols
(define (remarks-on-quantity Q state)
  (if (depends? Q state)
      '()
      (list "the quantity is a constant, whatever the motion")))

;; Does the value of f contain a symbol of the state?  If f fails at symbols, it counts as yes.
(define (depends? f state)
  (define value (if-raised raised? #f (f state)))
  (define es (if value (expressions-of value) '()))
  (or (null? es)
      (for*/or ([e (in-list es)] [s (in-list (scalars state))] #:when (symbol? s)) (occurs? s e))))
