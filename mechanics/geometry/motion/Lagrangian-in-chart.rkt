#lang racket/base
;; One Lagrangian in several charts.
;;
;; A Lagrangian is written in some chart.  In another it is the same function of the motion, made
;; by the induced transformation of local tuples and simplified, so that singularities of the
;; first chart alone are gone.  Or it is written by hand for several charts; then its values must
;; agree where the motion goes over from one to another.

(require "chart-choice.rkt" "../manifold-chart.rkt" "../manifold-point.rkt"
         (only-in "../metric.rkt" metric?)
         "../../calculus/derivative.rkt" "../../calculus/expression-function.rkt"
         "../../error/complain.rkt" "../../error/refusal.rkt"
         "../../generic/arithmetic.rkt" "../../generic/up-down.rkt"
         "../../generic/wrong-argument.rkt"
         "../../lagrangian/coordinate-transformation.rkt" "../../lagrangian/local-tuple.rkt"
         "../../value/compose.rkt" "../../value/shape.rkt" "../../value/simplify.rkt")

(provide Lagrangian-in-chart Lagrangian-by-charts check-agreement
         transition momentum-at-home)

(define a-Lagrangian "a Lagrangian, a function of the local tuple")

;; L : a Lagrangian in the chart C -> in B
(define (Lagrangian-in-chart L C B)
  (define who 'Lagrangian-in-chart)
  (check-argument who procedure? L a-Lagrangian)
  (check-coordinate-system who C)
  (check-coordinate-system who B)
  (check-one-manifold who C B)
  (cond [(same-chart? C B) L]
        [else
         (define carried (compose L (F->C (transition B C))))
         (or (if-raised refusal? #f (as-formula carried B)) carried)]))

;; local tuple in B -> coordinates in C
(define ((transition B C) local)
  (coordinates-in C ((point B) (coordinate local))))

;; The function, simplified at symbols
(define (as-formula f B)
  (define q (typical-coords B))
  (define place (up (string->uninterned-symbol "t") q (symbols-like q "v")))
  (define e (simplify-always (f place)))
  (lambda (local) (evaluate-at e place local)))

;; ---------------------------------------------------------------------------
;; Written for several charts

;; L : a Lagrangian in the chart C, or a list of (list chart Lagrangian) -> chart -> Lagrangian
(define (Lagrangian-by-charts who L C)
  (when (metric? L)
    (complain-of-argument who a-Lagrangian L
                          "\n  that of a metric is (metric->Lagrangian g chart)"))
  (define given (if (list? L) L (list (list C L))))
  (for ([one (in-list given)])
    (unless (and (list? one) (= (length one) 2) (coordinate-system? (car one))
                 (procedure? (cadr one)))
      (complain-of-argument
       who (string-append a-Lagrangian ", or a list of (list chart Lagrangian)") L))
    (check-one-manifold who C (car one)))
  (when (null? given) (complain-of-argument who "a list of (list chart Lagrangian)" L))
  (once-a-chart
   (lambda (B)
     (define own (for/first ([one (in-list given)] #:when (same-chart? (car one) B)) (cadr one)))
     (or own (Lagrangian-in-chart (cadr (car given)) (car (car given)) B)))))

;; At the same state, given in both charts.  Both values have the size of the kinetic energy.
(define (check-agreement who L-in A at-A B at-B)
  (define a ((L-in A) at-A))
  (define b ((L-in B) at-B))
  (define size (g:* (((partial 2) (L-in A)) at-A) (velocity at-A)))
  (when (and (real? a) (real? b) (> (abs (- a b)) (* 1e-6 (+ (abs a) (abs b) (abs size)))))
    (complain-showing who (string-append "the Lagrangian is not the same in two charts: its values"
                                         " differ where the motion goes over from one to the other")
                      "time" (time at-A)
                      "chart" A "value" a
                      "chart" B "value" b)))

;; ---------------------------------------------------------------------------
;; Momenta are covariant: p_home = p ∂x/∂q, regular wherever the motion is.

;; L : in the chart B, local : there;  q : the coordinates at home
(define (momentum-at-home L B local home q)
  (define p (((partial 2) L) local))
  (if (same-chart? B home)
      p
      (g:* p ((D (lambda (q) (coordinates-in B ((point home) q)))) q))))
