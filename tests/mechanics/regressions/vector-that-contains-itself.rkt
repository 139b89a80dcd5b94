#lang racket/base
;; To print a vector that is its own element, the prompt walked through it without end.

(require mechanics
         racket/port
         rackunit)

(test-case "a vector that contains itself is printed as Racket prints it"
  (define v (vector 'a 0))
  (vector-set! v 1 v)
  (define (printed x) (with-output-to-string (lambda () (print-expression x))))
  (check-equal? (printed v) "#0='#(a #0#)\n")
  (check-equal? (printed (list 1 v)) "'(1 #0=#(a #0#))\n"))
