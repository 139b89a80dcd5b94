#lang racket/base
;; Conditions imposed: the condition that a verdict names is made to hold in a value or a function.
;;
;; A symbol is replaced by its value wherever it stands (imposed-equations.rkt): in a function in
;; its value, in derivatives of the function in their parts.  Only the tape of a gradient holds
;; earlier values: a function is given symbols in their place, and its value at the symbols is
;; evaluated on the tape.

(require (only-in racket/list append-map)
         "imposed-equations.rkt"
         "../algebra/expression/expression.rkt"
         "../calculus/expression-function.rkt" "../calculus/perturbed-value.rkt"
         "../calculus/recorded-number.rkt"
         "../constraint/constraint.rkt"
         "../error/complain.rkt" "../error/note.rkt"
         "../generic/describe.rkt" "../generic/function.rkt" "../generic/kind.rkt"
         "../generic/wrong-argument.rkt"
         "../value/algebra.rkt" "../value/shape.rkt"
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

;; note! : called with what is replaced somewhere
(define (put replacements equations x [note! void])
  (define (at-leaf leaf)
    (cond [(symbolic? leaf) (replaced-noting leaf replacements note!)]
          [(perturbed? leaf) ((parts-map (parts-of leaf)) within leaf)]
          [(or (number? leaf) (other-number? leaf)) leaf]
          [(constraint? leaf)
           (define make (if (holonomic? leaf) holonomic nonholonomic))
           (make (within (constraint-function leaf)))]
          [(procedure? leaf) (function-under leaf within equations)]
          [(pair? leaf) (cons (within (car leaf)) (within (cdr leaf)))]
          [else leaf]))
  (define (within x) (map-leaves at-leaf x))
  (within x))

(define (replaced-noting e replacements note!)
  (for/fold ([e e]) ([r (in-list replacements)])
    (define new (replaced e (list r)))
    (unless (eq? new e) (note! (car r)))
    new))

;; within : value -> value with the condition imposed
(define (function-under f within equations)
  (make-function (lambda args
                   (if (ormap recorded? (append-map scalars args))
                       (value-on-tape f args within)
                       (within (apply f args))))
                 (arity-mask f)
                 (lambda () `(impose ,(value->datum f) ,(value->datum equations)))))

(define (value-on-tape f args within)
  (define point '())
  (define (symbol-for x)
    (define s (string->uninterned-symbol "x"))
    (set! point (cons (cons s x) point))
    s)
  (define symbols
    (map (lambda (a) (s:map/r symbol-for a)) args))
  (map-leaves (lambda (leaf) (if (symbolic? leaf) (evaluate-generically leaf point) leaf))
              (within (apply f symbols))))
