#lang racket/base
;; Literal functions and their derivatives at arguments that are equal, and nearly so.

(require "../disguise.rkt" "../statement.rkt" "forms.rkt")

(provide literal-functions)

(define (literal-functions)
  (define-values (e r) (random-pair))
  (statement e (if (chance 6) (spoiled r) r) '() '()))

(define (random-pair)
  (define-values (u u2) (equal-arguments))
  (define-values (w w2) (equal-arguments))
  (case (random 5)
    [(0 1) (define h (random-head))
           (values `(,h ,u) `(,h ,u2))]
    [(2) (define h (pick '(F (partial 0) (partial 1))))
         (define head (if (eq? h 'F) h (list h 'F)))
         (values `(,head ,u ,w) `(,head ,u2 ,w2))]
    [(3) (define h (random-head))
         (values `(* (,h ,u) (W ,w)) `(* (W ,w2) (,h ,u2)))]
    [else (define h (random-head))
          (values `(+ (,h ,u) (,h ,w)) `(+ (,h ,w2) (,h ,u2)))]))

(define (random-head) (pick '(V V V (D V) ((expt D 2) V) W)))

;; Mostly equal; some where they are equal at some points only.
(define (equal-arguments)
  (define u (random-linear))
  (define x (random-symbol))
  (define-values (a b)
    (apply values
           (pick (list (list u (disguised u 1)) (list u (disguised u 2))
                       (list `(* 0.5 ,x) `(* 1/2 ,x)) (list 2 2.0) (list 1/2 0.5)
                       (list '(sqrt 2) '(/ 2 (sqrt 2))) (list `(asinh (sinh ,x)) x)
                       (list `(sqrt (square ,u)) `(abs ,u)) (list `(sqrt (square ,u)) u)
                       (list `(log (exp ,x)) x) (list '(sqrt 8) '(* 2 (sqrt 2)))
                       (list `(sin (+ ,x 1)) `(+ (* (sin ,x) (cos 1)) (* (cos ,x) (sin 1))))
                       (list '(atan 1) '(asin (/ (sqrt 2) 2))) (list `(exp (log ,x)) x)
                       (list `(- ,u) u) (list `(expt (expt ,x 3) 1/3) x)
                       (list `(+ ,u 1/1000000000000) u)))))
  (if (chance 2) (values a b) (values b a)))
