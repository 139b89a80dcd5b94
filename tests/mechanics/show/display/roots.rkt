#lang racket/base
;; Exact roots as results: at the prompt with their decimals beside them, elsewhere as formulas.

(require mechanics mechanics/show/display/result
         "../../support/checks.rkt")

(define (shown x [manner 'expression]) (format "~v" (simplified-result x 60 manner)))

(test-case "the decimal of a root stands beside it, as a comment"
  (check-equal? (shown (sqrt 2)) "(sqrt 2)  ; 1.4142135623730951")
  (check-equal? (shown (/ 1 (- (sqrt 3) 1))) "(+ 1/2 (* 1/2 (sqrt 3)))  ; 1.3660254037844386")
  (check-equal? (shown (read-expression '(sqrt 12))) "(* 2 (sqrt 3))  ; 3.4641016151377544"))

(test-case "within a larger result it is left out, for the rest of the line would be one"
  (check-equal? (shown (up (sqrt 2) 1)) "(up (sqrt 2) 1)")
  (check-equal? (shown (list (sqrt 2) 1)) "(list (sqrt 2) 1)")
  (check-equal? (shown (* 'x (sqrt 2))) "(* x (sqrt 2))"))

(test-case "formulas show the root"
  (check-equal? (shown (sqrt 2) 'infix) "√2")
  (check-equal? (->TeX (/ 1 (sqrt 2))) (->TeX (read-expression '(* 1/2 (sqrt 2))))))
