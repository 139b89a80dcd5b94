#lang racket/base
;; With decimals the sign of a rounding decided whether an equilibrium was stable: a direction
;; without a force was one of a force of 10⁻¹⁷.

(require mechanics "../support/checks.rkt")

(define (kind L q) (stability-kind (equilibrium-stability L q)))

(define ((with-potential V) s)
  (- (* 1/2 (square (velocity s))) (V (coordinate s))))

;; Between three masses and a wall
(define ((chain a b c) q)
  (define-values (x y z) (values (ref q 0) (ref q 1) (ref q 2)))
  (* 1/2 (+ (* a (square (- x y))) (* b (square (- y z))) (* c (square z)))))

(define ((valley k r) q) (* 1/2 k (square (- (ref q 0) (* r (ref q 1))))))

(test-case "a direction without a force stays open"
  (for ([a '(0.1 0.3 1/10 7.3)] [b '(0.2 0.7 1/5 1e-9)])
    (check-eq? (kind (with-potential (chain a b 0)) (up 0 0 0)) 'undecided))
  (for* ([k '(0.1 0.3 1/10)] [r '(0.7 1.7 7/10 1e5)])
    (check-eq? (kind (with-potential (valley k r)) (up 0 0)) 'undecided)))

(test-case "so does what is 0 but for roundings of the decimals"
  (define (inflection x) (+ (cube x) (* -0.3 (square x)) (* 0.03 x)))
  (check-eq? (kind (with-potential inflection) 0.1) 'undecided)
  (check-eq? (kind (with-potential (lambda (x) (+ (* 0.3 (square x)) (* -0.1 (square x))
                                                  (* -0.2 (square x)))))
                   0)
             'undecided)
  (define ((ring omega) s)
    (define-values (angle rate) (values (coordinate s) (velocity s)))
    (+ (* 1/2 0.1 0.1 (+ (square rate) (square (* omega (sin angle))))) (* 9.8 0.1 (cos angle))))
  (check-eq? (kind (ring (sqrt 98.0)) 0) 'undecided)
  (check-eq? (kind (ring 9.899) 0) 'stable)
  (check-eq? (kind (ring 9.9) 0) 'unstable))

(test-case "with parameters beside the decimals, too"
  (check-eq? (kind (with-potential (valley (* 0.1 'k) 0.7)) (up 0 0)) 'undecided)
  (check-equal? (stability-conditions
                 (equilibrium-stability (with-potential (lambda (x) (* 0.5 'k (square x)))) 0))
                '((> k 0))))

(test-case "springs hold, however unlike their decimals are"
  (for ([stiffnesses '((1e16 1 1e-8) (1e16 1.0 1e-8) (1e-12 1e12 0.3))])
    (check-eq? (kind (with-potential (apply chain stiffnesses)) (up 0 0 0)) 'stable))
  (check-eq? (kind (with-potential (chain 1e16 1.0 -1e-8)) (up 0 0 0)) 'unstable)
  (check-eq? (kind (with-potential (chain 0.1 0.2 0.3)) (up 0 0 0)) 'stable))
