#lang racket/base
;; Decimals: what holds for any, what holds for these, and what they only come near to.

(require "../disguise.rkt" "../statement.rkt" "forms.rkt")

(provide decimals)

(define (decimals)
  (define e (random-decimal-form))
  (define r (disguised (if (chance 3) (substituted e (decimal-within e) (random-reading)) e)
                       (random 3)))
  (statement e (if (chance 5) (spoiled r) r) '() '()))

(define (random-reading)
  (pick '(1/10 1/2 3/10 2 (sqrt 2) (/ (sqrt 2) 2) 0.3 1/3 0.30000000000000004 98/10)))

(define (random-decimal)
  (pick '(0.1 0.5 0.2 0.3 2.0 1.4142135623730951 0.7071067811865476 9.8 0.25 1e-9 1e9 1.5
          0.3333333333333333 1.41421356)))

(define (random-decimal-form)
  (define-values (c d x y) (values (random-decimal) (random-decimal) (random-symbol)
                                   (random-symbol)))
  (pick (list `(* ,c ,x) `(+ (* ,c ,x) (* ,d ,x)) `(square (+ ,x ,c)) `(sin (* ,c ,x))
              `(cos (+ (* ,c ,x) ,y)) `(sqrt (* ,c ,(random-linear))) `(exp (* ,c ,x))
              `(/ ,x (- ,c ,y)) `(* ,c (+ ,x (* ,d ,y))) `(square (* ,c (sin ,x)))
              `(- (square (+ ,x ,c)) (square ,x)) `(sqrt (square (- ,c ,x)))
              `(- (expt (+ ,x ,c) 2) (* ,x (+ ,x ,d))) `(sqrt (* (square ,c) ,x))
              `(expt ,x ,(pick '(0.5 2.0 1.5))) `(- (* (square ,c) ,x) (* ,d ,x))
              `(/ (* ,c ,x) ,d) `(abs (* ,c ,x)) `(log (* ,c ,x)))))

(define (decimal-within e)
  (cond [(flonum? e) e]
        [(pair? e) (for/or ([a (in-list (cdr e))]) (decimal-within a))]
        [else #f]))
