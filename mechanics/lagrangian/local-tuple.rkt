#lang racket/base
;; Local tuples (t, q, q̇, ...) and the paths they come from.
;;
;; Γ[q](t) = (t, q(t), Dq(t), ...) is all that the Lagrangian knows of a path (SICM 1.4).
;; Paths and selectors are functions of the arithmetic, so that they compose with D and with
;; each other.

(require "several-paths.rkt"
         "../calculus/derivative.rkt" (only-in "../calculus/literal-function.rkt" literal-up)
         "../error/complain.rkt" "../error/hint.rkt"
         "../generic/describe.rkt" "../generic/function-check.rkt" "../generic/function.rkt"
         "../generic/scalar.rkt" "../generic/wrong-argument.rkt"
         "../value/structure.rkt")

(provide
 Gamma path state-parts
 ->local local-tuple?

 time coordinate velocity acceleration
 coordinates velocities accelerations
 literal-Lagrangian-state
 check-local-length
 ;; for the parts of other states
 value-first-hint)

;; ---------------------------------------------------------------------------
;; Paths to local tuples

;; (Gamma q) is t ↦ (t, q(t), Dq(t)); (Gamma q n) has n components.
(define (Gamma given-q [n 3])
  (define q (path 'Gamma given-q))
  (unless (and (exact-integer? n) (>= n 2))
    (complain-of-argument 'Gamma "the length of the local tuples, an integer of at least 2" n
                          (if (pointwise? n) (one-path-hint (list q n) along) "")))
  (define (name) (list* 'Gamma (value->datum q) (if (= n 3) '() (list n))))
  (unary-function name (t)
    (check-time-of-path 'Gamma q t along)
    (list->up (cons t (derivatives-at q t (- n 2))))))

(define (along path) (format "(Gamma ~a)" path))

;; q, known to be a path; a Racket vector counts as a tuple.
(define (path who q)
  (cond [(tuple? q) (tuple-of-paths who (adopt q) q)]
        [(takes-arguments? q 1) q]
        [else (raise-no-path who q (path-hint q))]))

;; A tuple whose components, all the way down, are paths.
(define (tuple-of-paths who q whole)
  (for ([f (in-vector (structure-elements q))] [i (in-naturals)])
    (cond [(tuple? f) (tuple-of-paths who (adopt f) whole)]
          [(not (takes-arguments? f 1))
           (raise-no-path who whole (component-hint i f))]))
  q)

(define (raise-no-path who q hint)
  (complain who "a path is a function of time, or a tuple of such functions; given ~a~a"
            (describe-with-value q) hint))

(define (path-hint q)
  (cond [(symbol? q) (format "\n  (literal-function '~a) makes a path of that name" q)]
        [(pair? q) (list-hint q)]
        [(scalar? q) "\n  a path is written (lambda (t) ...), with t where the time stands"]
        [(procedure? q)
         (format "\n  a path takes one argument, the time; this takes ~a" (arity->text q))]
        [else ""]))

(define (component-hint i f)
  (format "\n  its component ~a is ~a~a" i (describe-with-value f)
          (cond [(procedure? f) (path-hint f)]
                [(scalar? f)
                 (format "; a constant path is (lambda (t) ~a)"
                         (if (symbol? f) (format "'~a" f) (value->text f)))]
                [else ""])))

;; ---------------------------------------------------------------------------
;; Building and taking apart

(define (->local t q . derivatives) (apply up t q derivatives))

(define (local-tuple? x)
  (and (up? x) (>= (s:length x) 2)))

(define (check-local-length who local least)
  (unless (and (local-tuple? local) (>= (s:length local) least))
    (complain who "expected a local tuple (up t q v ...)~a; given ~a"
              (if (<= least 3) "" (format " of at least ~a components" least))
              (describe-with-value local))))

(define-syntax-rule (define-selector name index what)
  (define (name local) (select 'name local index what)))

(define (select who local i what)
  (unless (and (up? local) (< i (s:length local)))
    (complain who "expected a local tuple (up t q v ...) with ~a; given ~a~a"
              what (describe-with-value local)
              (cond [(pointwise? local)
                     (string-append (value-first-hint who) (if (eq? who 'time) timing-hint ""))]
                    [(eq? who 'time) (string-append timing-hint Racket-timing-hint)]
                    [else (list-hint local "(up t q v ...)")])))
  (vector-ref (structure-elements (adopt local)) i))

;; For a path of local tuples, or a trajectory.
(define (value-first-hint who)
  (format "\n  of a function f of the time it is asked at a time: (~a (f t))" who))

(define timing-hint
  "\n  time is the book's selector; (show-time expression) tells how long one takes")

(define Racket-timing-hint
  (string-append
   "\n  Racket's form for timing an expression is in racket/base under the same name: "
   "(require (only-in racket/base [time racket:time]))"))

(define-selector time 0 "the time")
(define-selector coordinate 1 "coordinates")
(define-selector velocity 2 "velocities")
(define-selector acceleration 3 "accelerations")

(define coordinates coordinate)
(define velocities velocity)
(define accelerations acceleration)
;; -> time, coordinates, velocities
(define (state-parts local) (values (time local) (coordinate local) (velocity local)))

;; A local tuple of n coordinates with components named after `name`.
(define (literal-Lagrangian-state n)
  (check-argument 'literal-Lagrangian-state exact-positive-integer? n
                  "a number of coordinates, at least 1")
  (define (tuple name) (if (= n 1) name (literal-up name n)))
  (up 't (tuple 'q) (tuple 'qdot)))
