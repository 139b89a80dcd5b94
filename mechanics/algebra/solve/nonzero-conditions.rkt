#lang racket/base
;; Conditions under which an expression is neither 0 nor infinite.
;;
;; None of its factors is 0.  That u is not 0 is (> (abs u) 0), a relation as `assume` takes it.

(require racket/list
         "factors.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt"
         "../simplify/known-sign.rkt" "../simplify/simplify-expression.rkt")

(provide nonzero-conditions factors-of not-zero positive)

;; -> datums, but for those of factors whose sign is known
(define (nonzero-conditions e A) (append-map (lambda (u) (not-zero u A)) (factors-of (list e) A)))

;; Bases of the factors of the expressions, but numbers
(define (factors-of es A [wanted? void])
  (remove-duplicates
   (for*/list ([e (in-list es)] [f (in-list (expression-factors e A))]
               #:unless (real? (car f))
               #:when (wanted? (car f)))
     (car f))))

(define (not-zero u A)
  (if (memv (known-sign u A) '(1 -1)) '() (list (positive (e:apply op:abs u) A))))

(define (positive u A) (list '> (expression->datum (simplify-expression u A)) 0))
