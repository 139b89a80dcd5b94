#lang racket/base
;; From a path to the residual, every step in sight (SICM exercise 1.12).

(require "step-by-step.rkt"
         "../../calculus/derivative.rkt"
         "../../show/display/print-expression.rkt"
         (only-in "../../show/display/receiving-printer.rkt" receiver-here)
         "../../error/complain.rkt"
         "../../generic/define-plain.rkt" "../../generic/describe.rkt"
         "../../generic/elementary.rkt"
         "../../generic/function.rkt" "../../generic/on-demand.rkt"
         "../../generic/wrong-argument.rkt"
         "../../lagrangian/Lagrange-equations.rkt" "../../lagrangian/local-tuple.rkt"
         "../../value/compose.rkt" "../../value/simplify.rkt" "../../value/structure.rkt")

(require-on-demand
 ["../../force/d-Alembert.rkt" newtonian?]
 ["../../force/Newton-to-Lagrange.rkt" Newton-steps Newton-identities])

(provide derivation-steps show-derivation)

;; A list of (label . value): the local tuple, the Lagrangian along the path, its partial
;; derivatives there, the time derivatives of the momenta, the force and the residual; all
;; simplified.  A derivation from Newton's equations has identities, too, each with its verdict.
(define (derivation-steps equations q [t 't])
  (append (for/list ([s (in-list (steps 'derivation-steps equations q t))])
            (cons (car s) (simplify (cdr s))))
          (identities equations q)))

;; Prints the steps, each as `label at t`, then its value; in the end the assumptions of
;; simplification.
(define-plain (show-derivation given [q #f] [t 't] #:as [format #f])
  (cond [(derivation? given) (print-as 'show-derivation given format)]
        [(not q)
         (complain-of-arity 'show-derivation
                            "needs the path: (show-derivation (Lagrange-equations L) q)")]
        [(or format (receiver-here)) (print-as 'show-derivation (as-derivation given q t) format)]
        [else (print-steps given q t)]))

;; The steps as a value.  Each is checked: is the simplified value equal to the computed one?
(define (as-derivation equations q t)
  (derivation
   (append
    (for/list ([s (in-list (steps 'show-derivation equations q t))])
      (make-step (list (car s) t) (cdr s)))
    (for/list ([i (in-list (identities equations q))])
      (step (cadr (car i)) (caddr (car i)) (cdr i))))))

(define (print-steps equations q t)
  (define all (steps 'show-derivation equations q t))
  (define-values (values assumptions) (simplify/assumptions (list->up (map cdr all))))
  (for ([s (in-list all)] [v (in-list (structure->list values))])
    (print-labelled (list (car s) t) v))
  (print-assumptions assumptions)
  (for ([i (in-list (identities equations q))])
    (print-labelled (car i) (cdr i))))

(define (identities equations q)
  (if (equations? equations) '() (Newton-identities equations q)))

;; The steps as they are computed.
(define (steps who equations q t)
  (cond [(equations? equations) (Lagrange-steps who equations q t)]
        [(newtonian? equations) (Newton-steps who equations q t)]
        [else
         (complain-of-argument
          who "(Lagrange-equations L) or (d-Alembert-equations masses r F)" equations
          (if (pointwise? equations)
              (format "\n  of a Lagrangian: (~a (Lagrange-equations ~a) q)" who
                      (value->text equations))
              ""))]))

(define (Lagrange-steps who equations q t)
  (define L (equations-Lagrangian equations))
  (define n (equations-order equations))
  (define force (equations-force equations))
  (define local (Gamma (path who q) (+ n 2)))
  (define local-label (if (= n 1) '(Gamma q) `(Gamma q ,(+ n 2))))
  (define (step label f) (cons label (f t)))
  (define (along-label F) `(compose ,F ,local-label))
  (define (partial-label k) (along-label `((partial ,k) L)))
  (define (partial-along k) (compose ((partial k) L) local))
  (append
   (list (step local-label local)
         (step (along-label 'L) (compose L local)))
   (for/list ([k (in-range 1 (+ n 2))])
     (step (partial-label k) (partial-along k)))
   (for/list ([k (in-range 1 (add1 n))])
     (step (list (if (= k 1) 'D `(expt D ,k)) (partial-label (add1 k)))
           ((g:expt D k) (partial-along (add1 k)))))
   (if force (list (step (along-label 'force) (compose force local))) '())
   (list (step '((Lagrange-equations L) q) (equations q)))))
