#lang racket/base
;; √(e^(2it)) became e^(it), log e^(it) became it and |x + it|² (x + it)², with nothing
;; said; the first is the opposite at t = 3.  Where x < 0 was declared, √(1/x) became
;; 1/√x, log x³ 3 log x, and √(cosh²√x) cosh √x, which is a cosine.

(require mechanics/algebra/simplify/simplify-expression
         mechanics/algebra/expression/expression
         mechanics/algebra/assumption/assumption-set
         mechanics/algebra/simplify/declare-relations
         mechanics/algebra/zero/proof
         mechanics/algebra/expression/flat-graph
         mechanics/algebra/expression/read
         "../support/checks.rkt" "../support/evaluate.rkt")

(define negative-x (declare-relations no-assumptions '((< x 0))))

(define (value e point)
  (evaluate-expression e (lambda (leaf arguments) (hash-ref point leaf))))

;; The simplified form has the same value at the point.
(define (check-simplified datum form A point)
  (define e (datum->expression datum))
  (define-values (simple notes) (simplify-expression/assumptions e A))
  (check-equal? (expression->datum simple) form)
  (check-= (magnitude (- (value e point) (value simple point))) 0 1e-12 (format "~s" datum)))

(test-case "roots, logarithms and absolute values of complex numbers stay"
  (define late (hasheq 't 4 'x 1))
  (for ([A (list no-assumptions (with-automatic-assumptions no-assumptions #f))])
    (check-simplified '(sqrt (exp (* +2i t))) '(sqrt (exp (* +2i t))) A late)
    (check-simplified '(log (exp (* +i t))) '(log (exp (* +i t))) A late)
    (check-simplified '(sqrt (expt (- (* +i t) x) 2))
                      '(sqrt (+ (expt x 2) (* -1 (expt t 2)) (* -2i t x))) A (hasheq 't -4 'x 1)))
  (define-values (simple notes)
    (simplify-expression/assumptions (datum->expression '(expt (abs (+ x (* +i t))) 2))))
  (check-equal? (expression->datum simple) '(expt (abs (+ (* +i t) x)) 2))
  (check-equal? notes '()))

(test-case "so do exponentials of real numbers what they are"
  (define-values (simple notes)
    (simplify-expression/assumptions (datum->expression '(+ (sqrt (exp (* 2 t))) (log (exp t))))))
  (check-equal? (expression->datum simple) '(+ t (exp t)))
  (check-equal? notes '()))

(test-case "below a root and a logarithm the opposite of what is negative stands"
  (define point (hasheq 'x -2))
  (check-simplified '(* (sqrt (/ 1 x)) (sqrt x)) -1 negative-x point)
  (check-simplified '(log (/ 1 x)) '(- (log -1) (log (* -1 x))) negative-x point)
  (check-simplified '(log (expt x 3)) '(+ (log -1) (* 3 (log (* -1 x)))) negative-x point)
  (check-simplified '(sqrt (/ 1 (sqrt x))) '(sqrt (/ 1 (sqrt x))) negative-x point))

(test-case "functions of a root of what is negative have no sign"
  (check-simplified '(sqrt (expt (cosh (sqrt x)) 2)) '(sqrt (expt (cosh (sqrt x)) 2))
                    negative-x (hasheq 'x -4)))

(test-case "a root of what is 0 is 0 under assumptions too"
  (check-simplified '(sqrt (expt (- x x) 1/3)) 0 negative-x (hasheq 'x -1)))

(test-case "a symbol for something negative proves nothing about its root"
  (define (proof datum)
    (prove-vanishing (expression->tape (datum->expression datum)) negative-x))
  (check-false (proof '(- (sqrt (/ 1 (* x (+ 1 (expt y 2))))) (/ 1 (sqrt (* x (+ 1 (expt y 2))))))))
  (check-equal? (proof '(- (expt (- x y) 2) (expt (- y x) 2))) '()))
