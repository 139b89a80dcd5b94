#lang racket/base
;; Identities of smooth functions that hold wherever both sides have values, disguised; and
;; the same false by 10^-12 of something that is not zero.

(require "../disguise.rkt" "../judge/point.rkt" "../statement.rkt" "forms.rkt")

(provide disguised-identity false-by-little)

(define (random-smooth depth)
  (define (sub) (random-smooth (- depth 1)))
  (if (eqv? depth 0)
      (pick '(x y z a 2 1/3))
      (case (random 9)
        [(0 1) `(+ ,(sub) ,(sub))]
        [(2 3) `(* ,(sub) ,(sub))]
        [(4) `(- ,(sub) (* 2 ,(random-symbol)))]
        [(5) `(/ ,(sub) (+ 1 (square ,(random-symbol))))]
        [(6) `(,(pick '(sin cos)) ,(pick (list (random-symbol) (random-linear))))]
        [(7) `(sqrt (+ 1 (square ,(sub))))]
        [(8) `(exp ,(random-symbol))])))

;; Functions of numbers alone would be decimals; they are another class.
(define (disguised-identity)
  (define e (random-smooth 3))
  (define r (disguised e (random-between 2 5)))
  (if (or (constant-within? e) (constant-within? r))
      (disguised-identity)
      (statement e r '() '())))

(define (constant-within? e)
  (and (pair? e)
       (or (null? (symbols-of e)) (ormap constant-within? (cdr e)))))

(define (false-by-little)
  (define s (disguised-identity))
  (define excess `(/ ,(pick (list '(exp x) '(+ 2 (sin y)) '(+ 1 (square z)))) 1000000000000))
  (statement (statement-left s) `(+ ,(statement-right s) ,excess) '() '()))
