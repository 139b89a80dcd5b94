#lang racket/base
;; Minima that are used to test methods (J. J. Moré, B. S. Garbow and K. E. Hillstrom,
;; ACM Transactions on Mathematical Software 7, 1981, 17), each from its usual start.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/value/structure
         mechanics/search/minimize
         "../support/checks.rkt")

(define (sum . xs) (apply g:+ xs))

;; Σ 100 (x₂ₖ − x₂ₖ₋₁²)² + (1 − x₂ₖ₋₁)² over pairs that overlap, in n variables
(define (Rosenbrock v)
  (for/fold ([s 0]) ([i (in-range (- (s:dimension v) 1))])
    (define x (ref v i))
    (sum s (g:* 100 (g:square (g:- (ref v (+ i 1)) (g:square x)))) (g:square (g:- 1 x)))))

(define (Powell-singular v)
  (define-values (a b c d) (values (ref v 0) (ref v 1) (ref v 2) (ref v 3)))
  (sum (g:square (g:+ a (g:* 10 b))) (g:* 5 (g:square (g:- c d)))
       (g:expt (g:- b (g:* 2 c)) 4) (g:* 10 (g:expt (g:- a d) 4))))

(define (Beale v)
  (define-values (x y) (values (ref v 0) (ref v 1)))
  (for/fold ([s 0]) ([c '(3/2 9/4 21/8)] [k '(1 2 3)])
    (g:+ s (g:square (g:- c (g:* x (g:- 1 (g:expt y k))))))))

(define (Himmelblau v)
  (define-values (x y) (values (ref v 0) (ref v 1)))
  (g:+ (g:square (g:+ (g:square x) y -11)) (g:square (g:+ x (g:square y) -7))))

(define (Wood v)
  (define-values (a b c d) (values (ref v 0) (ref v 1) (ref v 2) (ref v 3)))
  (sum (g:* 100 (g:square (g:- b (g:square a)))) (g:square (g:- 1 a))
       (g:* 90 (g:square (g:- d (g:square c)))) (g:square (g:- 1 c))
       (g:* 10 (g:square (g:+ b d -2))) (g:* 1/10 (g:square (g:- b d)))))

(define (Freudenstein-Roth v)
  (define-values (x y) (values (ref v 0) (ref v 1)))
  (define (part c) (g:+ x (g:* y c)))
  (g:+ (g:square (g:+ -13 (part (g:- (g:* (g:- 5 y) y) 2))))
       (g:square (g:+ -29 (part (g:- (g:* (g:+ y 1) y) 14))))))

(define (Brown-badly-scaled v)
  (define-values (x y) (values (ref v 0) (ref v 1)))
  (sum (g:square (g:- x 1e6)) (g:square (g:- y 2e-6)) (g:square (g:- (g:* x y) 2))))

(define (helical-valley v)
  (define-values (x y z) (values (ref v 0) (ref v 1) (ref v 2)))
  (define turn (g:/ (g:atan y x) (* 8 (atan 1.0))))
  (sum (g:* 100 (g:square (g:- z (g:* 10 turn))))
       (g:* 100 (g:square (g:- (g:sqrt (g:+ (g:square x) (g:square y))) 1)))
       (g:square z)))

(define (start n) (vector->up (for/vector ([i n]) (if (even? i) -1.2 1.0))))
(define (ones n) (vector->up (make-vector n 1.0)))

;; (name function start argument value distance): how far off the argument may be
(define table
  (append
   (for/list ([n '(2 3 5 10 20)])
     ;; beyond three variables there is another minimum, near (−1, 1, 1 …)
     (list (format "Rosenbrock in ~a" n) Rosenbrock
           (if (<= n 3) (start n) (vector->up (make-vector n 0.5))) (ones n) 0 1e-6))
   (list
    (list "Powell's singular function" Powell-singular (up 3 -1 0 1) (up 0 0 0 0) 0 1e-2)
    (list "Beale" Beale (up 1 1) (up 3 1/2) 0 1e-6)
    (list "Himmelblau" Himmelblau (up 1 1) (up 3 2) 0 1e-6)
    (list "Himmelblau, another" Himmelblau (up -1 -1)
          (up -3.779310253377747 -3.283185991286170) 0 1e-6)
    (list "Wood" Wood (up -3 -1 -3 -1) (up 1 1 1 1) 0 1e-6)
    (list "Freudenstein and Roth" Freudenstein-Roth (up 1/2 -2)
          (up 11.412778986902 -0.896805253274) 48.984253679240 1e-5)
    (list "the helical valley" helical-valley (up -1 0.1 0) (up 1 0 0) 0 1e-6))))

(define (distance v w)
  (for/fold ([m 0]) ([i (in-range (s:dimension v))]) (max m (abs (- (ref v i) (ref w i))))))

(for ([example (in-list table)])
  (define-values (name f start expected least off) (apply values example))
  (test-case (format "~a, from gradients" name)
    (define (near? x y slope count)
      (check-true (<= (distance x expected) off) (format "~a at ~a" y x))
      (check-= y least 1e-9)
      (check-true (< slope 1e-3) (format "gradient ~a" slope))
      (check-true (< count 400) (format "~a evaluations" count)))
    (with-called ([report near?])
      (multidimensional-minimize f start #:report report))))

(for ([example (in-list table)] #:when (<= (s:dimension (caddr example)) 4))
  (define-values (name f start expected least off) (apply values example))
  (test-case (format "~a, from values" name)
    (define-values (x y count) (apply values (nelder-mead f start)))
    (check-true (<= (distance x expected) (max off 1e-4)) (format "~a at ~a" y x))
    (check-= y least 1e-7)
    (check-true (< count 3000) (format "~a evaluations" count))))

(test-case "variables of sizes 10⁶ and 10⁻⁶ (Brown)"
  (define x (multidimensional-minimize Brown-badly-scaled (up 1 1) #:tolerance 1e-12))
  (check-= (ref x 0) 1e6 1)
  (check-= (Brown-badly-scaled x) 0 1e-6))

(test-case "the table is checked: another point is no minimum"
  (for ([example (in-list table)])
    (define-values (name f start expected least off) (apply values example))
    (check-= (f expected) least 1e-8)
    (check-true (> (f start) (+ least 1e-3)))))
