#lang racket/base
;; Zeros of polynomials up to degree 30 have all their digits, and are within their bounds.

(require racket/list
         racket/math
         mechanics/numeric/optimization/complex-zeros
         "../../support/checks.rkt")

;; The coefficients of (x − z₁)(x − z₂)…, from order 0 on
(define (product zeros)
  (for/fold ([c '(1)]) ([z (in-list zeros)])
    (map - (cons 0 c) (append (map (lambda (x) (* z x)) c) '(0)))))

(define (times p q)
  (for/fold ([sum (make-list (+ (length p) (length q) -1) 0)]) ([a (in-list p)] [k (in-naturals)])
    (map + sum (append (make-list k 0) (map (lambda (b) (* a b)) q)
                       (make-list (- (length p) k 1) 0)))))

;; true : exact numbers, or flonums with an error of a rounding
(define (check-zeros coefficients true [tolerance 2.5e-16])
  (define found (complex-zeros coefficients))
  (check-equal? (length found) (length true))
  (for/fold ([left true] #:result (void)) ([b (in-list found)])
    (define z (inexact->exact (bounded-zero b)))
    (define (away x) (magnitude (exact->inexact (- z (inexact->exact x)))))
    (define nearest (argmin away left))
    (define size (magnitude (exact->inexact nearest)))
    (check-true (<= (away nearest) (* tolerance size)) (format "~a ~a" (bounded-zero b) nearest))
    (when (exact? nearest)
      (check-true (<= (away nearest) (bounded-radius b)) (format "~a" (bounded-zero b))))
    (check-true (< (bounded-radius b) (* 1e-14 size)) (format "~a" (bounded-zero b)))
    (remv nearest left)))

(test-case "1 to n, of which flonums lose all digits from degree 18 on"
  (for ([n '(1 2 5 18 25 30)]) (check-zeros (product (range 1 (+ n 1))) (range 1 (+ n 1)))))

(test-case "of all sizes together"
  (define powers (for/list ([k 30]) (expt 1/8 (- k 15))))
  (check-zeros (product powers) powers)
  (check-zeros (list (- (expt 10 30)) 0 0 1)
               (for/list ([k 3]) (make-polar 1e10 (* 2/3 pi k))) 1e-15)
  (define apart '(1/100000000 -1/1000000 1 1000000000000 3+4i 3-4i))
  (check-zeros (product apart) apart))

(test-case "so far out, or so near 0, that their squares are no flonums"
  (for ([k '(150 200 -150 -200)])
    (define z (expt 10 k))
    (check-zeros (list (* z z) 0 1) (list (* +i z) (* -i z)) 1e-15)
    (check-zeros (product (list z (* -3 z) (* 2 z))) (list z (* -3 z) (* 2 z)) 1e-15)
    (define beside-1 (list z (* -3 z) (* 2 z) 1 -3 2))
    (check-zeros (product beside-1) beside-1 1e-15)))

(test-case "of unit size: the roots of 1, and Chebyshev's, of degree 30"
  (check-zeros (append '(-1) (make-list 29 0) '(1))
               (for/list ([k 30]) (make-polar 1.0 (* 1/15 pi k))) 1e-15)
  (define-values (T _before)
    (for/fold ([p '(0 1)] [before '(1)]) ([_ 29])
      (values (map - (cons 0 (map (lambda (c) (* 2 c)) p)) (append before '(0 0))) p)))
  ;; cos, of its angle from the nearest zero, where it has all digits
  (check-zeros T (for/list ([k 30]) (sin (* pi (/ (- (* 2 k) 29) 60)))) 1e-15))

(test-case "near one another, and many times"
  (define near (list 1 (+ 1 (expt 2 -40)) (+ 1 (expt 2 -20)) -1 (+ 2 (expt 2 -30)) 2))
  (check-zeros (product near) near)
  (define many '(1/3 1/3 1/3 1/3 7 7 7 +i -i +i -i -2 100000))
  (check-zeros (product many) many)
  (define root (sqrt 2.0))
  (check-zeros (times '(-2 0 1) (times '(-2 0 1) '(-2 0 1)))
               (list root root root (- root) (- root) (- root))))

(test-case "coefficients may be complex"
  (define zeros '(1+2i 3 -1/2-5i +i +i))
  (check-zeros (product zeros) zeros))

(define (factorial n) (for/product ([k n]) (+ k 1)))

;; Of Σ xᵏ/k!, k ≤ 30, those above the real axis: mpmath's polyroots, at 120 digits
(define upper
  '(#e-9.25902932504888532551310808704+0.727774032077366281347953721689i
    #e-9.08208843125836272814704051086+2.17893179563407007042609941314i
    #e-8.72595608822418811797279524054+3.61674362306588254646452496077i
    #e-8.18597792777067547331571336277+5.03170974077378705405345753209i
    #e-7.4547641832084680518392540022+6.41335589030875492106097343279i
    #e-6.52162197380150613821062899765+7.74968557333611771037017918413i
    #e-5.37164174703565234199108186849+9.0264294087449219714973151378i
    #e-3.98423482019541972534916978225+10.2259484081700059744440548636i
    #e-2.33073486902929567645261638665+11.325531815024679697835789312i
    #e-0.370280080483558751953470593252+12.2945822116653062463932949218i
    #e1.95774865041618700271124207967+13.0896043125935798749900470523i
    #e4.74899439555141163855286519976+13.6444109935233824836635107614i
    #e8.16946874676362354135323057949+13.8483645270049008695462032637i
    #e12.5568915920260131754646340843+13.4876541116811806259467587075i
    #e18.8532260612987769726629068885+12.0198830330649927692956051433i))

(test-case "the exponential's first 30 powers"
  (define (conjugate z) (make-rectangular (real-part z) (- (imag-part z))))
  (check-zeros (for/list ([k 31]) (/ (factorial k)))
               (append upper (map conjugate upper))))

(test-case "real zeros are real, and complex ones come as pairs"
  (define found (map bounded-zero (complex-zeros '(6 -5 0 2 0 0 3 1))))
  (define-values (real others) (partition real? found))
  (check-true (andmap flonum? real))
  (check-equal? (length others) (* 2 (length (remove-duplicates (map real-part others)))))
  (check-= (imag-part (apply + others)) 0.0 0.0))

(test-case "how much a zero moves with the coefficients"
  ;; x² − 2 x + 1 − d has the zeros 1 ± √d
  (define close (complex-zeros (list (- 1 (expt 2 -20)) -2 1)))
  (for ([b (in-list close)])
    (define z (bounded-zero b))
    (check-= (/ (bounded-change b) (/ (+ 1 (* 2 z) (* z z)) (* 2 (expt 2.0 -10)))) 1.0 1e-3)))
