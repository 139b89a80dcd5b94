#lang racket/base
;; Sines, cosines and exponentials of sums of rational functions, and their addition
;; theorems, right and nearly right.

(require racket/match
         "../disguise.rkt" "../statement.rkt" "forms.rkt")

(provide rational-function-angles random-angle)

(define (rational-function-angles)
  (define e (random-function))
  (define r (rewritten-somewhere e expanded 20))
  (statement e (case (random 5) [(0) (spoiled r)] [(1) (disguise-once r)] [else r]) '() '()))

(define (random-function)
  (define e
    `(,(pick '(sin cos exp tan sinh cosh exp sin cos))
      (,(pick '(+ + -)) ,(random-angle) ,(random-angle))))
  (case (random 6)
    [(0 1) `(,(pick '(+ * /)) ,e ,(pick (list (random-symbol) `(exp ,(random-angle)))))]
    [(2) `(,(pick '(/ sgn abs sqrt)) ,e)]
    [else e]))

(define (random-angle)
  (define-values (y z) (random-symbols))
  (define x (pick (remq z '(x y z a))))
  (pick (list x `(* 2 ,x) `(/ ,x ,y) `(/ ,x (+ 1 ,y)) `(/ 1 (+ ,x ,z)) `(/ ,x (- ,y ,z))
              `(square ,x) `(/ (+ ,x ,y) (- ,x 2)) `(* 1/2 ,x) `(/ 1 (+ 1 (square ,x)))
              `(- ,x (/ ,y ,z)) `(expt ,x 12))))

(define (expanded e)
  (match e
    [`(sin (+ ,u ,v)) `(+ (* (sin ,u) (cos ,v)) (* (cos ,u) (sin ,v)))]
    [`(sin (- ,u ,v)) `(- (* (sin ,u) (cos ,v)) (* (cos ,u) (sin ,v)))]
    [`(cos (+ ,u ,v)) `(- (* (cos ,u) (cos ,v)) (* (sin ,u) (sin ,v)))]
    [`(cos (- ,u ,v)) `(+ (* (cos ,u) (cos ,v)) (* (sin ,u) (sin ,v)))]
    [`(exp (+ ,u ,v)) `(* (exp ,u) (exp ,v))]
    [`(exp (- ,u ,v)) `(/ (exp ,u) (exp ,v))]
    [`(tan (+ ,u ,v)) `(/ (+ (tan ,u) (tan ,v)) (- 1 (* (tan ,u) (tan ,v))))]
    [`(sinh (+ ,u ,v)) `(+ (* (sinh ,u) (cosh ,v)) (* (cosh ,u) (sinh ,v)))]
    [`(cosh (+ ,u ,v)) `(+ (* (cosh ,u) (cosh ,v)) (* (sinh ,u) (sinh ,v)))]
    [`(sinh ,u) `(/ (- (exp ,u) (exp (- ,u))) 2)]
    [`(cosh ,u) `(/ (+ (exp ,u) (exp (- ,u))) 2)]
    [`(tan ,u) `(/ (sin ,u) (cos ,u))]
    [_ #f]))
