#lang racket/base
;; Logarithms of products, quotients and powers, and inverse hyperbolic functions.

(require racket/match
         "../disguise.rkt" "../statement.rkt" "forms.rkt")

(provide logarithms random-logarithm)

(define (logarithms)
  (define e (random-logarithm))
  (define r (for/fold ([e e]) ([_ (in-range (random-between 1 3))])
              (rewritten-somewhere e taken-apart)))
  (statement e (case (random 6) [(0) (spoiled r)] [(1) (disguise-once r)] [else r]) '() '()))

(define (random-logarithm)
  (define-values (u v) (values (random-form) (random-form)))
  (pick (list `(log (* ,u ,v)) `(log (/ ,u ,v)) `(log (expt ,u ,(random-exponent)))
              `(log (* ,(random-linear) ,u ,v)) `(log (sqrt ,u)) `(log (abs ,u))
              `(exp (log ,u)) `(log (exp ,u)) `(exp (* ,(pick '(2 1/2 -1 a)) (log ,u)))
              `(expt (expt ,u ,(pick '(2 3 1/2))) a) `(- (log ,u) (log ,v))
              `(asinh ,u) `(acosh ,u) `(atanh ,u) `(log (- ,u ,v)) `(log (square ,u))
              `(+ (log ,u) (log (/ 1 ,u))) `(sqrt (square (log ,u))))))

(define (taken-apart e)
  (match e
    [`(log (* ,u ,v)) `(+ (log ,u) (log ,v))]
    [`(log (* ,u ,v ,w)) `(+ (log ,u) (log (* ,v ,w)))]
    [`(log (/ ,u ,v)) `(- (log ,u) (log ,v))]
    [`(- (log ,u) (log ,v)) `(log (/ ,u ,v))]
    [`(log (expt ,u ,n)) (pick (list `(* ,n (log ,u)) `(* ,n (log (abs ,u)))))]
    [`(log (square ,u)) (pick (list `(* 2 (log ,u)) `(* 2 (log (abs ,u)))))]
    [`(log (sqrt ,u)) `(/ (log ,u) 2)]
    [`(exp (log ,u)) (pick (list u `(abs ,u)))]
    [`(log (exp ,u)) u]
    [`(log (- ,u ,v)) `(log (- ,v ,u))]
    [`(exp (* ,n (log ,u))) `(expt ,u ,n)]
    [`(expt (expt ,u ,m) ,n) `(expt ,u (* ,m ,n))]
    [`(asinh ,u) `(log (+ ,u (sqrt (+ 1 (square ,u)))))]
    [`(acosh ,u) (pick (list `(log (+ ,u (sqrt (- (square ,u) 1))))
                             `(log (+ ,u (* (sqrt (- ,u 1)) (sqrt (+ ,u 1)))))))]
    [`(atanh ,u) (pick (list `(* 1/2 (log (/ (+ 1 ,u) (- 1 ,u))))
                             `(* 1/2 (- (log (+ 1 ,u)) (log (- 1 ,u))))))]
    [`(sqrt (square ,u)) (pick (list u `(abs ,u)))]
    [_ #f]))
