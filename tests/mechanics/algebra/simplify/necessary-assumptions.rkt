#lang racket/base
;; A result needs the assumptions that it states: with the other sign it is wrong somewhere.  And
;; it needs no others: it is right with either sign.

(require mechanics/algebra/assumption/assumption-set
         mechanics/algebra/assumption/reference-point
         mechanics/algebra/assumption/relation
         mechanics/algebra/expression/read
         mechanics/algebra/simplify/declare-relations
         mechanics/algebra/simplify/necessary-assumptions
         mechanics/algebra/simplify/simplify-expression
         mechanics/error/computed-once
         "../../support/checks.rkt" "../../support/random.rkt")

(define (needed d)
  (define-values (simple grounds) (simplify-expression/needed (datum->expression d) no-assumptions))
  (at-last grounds))

(test-case "what only stood in the way is not assumed"
  (for ([d '((sqrt (+ (expt (+ x (/ a b)) 2) (expt y 2)))
             (/ m (expt (+ (expt (- x (/ (* a M) (+ M N))) 2) (expt y 2)) 3/2))
             (* m (sqrt (/ (+ M N) (expt a 3)))))])
    (define-values (simple grounds) (simplify-expression/assumptions (datum->expression d)))
    (check-pred pair? grounds (format "~s" d))
    (check-equal? (needed d) '() (format "~s" d))))

(test-case "what the result rests on is"
  (check-equal? (needed '(sqrt (expt r 2))) '((>= r 0)))
  (check-equal? (needed '(sqrt (* (expt r 2) (expt (- a b) 2)))) '((>= r 0) (>= (- a b) 0)))
  (check-equal? (needed '(* (sqrt (expt r 2)) (sqrt (+ (expt (+ x (/ a b)) 2) (expt y 2)))))
                '((>= r 0)))
  ;; Below -2 it is -1, though at the point looked at it is 1.
  (define u '(+ 4 (* y (sqrt (expt y 2)))))
  (check-equal? (needed `(/ (sqrt (expt ,u 2)) ,u)) '((>= y 0))))

(test-case "what was declared and makes an assumption needless is needed itself"
  (define A (declare-relations no-assumptions '((< (* a b) 0) (> c 0))))
  (define (needed-under-A d)
    (define-values (simple grounds) (simplify-expression/needed (datum->expression d) A))
    (at-last grounds))
  (check-equal? (needed-under-A '(+ (* a b) (* (sqrt (expt a 2)) (sqrt (expt b 2)))))
                '((< (* a b) 0)))
  (check-equal? (needed-under-A '(+ (/ (sqrt (expt a 2)) a) (/ (sqrt (expt b 2)) b)))
                '((< (* a b) 0)))
  (check-equal? (needed-under-A '(sqrt (+ (expt (/ x b) 2) (expt y 2)))) '())
  (check-equal? (needed-under-A '(* (sqrt (expt c 2)) (sqrt (expt r 2)))) '((> c 0) (>= r 0))))

;; ---------------------------------------------------------------------------
;; Random expressions

(define (random-base) (random-choice 'a 'b '(+ a b) '(- a b) '(+ 1 (* a b)) '(- b)))

(define (random-root)
  (define-values (u v) (values (random-base) (random-base)))
  (random-choice `(sqrt (+ (expt (+ x (/ ,v ,u)) 2) (expt y 2)))
                 `(sqrt (+ 1 (/ (expt ,v 2) (expt ,u 2))))
                 `(* ,u (sqrt (+ 1 (/ (expt y 2) (expt ,u 2)))))
                 `(* ,v (sqrt (/ y (expt ,u 3))))
                 `(/ 1 (sqrt (+ (expt (- x (/ ,v ,u)) 2) 1)))
                 `(sqrt (* (expt ,u 2) (+ 1 (expt x 2))))
                 `(abs ,u)
                 `(/ (abs ,u) ,v)))

(define (random-form)
  (if (eqv? 0 (random 2)) (random-root) (list (random-choice '+ '*) (random-root) (random-root))))

;; -> two values at a random point, #f where there is none
(define (values-somewhere e simple)
  (define numbers (make-hash))
  (define (lookup leaf arguments)
    (hash-ref! numbers leaf (lambda () (exact->inexact (random-rational)))))
  (list (real-value e lookup) (real-value simple lookup) lookup))

;; Points (value value lookup) at which relations hold and both have values.
(define (points e simple relations)
  (for*/list ([_ (in-range 300)]
              [p (in-value (values-somewhere e simple))]
              #:when (and (car p) (cadr p)
                          (for/and ([r (in-list relations)]) (holds-at? r (caddr p)))))
    p))

(define (agree? p)
  (<= (abs (- (car p) (cadr p))) (* 1e-8 (+ 1 (abs (car p))))))

(define (opposite d) (cons (if (eq? (car d) '>=) '< '>) (cdr d)))

(test-case "results are right where what they need holds, and wrong elsewhere"
  (with-seeds 150
    (define d (random-form))
    (define e (datum->expression d))
    (define-values (simple notes) (simplify-expression/needed e no-assumptions))
    (define grounds (at-last notes))
    (define at-all (points e simple (map read-relation grounds)))
    (check-true (andmap agree? at-all) (format "~s\n~s\n~s" d simple grounds))
    (for ([g (in-list grounds)])
      (define beyond
        (points e simple (map read-relation (cons (opposite g) (remove g grounds)))))
      (check-false (and (> (length beyond) 5) (andmap agree? beyond))
                   (format "~s does not need ~s of ~s" d g grounds)))))
