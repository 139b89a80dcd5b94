#lang racket/base
;; Roots, moduli and logarithms under declared relations, all true at one hidden point.

(require "../disguise.rkt" "../statement.rkt"
         "forms.rkt" "logarithms.rkt" "roots-and-signs.rkt")

(provide declared-relations)

(define (declared-relations)
  (define numbers (random-point))
  (define given (relations-at numbers (random-between 1 3)))
  (define e (random-question given))
  (define r (if (chance 4) (disguise-once e) (rewritten-somewhere e settled)))
  (statement e (if (chance 4) `(- ,r) r) given (list numbers)))

;; Of what is declared, mostly.
(define (random-question given)
  (define u (if (chance 2) (cadr (pick given)) (random-linear)))
  (case (random 6)
    [(0 1) `(sqrt (square ,u))]
    [(2) `(abs ,u)]
    [(3) (random-tower 1)]
    [(4) (random-logarithm)]
    [else `(expt (expt ,u ,(pick '(2 4 -2))) ,(pick '(1/2 1/4 -1/2 3/2)))]))

(define (settled e)
  (or (flattened e)
      (and (pair? e) (eq? (car e) 'abs) (pick (list (cadr e) `(- ,(cadr e)))))))
