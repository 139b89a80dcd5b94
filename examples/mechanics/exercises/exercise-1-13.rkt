#lang mechanics
;; Exercise 1.13 (SICM 1.5): equations of higher order, computed
;; Checked: a program for Lagrange's equations of any order
;; How: against Lagrange-equations, on an oscillator in disguise and on arbitrary Lagrangians

;; Write a program for the equations of a Lagrangian that depends on n derivatives: each of its
;; partial derivatives, along the path, is differentiated by time as often as its coordinate was.

(define ((((equations sign) L n) q) t)
  (for/sum ([k (+ n 1)])
    (* (sign k)
       (((expt D k) (compose ((partial (+ k 1)) L) (Gamma q (+ n 2)))) t))))

;; The signs alternate, as each of the k integrations by parts changes it.  In the slip all of
;; them have that of the first.
(define attempt (equations (lambda (k) (- (expt -1 k)))))
(define slip (equations (lambda (k) (if (= k 0) -1 1))))

(define x (literal-function 'x))

;; −½ m x ẍ − ½ k x² differs from the oscillator's Lagrangian by a total time derivative.
(define ((L-disguised m k) (up t x v a))
  (- (* -1/2 m x a) (* 1/2 k (square x))))
(((attempt (L-disguised 'm 'k) 2) x) 't)
(((slip (L-disguised 'm 'k) 2) x) 't)

;; Of any order, for Lagrangians of which nothing is known.
(define (arbitrary n)
  (literal-function 'L (case n
                         [(1) (-> (UP Real Real Real) Real)]
                         [(2) (-> (UP Real Real Real Real) Real)])))
(define (verdict program n)
  (verify-equal (((program (arbitrary n) n) x) 't)
                (((Lagrange-equations (arbitrary n) #:order n) x) 't)))
(define right (for/list ([n '(1 2)]) (verdict attempt n)))
(define wrong (for/list ([n '(1 2)]) (verdict slip n)))
(map verdict-status right)
(map verdict-status wrong)

(module+ test
  (require rackunit)
  (test-case "the program gives the oscillator's equation"
    (check-equal? (expression (simplify (((attempt (L-disguised 'm 'k) 2) x) 't)))
                  '(+ (* k (x t)) (* m (((expt D 2) x) t)))))
  (test-case "it is right for any Lagrangian; the slip shows at order 2 first"
    (check-equal? (map verdict-status right) '(proved proved))
    (check-equal? (map verdict-status wrong) '(proved refuted))))
