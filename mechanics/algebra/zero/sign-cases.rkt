#lang racket/base
;; Absolute values and signs, case by case: u > 0, where |u| = u and sgn u = 1, and u < 0.
;;
;; Where u is a rational function of symbols, sines and exponentials it is zero nowhere but on a set
;; without interior, so what is continuous is zero there as well if it is zero beside it.  sgn u is
;; not: with it u = 0 is a case of its own, and u has to be a symbol.

(require racket/list
         "in-exponentials.rkt" "real-signs.rkt"
         "../assumption/assumption-set.rkt" "../assumption/narrowing.rkt"
         "../assumption/signs.rkt"
         "../expression/conjugate.rkt" "../expression/expression.rkt" "../expression/operation.rkt"
         "../expression/substitute.rkt"
         "../simplify/domain-question.rkt")

(provide sign-cases under-relation)

;; -> ((expression . assumptions) ...), the cases whose expressions have all to be zero; #f if e holds
;; no sign that can be decided so
(define (sign-cases e A)
  (define signed (append (applications-of op:abs e) (applications-of op:sgn e)))
  (define (jumps? u) (and (memf (lambda (n) (and (eq? (node-head n) op:sgn) (equal? (of n) u))) signed) #t))
  (define u (findf (lambda (u) (and (single-valued? u) (or (symbol? u) (not (jumps? u)))))
                   (map of signed)))
  (define (beside sign signs)
    (define B (and (not (eqv? 0 (bitwise-and signs (real-signs u A)))) (under-relation A u signs)))
    (if B (list (cons (with-sign e u sign) B)) '()))
  (and u
       (append (beside 1 positive)
               (beside -1 negative)
               (if (jumps? u) (list (cons (at-zero e u) A)) '()))))

(define (of n) (car (node-args n)))

(define (with-sign e u sign)
  (substitute-expression e (list (cons (make-node op:abs (list u)) (e:* sign u))
                                 (cons (make-node op:sgn (list u)) sign))))

(define (at-zero e u) (substitute-expression (with-sign e u 0) (list (cons u 0))))

;; The assumptions with one more, which has no datum; #f if they cannot hold together
(define (under-relation A u signs)
  (with-handlers ([exn:algebra:contradiction? (lambda (x) #f)])
    (add-relations A (list (relation #f u signs)) (neutral-workspace))))
