#lang racket/base
;; Constraints on a motion.
;;
;;   holonomic      G(t, q) = 0       on the coordinates
;;   nonholonomic   A(t, q, v) = 0    on the velocities, which enter linearly:
;;                                    A = a(t, q) v + b(t, q)
;;
;; The value of such a function is a number, or an up tuple of numbers if it states
;; several constraints.  Constraints may also come one by one, as a list or an up tuple.

(require "../calculus/derivative.rkt"
         "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/scalar.rkt"
         "../generic/up-down.rkt" "../generic/value-struct.rkt" "../generic/wrong-argument.rkt"
         (only-in "../lagrangian/Lagrange-equations.rkt" check-Lagrangian)
         "../value/shape.rkt"
         "../verdict/prove-zero.rkt" "../verdict/verdict.rkt")

(provide
 ;; for users
 holonomic nonholonomic constraint? holonomic? constraint-function
 ;; a set of them
 gather gather-with constraint-set-parts constraint-set-single?
 all-holonomic?
 value-of shape-values check-linear)

;; linear-at : coordinates for which A was found linear in the velocities, or #f
(value-struct constraint (kind function [linear-at #:mutable])
  #:datum constraint->datum)

(define (constraint->datum c)
  (list (constraint-kind c) (value->datum (constraint-function c))))

(define (holonomic? c) (eq? (constraint-kind c) 'holonomic))

;; ---------------------------------------------------------------------------
;; Making them

(define (holonomic G)
  (check-function 'holonomic G 2 "the time and the coordinates, (G t q)")
  (constraint 'holonomic G #f))

(define (nonholonomic A)
  (check-function 'nonholonomic A 3 "the time, the coordinates and the velocities, (A t q v)")
  (constraint 'nonholonomic A #f))

(define (check-function who f n arguments)
  (unless (and (of-functions? f) (accepts? f n))
    (complain who "expected a function of ~a\n  given: ~a~a" arguments
              (describe-with-value f)
              (if (of-functions? f)
                  (format ", which takes ~a~a" (arity->text f) (arity-hint who f))
                  ""))))

(define (arity-hint who f)
  (cond [(and (eq? who 'holonomic) (accepts? f 3))
         "\n  a constraint on the velocities is nonholonomic: (nonholonomic A)"]
        [(and (eq? who 'nonholonomic) (accepts? f 2))
         "\n  a constraint on the coordinates alone is holonomic: (holonomic G)"]
        [(accepts? f 1)
         "\n  the parts of the local tuple are arguments of their own; parameters come first"]
        [else ""]))

;; ---------------------------------------------------------------------------
;; Sets

;; parts : list of constraints; single? : was one given, and no list or tuple?
(struct constraint-set (parts single?)
  #:property prop:printed-datum (lambda (cs) (constraints->datum cs))
  #:authentic)

(define (gather who given)
  (cond [(constraint-set? given) given]
        [(constraint? given) (constraint-set (list given) #t)]
        [else
         (define parts (parts-of given))
         (unless (and parts (pair? parts) (andmap constraint? parts))
           (complain-of-argument who
                                 (string-append "a constraint, (holonomic G) or (nonholonomic A), "
                                                "or a list of them")
                                 given (instead-hint given)))
         (constraint-set parts #f)]))

(define (instead-hint given)
  (cond [(symbol? given)
         (format "\n  with its quote it is only a name; the constraint itself is ~a" given)]
        [(not (of-functions? given)) ""]
        [(accepts? given 2)
         "\n  (holonomic G) makes a constraint of a function of the time and the coordinates"]
        [(accepts? given 3)
         (string-append "\n  (nonholonomic A) makes a constraint of a function of the time, "
                        "the coordinates and the velocities")]
        [else ""]))

;; The set, for those who take a Lagrangian before it.
(define (gather-with who L constraints)
  (check-comes-first who (and (constraints? L) (not (constraints? constraints)))
                     "Lagrangian" "constraints")
  (check-Lagrangian who L)
  (gather who constraints))

(define (constraints? x)
  (define parts (if (constraint? x) (list x) (parts-of x)))
  (or (constraint-set? x) (and (pair? parts) (andmap constraint? parts))))

(define (parts-of given)
  (cond [(list? given) given]
        [(tuple? given) (vector->list (tuple-elements given))]
        [else #f]))

(define (constraints->datum cs)
  (define parts (constraint-set-parts cs))
  (if (constraint-set-single? cs) (car parts) (cons 'list parts)))

(define (all-holonomic? cs) (andmap holonomic? (constraint-set-parts cs)))

;; The value of one constraint.
(define (value-of who c t q v)
  (define f (constraint-function c))
  (define value (if (holonomic? c) (f t q) (f t q v)))
  (unless (andmap scalar? (scalars value))
    (complain who
              (string-append "the value of a constraint is a number, or an up tuple of numbers"
                             "\n  constraint: ~a\n  value: ~a")
              (value->text c) (describe-with-value value)))
  value)

;; values : one for each constraint
;; -> the value of the set: a single constraint's own value, or a tuple of the values of all
(define (shape-values cs values)
  (if (constraint-set-single? cs) (car values) (apply up values)))

;; ---------------------------------------------------------------------------
;; Linear in the velocities?

;; Asked at symbolic arguments, once for each shape of coordinates.
(define (check-linear who cs q)
  (for ([c (in-list (constraint-set-parts cs))])
    (unless (or (holonomic? c)
                (and (constraint-linear-at c) (same-shape? q (constraint-linear-at c))))
      (check-one-linear who c q)
      (set-constraint-linear-at! c q))))

(define (check-one-linear who c q)
  (define t (string->uninterned-symbol "t"))
  (define-values (at velocity) (values (symbols-like q "q") (symbols-like q "v")))
  (define (slope v)
    (derivative-at (lambda (v) (value-of who c t at v)) v))
  (define curvature (derivative-at slope velocity))
  (unless (andmap (lambda (x) (eqv? x 0)) (scalars curvature))
    (when (refuted? (prove-zero curvature))
      (complain who
                (string-append "a constraint must be linear in the velocities"
                               "\n  constraint: ~a\n  its value: ~a")
                (value->text c)
                (value->text (value-of who c 't at velocity))))))
