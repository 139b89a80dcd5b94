#lang racket/base
;; Simplification: to a canonical value, and from it to a readable expression,
;; under assumptions about signs.

(require (only-in "normalize.rkt" normal-field normal-fraction) "domain-question.rkt"
         "simplifier-workspace.rkt"
         "../assumption/assumption-set.rkt"
         (only-in "../assumption/ledger.rkt" question simplifier-grounds simplifier-revision)
         "../expression/expression.rkt"
         "../field/work-bounds.rkt")

(provide simplify-expression simplify-expression/assumptions simplify-where
         normal-form normal-form+simplified)

;; The work begins anew as long as there are revisions; each decides more signs.
;; e : the expression asked about
;; fuel : for all the work together, or #f: then each time anew
;; -> the result, and its grounds, as datums such as (>= R 0):
;; relations of A, and signs taken for granted
(define (work-under A e work [fuel #f])
  (define w (make-workspace A (question-about (list e) A) (or fuel (make-fuel))))
  (define result (work w))
  (define revised (simplifier-revision w))
  (if revised
      (work-under revised e work fuel)
      (values result (simplifier-grounds w))))

(define (simplify-expression e [A no-assumptions])
  (define-values (simple grounds) (simplify-expression/assumptions e A))
  simple)

;; The same where A holds, though e may have no real value there: √(x²y) was written |x| √y, and
;; that says nothing of y where x is 0.  Nothing is taken for granted.
(define (simplify-where e A)
  (define w (make-workspace (with-automatic-assumptions A #f) (question '() #f) (make-fuel)))
  (workspace-simplify w e))

;; -> the simplified expression and notes on it, as datums: its grounds,
;; such as (>= R 0), and (left-unexpanded e) if it is not in canonical
;; form because e would have grown too large.
(define (simplify-expression/assumptions e [A no-assumptions])
  (define-values (result grounds)
    (work-under A e
                (lambda (w)
                  (define simple (workspace-simplify w e))
                  (cons simple (workspace-left w)))))
  (values (car result) (append grounds (cdr result))))

;; -> the field of the expression's kernels, its value there, its grounds.
;; fuel : the cost allowed (field/work-bounds.rkt)
(define (normal-form e [A no-assumptions] [fuel (make-fuel)])
  (define-values (result grounds)
    (work-under A e
                (lambda (w) (workspace-normal w e))
                fuel))
  (values (normal-field result) (normal-fraction result) grounds))

;; -> the same, and the simplified expression.  The last value holds the notes
;; on it as well.
(define (normal-form+simplified e [A no-assumptions])
  (define-values (result grounds)
    (work-under A e
                (lambda (w)
                  (define n (workspace-normal w e))
                  (list n (if (node? e) (workspace-simplify w e) e) (workspace-left w)))))
  (define-values (n simple left) (apply values result))
  (values (normal-field n) (normal-fraction n) simple (append grounds left)))
