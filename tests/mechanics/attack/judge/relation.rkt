#lang racket/base
;; Relations between S-expressions, (>= a b) and its kin, at points.

(require "evaluate.rkt")

(provide all-hold? broken? relation-sides)

(define allowed (hasheq '> '(1) '>= '(0 1) '< '(-1) '<= '(-1 0)))

(define (sign-at r where A)
  (define v (value-at `(- ,(cadr r) ,(caddr r)) where A))
  (if (value? v) (or (sign-of v) 'unknown) 'unknown))

;; For certain?
(define (all-hold? relations where A)
  (for/and ([r (in-list relations)])
    (and (memv (sign-at r where A) (hash-ref allowed (car r))) #t)))

;; Does one of them certainly not hold?
(define (broken? relations where A)
  (for/or ([r (in-list relations)])
    (not (memv (sign-at r where A) (cons 'unknown (hash-ref allowed (car r)))))))

(define (relation-sides relations)
  (apply append (map cdr relations)))
