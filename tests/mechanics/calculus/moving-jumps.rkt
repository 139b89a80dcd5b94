#lang racket/base
;; Derivatives of integrals whose integrand jumps or bends at a place that moves, against the
;; integrals done by hand.

(require mechanics/calculus/derivative
         mechanics/compile/definite-integral
         mechanics/generic/arithmetic mechanics/generic/compare mechanics/generic/elementary
         mechanics/generic/rounding
         mechanics/value/structure
         "../support/checks.rkt")

(define ((integral f [low 0] [high 1]) a) (definite-integral (lambda (x) (f x a)) low high))

(define-check (check-slope f a expected)
  (define found ((D f) a))
  (unless (< (abs (- found expected)) 1e-9)
    (with-check-info (['found found] ['expected expected]) (fail-check))))

(test-case "a jump at a"
  (define F (integral (lambda (x a) (if (g:< x a) 1 0))))
  (check-= (F 0.3) 0.3 1e-9)
  (check-slope F 0.3 1.0)
  (define G (integral (lambda (x a) (if (g:< x a) (g:* a x) (g:exp x)))))
  ;; a³/2 + e − e^a
  (check-slope G 0.3 (- (* 3/2 0.09) (exp 0.3)))
  (check-= (((g:expt D 2) G) 0.3) (- (* 3 0.3) (exp 0.3)) 1e-8)
  (define H (integral (lambda (x a) (if (g:> (g:square x) a) 1 0))))      ; 1 − √a
  (check-slope H 0.25 -1.0)
  (check-= (((g:expt D 2) H) 0.25) 2.0 1e-8))

(test-case "|x − a|, to the second and third order"
  (define F (integral (lambda (x a) (g:abs (g:- x a)))))                  ; a² − a + 1/2
  (check-slope F 0.3 -0.4)
  (check-= (((g:expt D 2) F) 0.3) 2.0 1e-8)
  (check-= (((g:expt D 3) F) 0.3) 0.0 1e-6)
  (check-= ((D (D F)) 0.3) 2.0 1e-8)
  (define G (integral (lambda (x a) (g:sgn (g:- x a)))))                  ; 1 − 2a
  (check-slope G 0.3 -2.0)
  (define H (integral (lambda (x a) (g:abs (g:sin (g:+ x a)))) 0 10))     ; |sin(10+a)| − |sin a|
  (check-slope H 0.3 (- (abs (sin 10.3)) (sin 0.3))))

(test-case "max, min and roundings"
  (check-slope (integral g:max) 0.3 0.3)                                   ; (1 + a²)/2
  (check-= (((g:expt D 2) (integral g:max)) 0.3) 1.0 1e-8)
  (check-slope (integral g:min) 0.3 0.7)
  ;; of floor(x/a + 1/10), from 0 to 1, the jumps are at (k − 1/10) a
  (define F (integral (lambda (x a) (g:floor (g:+ (g:/ x a) 1/10)))))
  (check-slope F 0.3 (- (for/sum ([k '(1 2 3)]) (- k 0.1))))
  (define G (integral (lambda (x a) (g:round (g:/ x a)))))
  (check-slope G 0.3 (- (for/sum ([k '(1 2 3)]) (- k 0.5))))
  (define H (integral (lambda (x a) (g:truncate (g:* a x))) -1 1/2))      ; jumps at -2/a, -1/a, 1/a
  (check-slope H 2.5 (/ -2 (* 2.5 2.5))))

(test-case "limits that move as well, and infinite ones"
  (define (F a) (definite-integral (lambda (x) (if (g:< x (g:/ a 2)) 2 x)) 0 a))
  ;; a + (a² − a²/4)/2
  (check-slope F 1.0 1.75)
  (define G (integral (lambda (x a) (g:* (g:exp (g:- 0 x)) (g:abs (g:- x a)))) 0 +inf.0))
  ;; a − 1 + 2 e^(−a)
  (for ([a (list 0.5 3.0)]) (check-slope G a (- 1 (* 2 (exp (- a)))))))

(test-case "by two parameters, and gradients"
  (define (F a b) (definite-integral (lambda (x) (if (g:< x (g:* a b)) (g:* b x) 0)) 0 1))
  ;; a² b³/2
  (check-= (s:ref ((D F) 0.5 0.8) 0) (* 0.5 (expt 0.8 3)) 1e-9)
  (check-= (((partial 1) ((partial 0) F)) 0.5 0.8) (* 3 0.5 0.64) 1e-8))

(test-case "jumps that do not move add nothing"
  (check-slope (integral (lambda (x a) (g:* a (if (< x 1/2) 1 2)))) 0.7 1.5)
  (check-slope (integral (lambda (x a) (g:* a (g:floor (g:* 3 x))))) 0.7 1.0))
