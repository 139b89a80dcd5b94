#lang racket/base
;; A literal function of several numbers took anything that was no tuple, and
;; one of a single number failed inside its own error message.

(require mechanics/calculus/literal-function mechanics/value/signature "../support/checks.rkt")

(define F (literal-function 'F (-> (X Real Real) Real)))

(test-case "a literal function refuses what is no number, naming the slot"
  (check-exn #rx"^V: was declared [(]-> Real Real[)]; slot 0 got \"a\", a string$"
             (lambda () ((literal-function 'V) "a")))
  (check-exn #rx"^F: was declared [(]-> [(]X Real Real[)] Real[)]; slot 1 got #t, a boolean$"
             (lambda () (F 'x #t))))
