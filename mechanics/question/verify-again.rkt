#lang racket/base
;; The question of a verdict asked again, with a condition imposed on its matter.

(require (only-in racket/list append-map count remove-duplicates)
         "imposed-equations.rkt" "impose.rkt"
         "../algebra/expression/symbols.rkt"
         "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/wrong-argument.rkt"
         "../value/assumptions.rkt" "../value/shape.rkt"
         "../verdict/verdict.rkt")

(provide verify-again)

;; The verdict on the question of v under the condition, by default the one that v tells.
(define (verify-again v [condition v])
  (check-verdict v condition)
  (define equations (equations-of 'verify-again condition))
  (define replacements (solved 'verify-again equations))
  (define met (make-hasheq))
  (define (change x)
    (put replacements equations x (lambda (replaced) (hash-set! met replaced #t))))
  (define again
    (call-assuming (known-relations (map change (verdict-given v)))
                   (lambda () ((verdict-question v) change))
                   'verify-again))
  (unless (eq? condition v) (check-met v equations replacements met))
  (with-remark again
               (string-append "under the condition " (equations->text equations)
                              (choices->text equations replacements))))

(define (check-verdict v condition)
  (unless (verdict? v)
    (if (verdict? condition)
        (complain 'verify-again
                  "the verdict comes first, then the condition: (verify-again v '(= k m))")
        (complain-of-argument 'verify-again "a verdict, then perhaps a condition" v))))

;; met : those symbols that were replaced in the question.  Others may stand in another
;; equation.
(define (check-met v equations replacements met)
  (define (linked? s)
    (> (count (lambda (q) (or (occurs? s (cadr q)) (occurs? s (caddr q)))) equations) 1))
  (for ([r (in-list replacements)])
    (define s (car r))
    (unless (or (not (symbol? s)) (hash-ref met s #f) (linked? s))
      (complain 'verify-again
                (string-append "the symbol ~a does not occur in what was asked, so that the "
                               "condition changes nothing\n  symbols of the residual: ~a")
                s (value->text (residual-symbols v))))))

(define (residual-symbols v)
  (remove-duplicates
   (append-map symbols-in (scalars (verdict-residual v)))))

;; The relations that do not hold as they stand, between numbers.
(define (known-relations relations)
  (define (holds? r)
    (define compare (case (car r) [(>) >] [(>=) >=] [(<) <] [else <=]))
    (and (number? (cadr r)) (number? (caddr r)) (compare (cadr r) (caddr r))))
  (filter (lambda (r) (not (holds? r))) relations))
