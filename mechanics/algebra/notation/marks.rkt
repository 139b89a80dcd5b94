#lang racket/base
;; Marks of derivatives: D, (partial 1 0), (expt D 2), (* (partial 0) (partial 1)).

(require "name.rkt" "tree.rkt")

(provide marks-of dots-of short-name?)

;; The marks that a datum stands for, or #f.
(define (marks-of d)
  (cond [(eq? d 'D) (list (mark #f 1))]
        [(not (and (list? d) (pair? d))) #f]
        [else
         (case (car d)
           [(partial) (and (pair? (cdr d))
                           (andmap exact-nonnegative-integer? (cdr d))
                           (list (mark (cdr d) 1)))]
           [(expt) (and (= 3 (length d))
                        (exact-positive-integer? (caddr d))
                        (repeated (marks-of (cadr d)) (caddr d)))]
           [(*) (let ([all (map marks-of (cdr d))])
                  (and (pair? all) (andmap values all) (apply append all)))]
           [else #f])]))

;; One mark n times; several have no power of their own.
(define (repeated marks n)
  (and marks
       (null? (cdr marks))
       (list (mark (mark-path (car marks)) (* n (mark-count (car marks)))))))

;; The number of dots, up to 3, for which a head such as ((expt D 2) x) asks, or #f: the
;; function has a short name without dots of its own.
(define (dots-of head)
  (define marks (and (list? head) (= 2 (length head)) (symbol? (cadr head)) (marks-of (car head))))
  (and marks
       (null? (cdr marks))
       (not (mark-path (car marks)))
       (<= (mark-count (car marks)) 3)
       (memq (parts-sort (name-parts (cadr head))) '(letter capital))
       (= 0 (parts-dots (name-parts (cadr head))))
       (mark-count (car marks))))

;; Is it one letter, with whatever stands around it?
(define (short-name? t) (memq (parts-sort (name-parts (name-symbol t))) '(letter capital word)))
