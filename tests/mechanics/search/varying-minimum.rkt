#lang racket/base
;; Derivatives of minima by what the function depends on.

(require mechanics/calculus/derivative
         mechanics/calculus/gradient
         mechanics/error/failure
         mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/search/find-root
         mechanics/search/minimize
         mechanics/search/minimum
         mechanics/search/numeric-derivative
         mechanics/value/structure
         "../support/checks.rkt")

;; Least at x = -(a/4)^(1/3)
(define ((tilted a) x) (g:+ (g:expt x 4) (g:* a x)))

;; Every way to ask for the place and for the value
(define places
  (list (lambda (a) (car (minimize (tilted a) -3 1)))
        (lambda (a) (car (brent-min (tilted a) -3 1)))
        (lambda (a) (car (golden-section-min (tilted a) -3 1)))
        (lambda (a) (multidimensional-minimize (tilted a) -1))
        (lambda (a) (car (nelder-mead (tilted a) -1)))
        (lambda (a) (minimum-argument (find-minimum (tilted a) -3 1)))
        (lambda (a) (minimum-argument (find-minimum (tilted a) -1)))
        (lambda (a) (minimum-argument (car (minima (tilted a) -3 1))))))

(define least-values
  (list (lambda (a) (cadr (minimize (tilted a) -3 1)))
        (lambda (a) (minimum-value (find-minimum (tilted a) -1)))
        (lambda (a) (multidimensional-minimize (tilted a) -1 #:report (lambda (x y . more) y)))))

(test-case "of the place and of the value, once and twice, against the formula"
  (for ([place places])
    (define x (- (expt 1/2 1/3)))
    (check-= ((D place) 2) (/ -1 (* 12 x x)) 1e-9)
    ;; x = -(a/4)^(1/3), x'' = 2/9 (1/4)^(1/3) a^(-5/3)
    (check-= ((D (D place)) 2) (* 2/9 (expt 1/4 1/3) (expt 2.0 -5/3)) 1e-8)
    (check-= (((g:expt D 2) place) 2) (* 2/9 (expt 1/4 1/3) (expt 2.0 -5/3)) 1e-8))
  (for ([value least-values])
    (define x (- (expt 1/2 1/3)))
    (check-= ((D value) 2) x 1e-9)
    (check-= ((D (D value)) 2) (/ -1 (* 12 x x)) 1e-9)))

;; A function of two variables and two parameters without a formula for its minimum
(define ((dented a) v)
  (define-values (x y) (values (ref v 0) (ref v 1)))
  (g:+ (g:square (g:- x (ref a 0))) (g:* 2 (g:square (g:- y (g:* (ref a 1) x))))
       (g:exp (g:* 1/4 x y))))

(test-case "in several variables, against differences"
  (define (place a) (multidimensional-minimize (dented a) (up 1 1) #:tolerance 1e-12))
  (define at (up 0.7 1.3))
  (for* ([i 2] [k 2])
    (define (along s) (ref (place (if (= i 0) (up s 1.3) (up 0.7 s))) k))
    (define exact (ref ((D place) at) i k))
    (check-= exact ((D-numeric along #:tolerance 1e-9) (ref at i)) 1e-8))
  (define slopes ((gradient (lambda (a) (minimum-value (find-minimum (dented a) (up 1 1))))) at))
  (define found (place at))
  (for ([i 2])
    (check-= (ref slopes i) (ref ((D (lambda (a) ((dented a) found))) at) i) 1e-12)))

(test-case "a place given as a list"
  (define (place a)
    (car (multidimensional-minimize (lambda (v) (g:square (g:- (car v) (g:* a a)))) '(0))))
  (check-= ((D place) 3) 6 1e-12))

(test-case "at an end the place is the end"
  (define (least a) (minimize (lambda (x) (g:* a x)) (g:square a) 10))
  (check-= ((D (lambda (a) (car (least a)))) 2.0) 4 1e-15)
  (check-= ((D (lambda (a) (cadr (least a)))) 2.0) 12 1e-15)
  (check-= ((D (lambda (a) (car (minimize (lambda (x) (g:- (g:* a x))) 1 (g:* 3 a))))) 2.0)
           3 1e-15))

(define (refusal thunk)
  (with-handlers ([exn:fail:mechanics:singular? exn-message]) (thunk) #f))

(test-case "where the minimum does not move smoothly the reason is said"
  (define (of make . where) ((D (lambda (a) (car (apply minimize (make a) where)))) 0))
  (for ([make (list (lambda (a) (lambda (x) (g:abs (g:- x a))))
                    (lambda (a) (lambda (x) (g:+ (g:expt x 4) (g:* a x x))))
                    (lambda (a) (lambda (x) (g:square (g:- x a))))
                    (lambda (a) (lambda (x) (g:* a 0.0 x))))]
        [low '(-3 -3 0 -3)]
        [reason '("at a kink of the function" "degenerate" "at an end of the interval" "flat")])
    (define said (refusal (lambda () (of make low 1))))
    (check-true (and said (regexp-match? #rx"^minimize: the minimum has no derivative: " said)
                     (regexp-match? reason said))
                (format "~a: ~a" reason said))))

;; ---------------------------------------------------------------------------
;; Roots

(test-case "a root where the function's own derivative vanishes has none, found to rounding or not"
  ;; x^2 = a at a = 0; (x - 1)^2 = a written out
  (for ([f (list (lambda (a) (lambda (x) (g:- (g:square x) a)))
                 (lambda (a) (lambda (x) (g:- (g:+ (g:square x) (g:* -2 x) 1) a))))])
    (check-regexp-match #rx"^find-root: the root has no derivative"
                        (or (refusal (lambda () ((D (lambda (a) (find-root (f a) 0.4))) 0))) ""))))

(test-case "a root in small units has one"
  (define (root a) (find-root (lambda (x) (g:- (g:square x) a)) 1e-10))
  (check-= (* 1e-10 ((D root) 1e-20)) 1/2 1e-9))
