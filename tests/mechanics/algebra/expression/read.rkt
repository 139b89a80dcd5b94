#lang racket/base
;; Data that are no expressions.

(require mechanics/algebra/expression/read
         "../../support/checks.rkt")

(define (rejected d) (let/ec return (datum->expression d return) 'none))

(test-case "the part of a datum that is no expression is rejected"
  (for ([datum+part '((() ()) ((a . b) (a . b)) ((+ x ()) ()) ((sin "x") "x")
                      ((* 2 (sin x y)) (sin x y)) ((* 2 (sin x)) none))])
    (check-equal? (rejected (car datum+part)) (cadr datum+part))))
