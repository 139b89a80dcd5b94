#lang racket/base
;; asinh, acosh, atanh and sgn were read as functions of nobody's: what had been printed with
;; them, or declared of them, spoke of something else.

(require mechanics
         mechanics/algebra/expression/expression
         mechanics/algebra/expression/operation
         mechanics/algebra/expression/read
         "../support/checks.rkt")

(define binary (list op:+ op:- op:* op:/ op:expt))

(test-case "every operation is read as the one that was printed"
  (for ([o (in-list operations)])
    (define e (make-node o (for/list ([_ (in-range (if (memq o binary) 2 1))] [x '(x y)]) x)))
    (check-equal? (datum->expression (expression->datum e)) e (format "~a" (operation-name o)))))

(test-case "what is declared of asinh x is known of it"
  (assuming ('(> (asinh x) 0))
    (check-pred proved? (verify-equal (sqrt (square (asinh 'x))) (asinh 'x)))
    (check-pred proved? (verify-equal (sgn (asinh 'x)) 1))))
