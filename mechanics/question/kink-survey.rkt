#lang racket/base
;; What a proposed path, and the Lagrangian it is put into, have in the way of kinks.
;;
;; A path must have a value at all times, and nothing in it may have a kink.  A Lagrangian is
;; looked at where the coordinates are any numbers, and what is found then put on the path:
;; the root of x² + y² has no kink where a path passes the origin, for there a potential
;; 1/r has no value; the root of x² has.

(require "../calculus/derivative.rkt"
         "../error/refusal.rkt"
         "../generic/on-demand.rkt" "../generic/up-down.rkt"
         "../lagrangian/local-tuple.rkt" "../lagrangian/total-derivative.rkt"
         "../value/shape.rkt"
         "../verdict/smoothness.rkt")

(require-on-demand
 ["../constraint/constraint.rkt" gather]
 ["../constraint/linearized.rkt" jacobian-rows])

(provide surveys-of-solution surveys-of-states)

;; q : a path                                 n : the order of the Lagrangian
;; force : #f, or the force outside L         constraints : #f, or as verify-solution has them
;; along : the residual, a function of time
(define (surveys-of-solution L q n force constraints along)
  (define t (string->uninterned-symbol "t"))
  (define position (coordinate ((Gamma q 2) t)))
  (define length (+ (* 2 n) 2))
  (define-values (shape local)
    (values (apply up t (for/list ([_ (in-range 1 length)]) position))
            (lambda () ((Gamma q length) t))))
  (list (survey-of-values position)
        (survey-at t (lambda () (derivative-at (path 'verify-solution q) t)) #:have-values? #t)
        (or (survey-anywhere t shape local
                             (lambda (state) (differentiate L n force constraints state)))
            (survey-at t (lambda () (along t))))))

(define (survey-at t thunk #:have-values? [values? #f])
  (define-values (_ survey) (survey-derivatives thunk (list t) #:have-values? values?))
  survey)

;; states : time -> (up t q p); slope : state -> its derivative; along : the residual
(define (surveys-of-states slope states along)
  (define t (string->uninterned-symbol "t"))
  (define state (states t))
  (list (survey-of-values state)
        (survey-at t (lambda () (derivative-at states t)) #:have-values? #t)
        (or (survey-anywhere t state (lambda () state) slope)
            (survey-at t (lambda () (along t))))))

;; With symbols in place of all numbers of the state, which has this shape and which (local)
;; gives; #f if that is too much for f.
(define (survey-anywhere t shape local f)
  (define state (unknowns-like shape))
  (define-values (_ survey)
    (with-handlers ([raised? (lambda (e) (values #f #f))])
      (survey-derivatives (lambda () (f state)) (scalars state)
                          #:put (lambda () (map cons (scalars state) (scalars (local))))
                          #:solve-for (list t))))
  survey)

;; Takes the derivatives that are in Lagrange's equations.
(define (differentiate L n force constraints state)
  ((Euler-Lagrange-operator L #:order n) state)
  (when force (force ((clip-state (+ n 2)) state)))
  (when constraints
    (jacobian-rows 'verify-solution (gather 'verify-solution constraints)
                   (time state) (coordinate state) (velocity state))))
