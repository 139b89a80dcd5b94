#lang racket/base
;; Expanding: products and powers of sums multiplied out, to one sum of terms.
;;
;; Only sums as written are multiplied out: sin² + cos² remains two terms.
;; So sines and cosines are veiled before the normal form is found, as functions
;; nobody knows anything of, and unveiled after.  A term keeps only those sums
;; below it that it needs.

(require racket/list
         (only-in "../assumption/assumption-set.rkt" no-assumptions)
         "../expression/expression.rkt" "../expression/operation.rkt"
         "../field/field.rkt"
         "../polynomial/fraction.rkt"
         "../presentation/form.rkt" "../presentation/fraction-pieces.rkt"
         "../presentation/present.rkt" "../presentation/term.rkt"
         "../simplify/simplify-expression.rkt")

(provide expand-expression)

;; -> expression and assumptions
(define (expand-expression e [A no-assumptions])
  (define-values (veiled assumed) (veil e A))
  (define-values (F f assumptions) (normal-form veiled A))
  (values (unveil (form-expression (expanded-form F f)))
          (append assumed assumptions)))

;; ---------------------------------------------------------------------------
;; The sum

(define (expanded-form F f)
  (define-values (as-one _by-roots by-factors) (fraction->piece-lists F f))
  ;; Where nothing divides, the split would only write squares of roots as sums again.
  (define pieces (if (fraction-polynomial? f) as-one by-factors))
  (define-values (whole others) (partition (lambda (p) (null? (piece-factors p))) pieces))
  (define terms (append-map (lambda (p) (piece-terms F p)) whole))
  (sum-form (append (for/list ([t (in-list (constant-first terms))])
                      (term-form t (field-inexact? F)))
                    (append-map (lambda (p) (quotient-forms F p)) others))))

(define (piece-terms F p)
  (multiply-terms (poly->terms F (piece-numerator p) summands) (collect-powers (piece-powers p))))

(define (quotient-forms F p)
  (define divisors
    (for/list ([h (in-list (piece-factors p))])
      (cons (expanded-form F (fraction-from-poly (field-ring F) (car h))) (cdr h))))
  (for/list ([t (in-list (constant-first (piece-terms F p)))])
    (product-form (term-coefficient t) (term-powers t) '() divisors (field-inexact? F))))

;; ---------------------------------------------------------------------------
;; Veils

(define veils
  (for/list ([op (in-list functions-of-angles)])
    (cons op (make-literal-head (string->uninterned-symbol (symbol->string (operation-name op)))))))

;; -> e with veiled functions, their arguments and those of roots simplified, and
;; the assumptions made.
(define (veil e A)
  (define assumptions '())
  (define (simplified n)
    (define-values (simple assumed) (simplify-expression/assumptions n A))
    (set! assumptions (append assumptions assumed))
    simple)
  (define memo (make-memo))
  ;; simple? : is e part of something simplified?
  (define (walk e simple?)
    (cond [(not (node? e)) e]
          [(arithmetic-node? e) (memo e (lambda () (rebuilt e simple?)))]
          [(not simple?) (memo e (lambda () (walk (simplified e) #t)))]
          [(assq (node-head e) veils)
           => (lambda (v) (make-node (cdr v) (node-args e)))]
          [(memq (node-head e) (list op:sqrt op:expt)) (rebuilt e simple?)]
          [else e]))
  (define (rebuilt e simple?)
    (make-node (node-head e) (for/list ([a (in-list (node-args e))]) (walk a simple?))))
  (values (walk e #f) assumptions))

(define (unveil e)
  (node-fold e values
             (lambda (n args)
               (define veil (findf (lambda (v) (eq? (cdr v) (node-head n))) veils))
               (make-node (if veil (car veil) (node-head n)) args))))
