#lang racket/base
;; Elliptic integrals and Jacobi's functions: known values, identities, derivatives.

(require mechanics/generic/elementary
         mechanics/calculus/derivative
         mechanics/calculus/elliptic
         mechanics/compile/definite-integral
         "../support/checks.rkt")

(define K first-elliptic-integral)
(define E second-elliptic-integral)
(define (sinh x) (/ (- (exp x) (exp (- x))) 2))
(define (cosh x) (/ (+ (exp x) (exp (- x))) 2))
(define (complement k) (sqrt (- 1 (* k k))))
(define moduli '(0 0.01 0.3 -0.5 0.7071067811865476 0.9 0.999 0.999999))

(define (sn u k) (Jacobi-elliptic-functions u k (lambda (s c d) s)))
(define (cn u k) (Jacobi-elliptic-functions u k (lambda (s c d) c)))
(define (dn u k) (Jacobi-elliptic-functions u k (lambda (s c d) d)))

(test-case "complete integrals at known points"
  (check-= (K 0) (* 2 (atan 1.0)) 1e-15)
  (check-= (E 0) (* 2 (atan 1.0)) 1e-15)
  (check-= (K (sqrt 0.5)) 1.8540746773013719 1e-14)
  (check-= (E (sqrt 0.5)) 1.3506438810476755 1e-14)
  (check-equal? (elliptic-integrals 0.3 list) (list (K 0.3) (E 0.3))))

(test-case "the pendulum's period at several amplitudes"
  (define pi (* 4 (atan 1.0)))
  (define (ratio amplitude) (* (/ 2 pi) (K (sin (/ amplitude 2)))))
  (check-= (ratio (/ pi 6)) 1.017408797596 1e-12)
  (check-= (ratio (/ pi 2)) 1.1803405990161 1e-13)
  (check-= (* 4 (sqrt (/ 1 9.8)) (K (sin 0.5))) 2.140228719018093 1e-14))

(test-case "Legendre's relation"
  (for ([k (in-list (cdr moduli))])
    (define k* (complement k))
    (check-= (- (+ (* (E k) (K k*)) (* (E k*) (K k))) (* (K k) (K k*)))
             (* 2 (atan 1.0)) 1e-11)))

(test-case "incomplete integrals are those that define them"
  (for* ([k (in-list moduli)] [phi (in-list '(-2.5 -0.4 0 0.1 1.2 1.5 4.0 11.0))])
    (define (f s) (sqrt (- 1 (* k k (sin s) (sin s)))))
    (check-= (elliptic-integral-F phi k) (definite-integral (lambda (s) (/ 1 (f s))) 0 phi 1e-12)
             1e-8)
    (check-= (elliptic-integral-E phi k) (definite-integral f 0 phi 1e-12) 1e-10))
  (for ([k (in-list moduli)])
    (check-= (elliptic-integral-F (* 2 (atan 1.0)) k) (K k) (* 1e-10 (K k)))
    (check-= (elliptic-integral-E (* 2 (atan 1.0)) k) (E k) 1e-11)))

(test-case "Jacobi's functions: squares, addition, periods, inverse"
  (for* ([k (in-list (remove 0.999999 moduli))] [u (in-list '(-3.1 -0.2 0 0.7 1.9 6.5))])
    (define-values (s c d) (Jacobi-elliptic-functions u k values))
    (check-= (+ (* s s) (* c c)) 1 1e-13)
    (check-= (+ (* d d) (* k k s s)) 1 1e-13)
    (check-= (sn (+ u (* 4 (K k))) k) s 1e-11)
    (check-= (cn (+ u (* 2 (K k))) k) (- c) 1e-11)
    (define-values (s* c* d*) (Jacobi-elliptic-functions 0.4 k values))
    (define below (- 1 (* k k s s s* s*)))
    (check-= (sn (+ u 0.4) k) (/ (+ (* s c* d*) (* s* c d)) below) 1e-11)
    (when (<= 0 u 1.5)
      (check-= (elliptic-integral-F (asin s) k) u 1e-10)))
  (check-= (sn 0.8 0) (sin 0.8) 1e-15)
  (check-= (sn 0.5 0.9999999999) (/ (sinh 0.5) (cosh 0.5)) 1e-9))

(test-case "derivatives of Jacobi's functions are products of the other two"
  (for* ([k (in-list '(0.3 0.9))] [u (in-list '(-0.9 0.5 2.5))])
    (define-values (s c d) (Jacobi-elliptic-functions u k values))
    (check-= ((D (lambda (u) (sn u k))) u) (* c d) 1e-11)
    (check-= ((D (lambda (u) (cn u k))) u) (- (* s d)) 1e-11)
    (check-= ((D (lambda (u) (dn u k))) u) (- (* k k s c)) 1e-11)
    ;; sn'' = -(1 + k^2) sn + 2 k^2 sn^3
    (check-= (((g:expt D 2) (lambda (u) (sn u k))) u)
             (- (* 2 k k s s s) (* (+ 1 (* k k)) s)) 1e-10)))

(test-case "derivatives by the modulus"
  (for ([k (in-list '(0.2 0.6 0.95))])
    (define k*2 (- 1 (* k k)))
    (check-= ((D K) k) (/ (- (E k) (* k*2 (K k))) (* k k*2)) 1e-10)
    (check-= ((D E) k) (/ (- (E k) (K k)) k) 1e-12)
    (check-= ((D (lambda (phi) (elliptic-integral-F phi k))) 1.1)
             (/ 1 (sqrt (- 1 (expt (* k (sin 1.1)) 2)))) 1e-12)
    (check-= ((D (lambda (k) (elliptic-integral-E (* 2 (atan 1.0)) k))) k)
             (/ (- (E k) (K k)) k) 1e-10)))

(test-case "other moduli are refused"
  (for ([f (in-list (list K E (lambda (k) (sn 1 k))))])
    (check-exn #rx"expected a modulus between -1 and 1\n  given: the number 2" (lambda () (f 2)))
    (check-exn #rx"expected a real number\n  given: the symbol k" (lambda () (f 'k))))
  (check-exn #rx"^elliptic-integral-F: expected a real number\n  given: the symbol k"
             (lambda () (elliptic-integral-F 1 'k))))

(test-case "incomplete integrals of a greater modulus are real up to where k sin phi is 1"
  ;; by sin a = k sin phi, F(phi, k) = F(a, 1/k)/k
  (for ([k '(1.5 -3.0)] [phi '(0.6 0.3)])
    (define a (asin (* (abs k) (sin phi))))
    (check-= (elliptic-integral-F phi k) (/ (elliptic-integral-F a (/ 1 k)) (abs k)) 1e-14))
  (check-= (elliptic-integral-F 0.5 1) (* 1/2 (log (/ (+ 1 (sin 0.5)) (- 1 (sin 0.5))))) 1e-14)
  (check-= (elliptic-integral-E 0.5 1) (sin 0.5) 1e-14)
  (check-= ((D (lambda (phi) (elliptic-integral-E phi 1.5))) 0.3)
           (sqrt (- 1 (expt (* 1.5 (sin 0.3)) 2))) 1e-12)
  (for ([phi (list 0.8 2.0 (asin 1.0))] [k '(1.5 1.5 -1)])
    (check-exn #rx"^elliptic-integral-F: expected a modulus k between -1 and 1, or one with"
               (lambda () (elliptic-integral-F phi k)))))
