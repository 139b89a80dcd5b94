#lang racket/base
;; Absolute values and signs, case by case: u ≥ 0, where |u| = u, and u < 0.
;;
;; Where sgn u occurs, u = 0 is a case of its own, for sgn 0 is 0: a symbol is then replaced by
;; its value there, if u is a line in it.  Nothing is concluded from values beside u = 0, since
;; something else may jump there, as sgn(u²), or there may be no values beside it.

(require "in-exponentials.rkt" "real-signs.rkt"
         "../assumption/assumption-set.rkt" "../assumption/narrowing.rkt"
         "../assumption/signs.rkt"
         "../expression/conjugate.rkt" "../expression/expression.rkt" "../expression/operation.rkt"
         "../expression/substitute.rkt" "../expression/symbols.rkt"
         "../simplify/domain-question.rkt" "../simplify/simplify-expression.rkt")

(provide sign-cases under-relation)

;; -> ((expression . assumptions) ...), the cases whose expressions have all to be zero; #f if e
;; holds no sign that can be decided so
(define (sign-cases e A)
  (define signed (append (applications-of op:abs e) (applications-of op:sgn e)))
  (define u (findf single-valued? (map of signed)))
  (define jumps? (and (member (make-node op:sgn (list u)) signed) #t))
  (define (beside sign signs)
    (define B (and (possible? signs) (under-relation A u signs)))
    (if B (list (cons (with-sign e u sign) B)) '()))
  (define (possible? signs) (not (eqv? 0 (bitwise-and signs (real-signs u A)))))
  (and u
       (append (beside 1 (if jumps? positive nonnegative))
               (beside -1 negative)
               (if (and jumps? (possible? zero)) (at-zero e u A) '()))))

(define (of n) (car (node-args n)))

;; -> a list of one case, or of none: where e has no value, or the assumptions do not hold
(define (at-zero e u A)
  (define place (zero-of-line u A))
  (define (there e) (if place (substitute-expression e (list place)) e))
  (with-handlers ([exn:fail:contract:divide-by-zero? (lambda (x) '())]
                  [exn:algebra:contradiction? (lambda (x) '())])
    (define (relation-there r)
      (relation (relation-datum r)
                (simplify-where (there (relation-expression r)) no-assumptions)
                (relation-signs r)))
    (define more
      (if place
          (map relation-there (assumptions-relations A))
          (list (relation #f u zero))))
    (list (cons (there (with-sign e u 0)) (add-relations A more (neutral-workspace))))))

;; -> (symbol . expression), where u is zero, if it is a line in a symbol with a number as its slope
(define (zero-of-line u A)
  (for/or ([x (in-list (symbols-in u))])
    (define (at value) (substitute-expression u (list (cons x value))))
    (with-handlers ([exn:fail:contract:divide-by-zero? (lambda (x) #f)])
      (define slope (simplify-where (e:- (at 1) (at 0)) A))
      (and (rational? slope)
           (not (eqv? slope 0))
           (eqv? 0 (simplify-where (e:- u (e:+ (at 0) (e:* slope x))) A))
           (cons x (simplify-where (e:/ (at 0) (- slope)) A))))))

;; The assumptions with one more, which has no datum; #f if they cannot hold together
(define (under-relation A u signs)
  (with-handlers ([exn:algebra:contradiction? (lambda (x) #f)])
    (add-relations A (list (relation #f u signs)) (neutral-workspace))))
