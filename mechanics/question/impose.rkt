#lang racket/base
;; Conditions imposed: the condition that a verdict names is made to hold in a value or a function.
;;
;; A symbol is replaced by its value wherever it stands (imposed-equations.rkt), in a function in
;; its values (calculus/changed-values.rkt).

(require "imposed-equations.rkt"
         "../algebra/expression/expression.rkt"
         "../calculus/changed-values.rkt"
         "../constraint/constraint.rkt"
         "../error/complain.rkt" "../error/note.rkt"
         "../generic/describe.rkt" "../generic/kind.rkt"
         "../generic/wrong-argument.rkt"
         "../value/algebra.rkt"
         "../verdict/verdict.rkt")

(provide impose
         ;; for those who ask again
         put)

;; x : a value, a function, a constraint, or a list of these
;; condition : an equation, a list of them, or a verdict, whose first choice it is
(define (impose x condition)
  (define equations (equations-of 'impose condition x))
  (check-thing x)
  (define replacements (solved 'impose equations))
  (define choices (choices->text equations replacements))
  (unless (equal? choices "")
    (note-once (format "impose: ~a~a" (equations->text equations) choices)))
  (put replacements equations x))

(define (check-thing x)
  (cond [(verdict? x)
         (complain 'impose "a verdict's question is asked again by (verify-again v condition)")]
        [(or (expression? x) (has-kind? x) (vector? x) (procedure? x) (constraint? x)
             (list? x))
         (void)]
        [else
         (complain-of-argument 'impose "a value, a function or a constraint" x)]))

;; note! : called with each expression that is replaced somewhere
(define (put replacements equations x [note! void])
  (change-values x
                 (lambda (e) (if (symbolic? e) (replaced-noting e replacements note!) e))
                 (lambda (f) `(impose ,(value->datum f) ,(value->datum equations)))
                 (lambda (leaf within)
                   (cond [(constraint? leaf)
                          (define make (if (holonomic? leaf) holonomic nonholonomic))
                          (make (within (constraint-function leaf)))]
                         [else leaf]))))

(define (replaced-noting e replacements note!)
  (for/fold ([e e]) ([r (in-list replacements)])
    (define new (replaced e (list r)))
    (unless (eq? new e) (note! (car r)))
    new))
