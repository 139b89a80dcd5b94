#lang racket/base
;; `up` and `down`: constructors, values, and patterns of match.

(require mechanics/lang/pattern/pattern
         racket/match
         "../../support/checks.rkt")

(define-namespace-anchor here)

(test-case "up and down construct, and are values like any function"
  (check-true (procedure? up))
  (check-equal? (up 1 2) (apply up '(1 2)))
  (check-equal? (map down '(1 2) '(3 4)) (list (down 1 3) (down 2 4)))
  (check-equal? (object-name up) 'up)
  (check-equal? (object-name down) 'down))

(test-case "a match pattern tells orientation and length"
  (define (kind x)
    (match x
      [(down a b) (list 'down a b)]
      [(up a) (list 'up a)]
      [(up a b) (list 'up a b)]
      [_ 'other]))
  (check-equal? (kind (up 1 2)) '(up 1 2))
  (check-equal? (kind (up 1)) '(up 1))
  (check-equal? (kind (down 1 2)) '(down 1 2))
  (check-equal? (kind (down 1)) 'other)
  (check-equal? (kind '(1 2)) 'other)
  (check-equal? (kind 3) 'other))

(test-case "vectors match up and not down"
  (check-equal? (match #(1 2) [(down a b) 'down] [(up a b) (list a b)]) '(1 2)))

(test-case "match patterns nest and hold any pattern"
  (check-equal?
   (match (up 't (up 'x #(1 2)) (down 3 4))
     [(up (? symbol? t) (up 'x (up a b)) (down (app add1 c) d)) (list t a b c d)])
   '(t 1 2 4 4)))

(test-case "an ellipsis matches what is left"
  (check-equal? (match (up 't 1 2 3) [(up t qs ...) (list t qs)]) '(t (1 2 3)))
  (check-equal? (match (up 't) [(up t qs ...) (list t qs)]) '(t ()))
  (check-equal? (match (down (up 1 2) (up 3 4)) [(down (up a b) ...) (list a b)])
                '((1 3) (2 4))))

(test-case "the other match forms take the patterns"
  (match-define (up a (down b)) (up 1 (down 2)))
  (check-equal? (list a b) '(1 2))
  (check-equal? ((match-lambda [(up a b) (+ a b)]) (up 1 2)) 3)
  (check-equal? (match-let ([(up a b) (up 1 2)]) (list b a)) '(2 1))
  (check-exn exn:misc:match? (lambda () (match (up 1) [(up a b) 1]))))

(test-case "a renamed up is still the same pattern"
  (define module
    '(module renamed racket/base
       (require (rename-in mechanics/lang/pattern/pattern [up column])
                (only-in racket/match match))
       (provide f g)
       (define (f (column a b)) (list a b))
       (define (g x) (match x [(column a b) (list b a)]))))
  (parameterize ([current-namespace (namespace-anchor->empty-namespace here)])
    (namespace-require 'racket/base)
    (eval module)
    (check-equal? ((dynamic-require ''renamed 'f) (up 1 2)) '(1 2))
    (check-equal? ((dynamic-require ''renamed 'g) (up 1 2)) '(2 1))))
