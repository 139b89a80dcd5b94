#lang racket/base
;; Proofs that rest on numbers being real.
;;
;; The canonical form treats √A as any of its two values and log u as any of its branches.  Of real
;; numbers more is true, and here it is used, one step upon the other:
;;
;; - |u| and sgn u are decided case by case (sign-cases.rkt);
;; - a sum of logarithms, or of arcs, vanishes if a product does not differ from 1
;;   (inverse-functions.rkt);
;; - P + √A vanishes if P² = A, and P is not positive (real-signs.rkt).
;;
;; A proof holds wherever all parts of the expression are real and the assumptions hold; nothing is
;; taken for granted.  Where that is, the expression tells as it was asked: a simplified one may
;; have no value at some of these points.

(require racket/list
         "inverse-functions.rkt" "real-signs.rkt" "sign-cases.rkt"
         "../assumption/assumption-set.rkt" "../assumption/signs.rkt"
         "../expression/conjugate.rkt" "../expression/expression.rkt"
         "../expression/operation.rkt" "../expression/size.rkt"
         "../simplify/domain-question.rkt" "../simplify/simplify-expression.rkt")

(provide prove-among-reals)

;; Steps upon each other, all steps together, and nodes of an expression that is looked at
(define most-depth 5)
(define most-steps 40)
(define most-nodes 400)

;; -> is e proved to be zero, under A and wherever it is real?
(define (prove-among-reals e A)
  (define steps (box most-steps))
  (and (worthwhile? e)
       (zero-among-reals? (in-logarithms e) (with-domain-of e (with-automatic-assumptions A #f))
                          most-depth steps)))

(define (worthwhile? e)
  (and (pair? (append-map (lambda (head) (applications-of head e)) real-heads))
       (all-leaves? (lambda (x) (or (symbol? x) (and (real? x) (exact? x)))) e)))

(define real-heads
  (list op:abs op:sgn op:sqrt op:log op:atan op:asin op:acos op:asinh op:acosh op:atanh))

(define (with-domain-of e A) (or (domain-assumptions (list e) A) A))

(define (zero-among-reals? e A depth steps)
  (set-box! steps (- (unbox steps) 1))
  (and (>= (unbox steps) 0)
       (let ([simple (simplify-where e A)])
         (define (again e [A A]) (zero-among-reals? e A (- depth 1) steps))
         (or (eqv? simple 0)
             (and (> depth 0)
                  (node? simple)
                  (< (expression-size simple) most-nodes)
                  (or (by-cases simple A again)
                      (by-logarithms simple A again)
                      (by-arcs simple A again)
                      (by-conjugates simple A again)))))))

(define (by-cases e A again)
  (define cases (sign-cases e A))
  (and cases
       (for/and ([c (in-list cases)]) (again (car c) (cdr c)))))

(define (by-logarithms e A again)
  (define product (product-of-logarithms e A))
  (and product (again product)))

(define (by-arcs e A again)
  (define-values (y x) (angle-of-arcs e A))
  (and y
       (again y)
       (signs-within? (real-signs x A) nonnegative)))

(define (by-conjugates e A again)
  (for/or ([r (in-list (conjugate-roots e A))])
    (define-values (P Q) (parts-by-root e r))
    (and (opposite-signs? P Q A)
         (again (e:* e (conjugate e r))))))
