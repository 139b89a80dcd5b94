#lang racket/base
;; Incomplete elliptic integrals by Carlson's duplication (B. C. Carlson, Numerische
;; Mathematik 33, 1979, 1).
;;
;; R_F(x, y, z) = ½ ∫ ((t + x)(t + y)(t + z))^(−1/2) dt from 0 to infinity and
;; R_D = 3/2 ∫ (t + z)⁻¹ (...)^(−1/2) dt keep their values, or nearly, when
;; λ = √xy + √xz + √yz is added to x, y and z and the sums are divided by 4.  Each time
;; their differences fall to a quarter; a Taylor series about the mean does the rest.
;;
;;     F(φ, k) = s R_F(c², q, 1),  E(φ, k) = F − k² s³/3 R_D(c², q, 1),
;;
;; s = sin φ, c = cos φ, q = 1 − k² s², for |φ| ≤ π/2; beyond that complete integrals
;; add up.  With R_J = 3/2 ∫ (t + p)⁻¹ (...)^(−1/2) dt, which R_C(x, y) = R_F(x, y, y) helps with,
;;
;;     Π(n, φ, k) = F + n s³/3 R_J(c², q, 1, 1 − n s²).

(require "../constants.rkt")

(provide F E Pi)

(define (F phi k) (beyond-quarter first-kind phi k))
(define (E phi k) (beyond-quarter second-kind phi k))
(define (Pi n phi k) (beyond-quarter (lambda (phi k) (third-kind n phi k)) phi k))

(define (beyond-quarter f phi k)
  (define turns (round (/ phi pi)))
  (define rest (f (- phi (* turns pi)) k))
  (if (= turns 0.0) rest (+ rest (* 2.0 turns (f (* 0.5 pi) k)))))

(define (first-kind phi k)
  (define-values (s x q) (arguments phi k))
  (* s (R_F x q 1.0)))

(define (second-kind phi k)
  (define-values (s x q) (arguments phi k))
  (define ks (* k s))
  (- (* s (R_F x q 1.0)) (* s (/ (* ks ks) 3.0) (R_D x q 1.0))))

(define (third-kind n phi k)
  (define-values (s x q) (arguments phi k))
  (define square (* s s))
  (+ (* s (R_F x q 1.0))
     (* n s square 1/3 (R_J x q 1.0 (- 1.0 (* n square))))))

;; q may be nothing but rounding.
(define (arguments phi k)
  (define s (sin phi))
  (define c (cos phi))
  (values s (* c c) (max 0.0 (* (- 1.0 (* k s)) (+ 1.0 (* k s))))))

;; ---------------------------------------------------------------------------

(define near 1e-3)                      ; the series leave out its sixth power

;; How far each is from the mean, beside it
(define-syntax-rule (define-deviations mean [X x] ...)
  (begin (define X (- 1.0 (/ x mean))) ...))

(define (lambda-of x y z)
  (define-values (a b c) (values (sqrt x) (sqrt y) (sqrt z)))
  (+ (* a b) (* a c) (* b c)))

(define (R_F x y z)
  (let loop ([x x] [y y] [z z])
    (define mean (/ (+ x y z) 3.0))
    (define-deviations mean [X x] [Y y] [Z z])
    (cond
      [(< (max (abs X) (abs Y) (abs Z)) near)
       (define e2 (- (* X Y) (* Z Z)))
       (define e3 (* X Y Z))
       (/ (+ 1.0 (* e2 (- (/ e2 24.0) 0.1 (/ (* 3.0 e3) 44.0))) (/ e3 14.0)) (sqrt mean))]
      [else
       (define l (lambda-of x y z))
       (loop (* 0.25 (+ x l)) (* 0.25 (+ y l)) (* 0.25 (+ z l)))])))

(define (R_D x y z)
  (let loop ([x x] [y y] [z z] [sum 0.0] [power 1.0])
    (define mean (/ (+ x y (* 3.0 z)) 5.0))
    (define-deviations mean [X x] [Y y] [Z z])
    (cond
      [(< (max (abs X) (abs Y) (abs Z)) near)
       (define a (* X Y))
       (define b (* Z Z))
       (define e2 (- a (* 6.0 b)))
       (define e3 (* Z (- (* 3.0 a) (* 8.0 b))))
       (define e4 (* 3.0 (- a b) b))
       (define e5 (* a b Z))
       (+ (* 3.0 sum)
          (/ (* power
                (+ 1.0 (* -3/14 e2) (* 1/6 e3) (* 9/88 e2 e2) (* -3/22 e4)
                   (* -9/52 e2 e3) (* 3/26 e5)))
             (* mean (sqrt mean))))]
      [else
       (define l (lambda-of x y z))
       (loop (* 0.25 (+ x l)) (* 0.25 (+ y l)) (* 0.25 (+ z l))
             (+ sum (/ power (* (sqrt z) (+ z l))))
             (* 0.25 power))])))

(define (R_J x y z p)
  (let loop ([x x] [y y] [z z] [p p] [sum 0.0] [power 1.0])
    (define mean (/ (+ x y z p p) 5.0))
    (define-deviations mean [X x] [Y y] [Z z] [P p])
    (cond
      [(< (max (abs X) (abs Y) (abs Z) (abs P)) near)
       (+ (* 3.0 sum) (/ (* power (R_J-series X Y Z P)) (* mean (sqrt mean))))]
      [else
       (define l (lambda-of x y z))
       (define a (+ (* p (+ (sqrt x) (sqrt y) (sqrt z))) (sqrt (* x y z))))
       (loop (* 0.25 (+ x l)) (* 0.25 (+ y l)) (* 0.25 (+ z l)) (* 0.25 (+ p l))
             (+ sum (* power (R_C (* a a) (* p (+ p l) (+ p l)))))
             (* 0.25 power))])))

(define (R_J-series X Y Z P)
  (define a (+ (* X Y) (* X Z) (* Y Z)))
  (define b (* X Y Z))
  (define c (* P P))
  (define e2 (- a (* 3.0 c)))
  (define e3 (+ b (* 2.0 P (- a c))))
  (+ 1.0
     (* e2 (+ -3/14 (* 9/88 e2) (* -9/52 e3)))
     (* b (+ 1/6 (* P (+ -3/11 (* P 3/26)))))
     (* P a (- 1/3 (* P 3/22)))
     (* -1/3 P c)))

(define (R_C x y)
  (let loop ([x x] [y y])
    (define mean (/ (+ x y y) 3.0))
    (define s (/ (- y mean) mean))
    (cond
      [(< (abs s) near)
       (/ (+ 1.0 (* s s (+ 3/10 (* s (+ 1/7 (* s (+ 3/8 (* s 9/22)))))))) (sqrt mean))]
      [else
       (define l (+ (* 2.0 (sqrt x) (sqrt y)) y))
       (loop (* 0.25 (+ x l)) (* 0.25 (+ y l)))])))
