#lang racket/base
;; Names that scmutils has for what `mechanics` calls otherwise.

(require "error/uncompiled.rkt")
(tell-if-uncompiled)

(require (for-syntax racket/base
                     (only-in racket/list append-map partition)
                     "lang/unknown-name/scmutils-names.rkt")
         "calculus/derivative.rkt" "calculus/literal-function.rkt"
         (only-in "canonical/on-demand.rkt" Phi*)
         "show/display/print-expression.rkt"
         (only-in "hamiltonian/H-state.rkt" momentum)
         (only-in "hamiltonian/on-demand.rkt" Hamiltonian->state-derivative)
         "lagrangian/coordinate-transformation.rkt"
         (only-in "lagrangian/local-tuple.rkt" Gamma ->local time coordinate velocity acceleration)
         (only-in "lagrangian/on-demand.rkt" Rx Ry Rz)
         "lagrangian/state-derivative.rkt" "lagrangian/total-derivative.rkt"
         "lang/scmutils-procedures.rkt"
         (only-in "numeric/constants.rkt" golden-ratio)
         (only-in "pendulum/on-demand.rkt" Hpendulum)
         (only-in "rigid/on-demand.rkt" rotate-x-matrix rotate-y-matrix rotate-z-matrix
                  angle-axis->rotation-matrix)
         "value/compose.rkt" "value/rewrite.rkt" "value/structure.rkt"
         "value/matrix/linear-algebra.rkt" "value/matrix/matrix.rkt")

(define-syntax (provide-replacements here)
  (define-values (renamed defined) (partition (lambda (r) (symbol? (car r))) replacements))
  (datum->syntax
   here
   `(provide (rename-out ,@(for*/list ([r (in-list renamed)] [name (in-list (cdr r))])
                             (list (car r) name)))
             ,@(append-map cdr defined))))

(provide-replacements)
