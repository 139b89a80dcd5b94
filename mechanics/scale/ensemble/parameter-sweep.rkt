#lang racket/base
;; Rows of parameters in which one of them, told by its name, takes one value after another.

(require (only-in racket/list index-of list-set)
         "../../error/complain.rkt" "../../error/spelling.rkt"
         "../../generic/wrong-argument.rkt")

(provide sweep)

(define who 'sweep)

;; parameters : list of (name value), as fit-motion has them; values : a sequence
;; -> a list of rows for evolve-ensemble, each a list of values in that order
(define (sweep parameters name values)
  (unless (and (list? parameters) (andmap pair-of-name? parameters))
    (complain-of-argument who "the parameters with their values, such as '((m 1) (l 2))"
                          parameters))
  (check-argument who (lambda (x) (and (sequence? x) (not (number? x)))) values
                  "the values that it takes, a list or another sequence")
  (define names (map car parameters))
  (define place (index-of names name))
  (unless place
    (complain who "there is no parameter ~a~a" name (among name names)))
  (define row (map cadr parameters))
  (for/list ([x values]) (list-set row place x)))

(define (pair-of-name? x) (and (list? x) (= 2 (length x)) (symbol? (car x))))
