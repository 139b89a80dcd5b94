#lang racket/base
;; Integrals with known values, for tests and for the benchmarks: those that any method of
;; quadrature should do.  The difficult ones are in
;; hard-integrals.rkt and hostile-integrals.rkt.

(provide classic-integrals
         table hard (struct-out entry)
         pi square cosh tanh)

(define pi (* 4.0 (atan 1.0)))
(define e (exp 1.0))
(define Euler-gamma 0.5772156649015329)
(define Catalan 0.915965594177219)
(define zeta-3 1.2020569031595942)
(define (square x) (* x x))
(define (cosh x) (/ (+ (exp x) (exp (- x))) 2))
(define (tanh x) (- 1 (/ 2 (+ 1 (exp (* 2 x))))))

;; size ≈ ∫ |f|, which tolerances refer to; it is
;; the magnitude of the value where it is left out.
(define-syntax-rule (table [name f low high value size ...] ...)
  (list (make-entry name f low high value size ...) ...))

;; A value written as a string is the number, exactly.
(define-syntax-rule (hard [name f low high value size ...] ...)
  (table [name f low high (exact value) size ...] ...))

(define (exact text) (string->number (string-append "#e" text)))

(struct entry (name f low high value size))

(define (make-entry name f low high value [size (abs value)])
  (entry name f low high value size))

(define smooth
  (table
   ["x^5" (lambda (x) (expt x 5)) -1 2 21/2]
   ["1/(1 + x²)" (lambda (x) (/ 1 (+ 1 (* x x)))) 0 1 (/ pi 4)]
   ["e^x cos x" (lambda (x) (* (exp x) (cos x))) 0 (/ pi 2) (/ (- (exp (/ pi 2)) 1) 2)]
   ["x⁴(1 − x)⁴/(1 + x²)" (lambda (x) (/ (* (expt x 4) (expt (- 1 x) 4)) (+ 1 (* x x))))
                           0 1 0.00126448926734961868]        ; 22/7 − π
   ["atan(√(x² + 2))/((x² + 1) √(x² + 2))"       ; Ahmed's
    (lambda (x) (let ([r (sqrt (+ 2 (* x x)))]) (/ (atan r) (* r (+ 1 (* x x)))))) 0 1
    (/ (* 5 pi pi) 96)]
   ["log(1 + x)/(1 + x²)" (lambda (x) (/ (log (+ 1 x)) (+ 1 (* x x)))) 0 1 (* pi (log 2.0) 1/8)]
   ["x/sin x" (lambda (x) (/ x (sin x))) 0 (/ pi 2) (* 2 Catalan)]
   ["1/(5/4 + cos x)" (lambda (x) (/ 1 (+ 5/4 (cos x)))) 0 (* 2 pi) (* 8/3 pi)]
   ["e^(cos x) cos(sin x)" (lambda (x) (* (exp (cos x)) (cos (sin x)))) 0 (* 2 pi) (* 2 pi) 9.0]
   ["sin x over a period" sin 0 (* 2 pi) 0.0 4.0]
   ["x^x" (lambda (x) (expt x x)) 0 1 0.7834305107121344]
   ["the action of a varied path, 435 + 18077/14000"        ; SICM p. 18
    (lambda (t)
      (define (component v f Df) (+ v (* 1e-3 (+ (* (- (* 2 t) 10) f) (* t (- t 10) Df)))))
      (* 3/2 (+ (square (component 4 (sin t) (cos t)))
                (square (component 3 (cos t) (- (sin t))))
                (square (component 2 (* t t) (* 2 t))))))
    0 10 (+ 435 18077/14000)]))

(define peaked
  (table
   ["1/(10⁻⁴ + x²)" (lambda (x) (/ 1 (+ 1e-4 (* x x)))) -1 1 (* 200 (atan 100.0))]
   ["a peak of width 10⁻³" (lambda (x) (/ 1e-3 (+ 1e-6 (square (- x 1/2))))) 0 1
                           (* 2 (atan 500.0))]
   ["1/cosh² with peaks of different widths"
    (lambda (x) (for/sum ([k '(1 2)]) (/ 1 (square (cosh (* (expt 10 k) (- x (* 0.2 k))))))))
    0 1 (for/sum ([k '(1 2)])
          (define w (expt 10 k))
          (/ (- (tanh (* w (- 1 (* 0.2 k)))) (tanh (* w -0.2 k))) w))]
   ["e^(−10⁴ x)" (lambda (x) (* 1e4 (exp (* -1e4 x)))) 0 1 1.0]))

(define oscillating
  (table
   ["cos 1000x" (lambda (x) (cos (* 1000 x))) 0 10 (/ (sin 10000.0) 1000) 6.4]
   ["sin²(300 x)" (lambda (x) (square (sin (* 300 x)))) 0 pi (/ pi 2)]
   ["x cos 50x cos x" (lambda (x) (* x (cos (* 50 x)) (cos x))) 0 (* 2 pi) 0.0 8.0]
   ["e^(−x) cos 30x" (lambda (x) (* (exp (- x)) (cos (* 30 x)))) 0 +inf.0 1/901 0.6]
   ["J₀(2) from Bessel's integral" (lambda (x) (/ (cos (* 2 (sin x))) pi)) 0 pi
                                   0.22389077914123567 0.5]))

(define broken
  (table
   ["|x − 0.3|" (lambda (x) (abs (- x 0.3))) 0 1 0.29]
   ["√|x − 0.3|" (lambda (x) (sqrt (abs (- x 0.3)))) 0 1 (* 2/3 (+ (expt 0.3 1.5) (expt 0.7 1.5)))]
   ["a step at 0.3" (lambda (x) (if (< x 0.3) 1 0)) 0 1 0.3]
   ["floor" floor 0 10 45]
   ["e^x, but 0 from 1/3 on" (lambda (x) (if (< x 1/3) (exp x) 0)) 0 1 (- (exp 1/3) 1)]
   ["|sin x|" (lambda (x) (abs (sin x))) 0 10 (+ 7 (cos 10.0))]))

(define infinite-at-points
  (table
   ["1/√x" (lambda (x) (/ 1 (sqrt x))) 0 1 2]
   ["x^−0.9" (lambda (x) (expt x -0.9)) 0 1 10]
   ["1/√(1 − x²)" (lambda (x) (/ 1 (sqrt (- 1 (* x x))))) -1 1 pi]
   ["1/√(x (1 − x))" (lambda (x) (/ 1 (sqrt (* x (- 1 x))))) 0 1 pi]
   ["log x" log 0 1 -1]
   ["log² x" (lambda (x) (square (log x))) 0 1 2]
   ["log x/√x" (lambda (x) (/ (log x) (sqrt x))) 0 1 -4]
   ["log x/(1 − x)" (lambda (x) (/ (log x) (- 1 x))) 0 1 (/ (* pi pi) -6)]
   ["log x log(1 − x)" (lambda (x) (* (log x) (log (- 1 x)))) 0 1 (- 2 (/ (* pi pi) 6))]
   ["log(−log x)" (lambda (x) (log (- (log x)))) 0 1 (- Euler-gamma) 1.1]
   ["log sin x" (lambda (x) (log (sin x))) 0 (/ pi 2) (* -1/2 pi (log 2.0))]
   ["1/√|x − 0.3|, inside" (lambda (x) (/ 1 (sqrt (abs (- x 0.3))))) 0 1
                           (* 2 (+ (sqrt 0.3) (sqrt 0.7)))]
   ["log|x − 1/2|, inside" (lambda (x) (log (abs (- x 1/2)))) 0 1 (- (+ 1 (log 2.0)))]
   ["the period of a pendulum" (lambda (x) (/ 2 (sqrt (* 19.6 (- (cos x) (cos 1.0)))))) -1 1
                               2.140228719018093]))

(define infinite-ranges
  (table
   ["e^(−x²)" (lambda (x) (exp (- (* x x)))) -inf.0 +inf.0 (sqrt pi)]
   ["e^x" exp -inf.0 1 e]
   ["x^−3/2" (lambda (x) (expt x -1.5)) 1 +inf.0 2]
   ["1/(1 + x²)" (lambda (x) (/ 1 (+ 1 (* x x)))) -inf.0 +inf.0 pi]
   ["e^(−x)/√x" (lambda (x) (/ (exp (- x)) (sqrt x))) 0 +inf.0 (sqrt pi)]
   ["x²/(e^x − 1)" (lambda (x) (/ (* x x) (- (exp x) 1))) 0 700 (* 2 zeta-3)]
   ["e^(−x) log x" (lambda (x) (* (exp (- x)) (log x))) 0 +inf.0 (- Euler-gamma) 1.2]
   ["log x/(1 + x²)" (lambda (x) (/ (log x) (+ 1 (* x x)))) 0 +inf.0 0.0 1.8]
   ["1/((1 + x) √x)" (lambda (x) (/ 1 (* (+ 1 x) (sqrt x)))) 0 +inf.0 pi]
   ["1/cosh x" (lambda (x) (/ 2 (+ (exp x) (exp (- x))))) -inf.0 +inf.0 pi]))

;; The integral of |f| does not exist, or is not much of a measure.
(define slowly-decaying
  (table
   ["sin x/x" (lambda (x) (/ (sin x) x)) 0 +inf.0 (/ pi 2)]
   ["sin³x/x" (lambda (x) (/ (expt (sin x) 3) x)) 0 +inf.0 (/ pi 4)]
   ["sin x/√x" (lambda (x) (/ (sin x) (sqrt x))) 0 +inf.0 (sqrt (/ pi 2))]
   ["cos 20x/√x" (lambda (x) (/ (cos (* 20 x)) (sqrt x))) 0 +inf.0 (sqrt (/ pi 40)) 1.0]
   ["cos x/(1 + x²)" (lambda (x) (/ (cos x) (+ 1 (* x x)))) -inf.0 +inf.0 (/ pi e) 2.0]
   ["x sin x/(1 + x²)" (lambda (x) (/ (* x (sin x)) (+ 1 (* x x)))) 0 +inf.0 (/ pi 2 e)]))

(define classic-integrals
  (append slowly-decaying smooth peaked oscillating broken infinite-at-points infinite-ranges))
