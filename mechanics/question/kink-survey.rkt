#lang racket/base
;; The kinks of a proposed path, and of the Lagrangian along it.
;;
;; A path must have a value at all times, and nothing in it may have a kink.  The kinks of a
;; Lagrangian are found at coordinates that are any numbers, and then put on the path: the root of
;; x² + y² has no kink where a path passes the origin, for there a potential 1/r has no value; the
;; root of x² has.

(require (only-in racket/list make-list)
         "../calculus/derivative.rkt"
         "../error/refusal.rkt"
         "../generic/on-demand.rkt" "../generic/up-down.rkt"
         (only-in "../hamiltonian/H-state.rkt" state->qp)
         "../lagrangian/local-tuple.rkt" "../lagrangian/total-derivative.rkt"
         "../value/shape.rkt" (only-in "../value/structure.rkt" structure->list)
         "../verdict/derivative-survey.rkt" "../verdict/question-domain.rkt")

(require-on-demand
 ["../constraint/constraint.rkt" gather]
 ["../constraint/constraint-jacobian.rkt" jacobian-rows])

(provide surveys-of-solution surveys-of-states domain-of-solution domain-of-states)

;; ---------------------------------------------------------------------------
;; Domains: time -> expressions that are to have a value there

(define ((domain-of-solution L q n force) t)
  (define local ((Gamma q (+ n 2)) t))
  (append (expressions-of (coordinate local)) (values-along (list L force) local)))

;; At a kink the path has coordinates and no velocity.  So whether the Lagrangian has a value there
;; is asked at the path's coordinates, with unknowns for the velocities.
(define (domain-beside-velocities L q n force t)
  (define local ((Gamma q (+ n 2)) t))
  (define rates (map unknowns-like (cddr (structure->list local))))
  (values-along (list L force) (apply up t (coordinate local) rates)))

(define ((domain-of-states H states force) t)
  (define state (states t))
  (append (expressions-of (state->qp state)) (values-along (list H force) state)))

;; ---------------------------------------------------------------------------
;; Surveys

;; q : a path                                 n : the order of the Lagrangian
;; force : #f, or the force outside L         constraints : #f, or as verify-solution has them
;; along : the residual, a function of time
(define (surveys-of-solution L q n force constraints along)
  (define t (string->uninterned-symbol "t"))
  (define position (coordinate ((Gamma q 2) t)))
  (define length (+ (* 2 n) 2))
  (surveys-along t position (path 'verify-solution q)
                 (apply up t (make-list (sub1 length) position))
                 (lambda () ((Gamma q length) t))
                 (lambda (state) (differentiate L n force constraints state))
                 along
                 (lambda () (domain-beside-velocities L q n force t))
                 (if (or force constraints) '() (list L))
                 (add1 n)))

;; states : time -> (up t q p); slope : state -> its derivative; along : the residual;
;; find-domain : time -> expressions
(define (surveys-of-states slope states along find-domain)
  (define t (string->uninterned-symbol "t"))
  (define state (states t))
  (surveys-along t state states state (lambda () state) slope along
                 (lambda () (find-domain t))
                 '()
                 2))

;; value : of the motion f at t; shape, local, derivatives : as survey-anywhere takes them;
;; along : the residual, a function of time; domain : -> expressions
;; functions : of a state of that shape, which (derivatives) differentiates so often
(define (surveys-along t value f shape local derivatives along domain functions order)
  (define (survey-at thunk values?)
    (define-values (_ survey)
      (survey-derivatives thunk (list t) #:have-values? values? #:domain domain
                          #:order (* 2 (sub1 order))))
    survey)
  (list (survey-of-values value)
        (survey-at (lambda () (derivative-at f t)) #t)
        (or (survey-anywhere t shape local derivatives domain functions order)
            (survey-at (lambda () (along t)) #f))))

;; A survey of f with symbols in place of all numbers of a state of this shape, where the numbers of
;; (local) are put in the end; #f if f fails at symbols.
(define (survey-anywhere t shape local f domain functions order)
  (define state (unknowns-like shape))
  (define-values (_ survey)
    (if-raised raised? (values #f #f)
      (survey-derivatives (lambda () (f state)) (scalars state)
                          #:put (lambda () (map cons (scalars state) (scalars (local))))
                          #:solve-for (list t)
                          #:domain domain
                          #:functions (lambda () (values-at functions state))
                          #:order order)))
  survey)

;; Takes the derivatives that are in Lagrange's equations.
(define (differentiate L n force constraints state)
  ((Euler-Lagrange-operator L #:order n) state)
  (when force (force ((clip-state (+ n 2)) state)))
  (when constraints
    (jacobian-rows 'verify-solution (gather 'verify-solution constraints) state)))
