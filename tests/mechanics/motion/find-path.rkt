#lang racket/base
;; Paths of stationary action: SICM 1.4 and its numbers.

(require (except-in rackunit fail)
         mechanics)

(define ((L-harmonic m k) (up t q v))
  (- (* 1/2 m (square v)) (* 1/2 k (square q))))

(define (greatest-error q)
  (for/fold ([m 0]) ([k (in-range 1001)])
    (define t (* k 1/1000 :pi/2))
    (max m (magnitude (- (q t) (cos t))))))

(define (path n) (find-path (L-harmonic 1 1) 0 1 :pi/2 0 n))

(test-case "the harmonic oscillator: errors for 1 to 5 points between (p. 22)"
  (for ([n '(1 2 3 4 5)] [expected '(2.2012e-2 2.3902875e-3 1.6830033e-4 1.092142e-5 5.996e-7)])
    (check-= (greatest-error (path n)) expected (* 1e-3 expected) (format "~a points" n))))

(test-case "the points between"
  (for ([t (linear-interpolants 0 :pi/2 3)]
        [expected '(0.923770770382687 0.707095882776644 0.382811359235426)])
    (check-= ((path 3) t) expected 1e-8)))

(test-case "ten points"
  (check-true (< (greatest-error (path 10)) 1e-8)))

(test-case "in two dimensions: a free particle goes straight"
  (define q (find-path (lambda (s) (* 1/2 (square (velocity s)))) 0 (up 1 2) 2 (up 3 -4) 3))
  (for ([t '(0 0.5 1.7 2)])
    (check-true (< (euclidean-norm (- (q t) (up (+ 1 t) (- 2 (* 3 t))))) 1e-8))))

(test-case "with the book's own definition of find-path"
  (define (my-find-path L t0 q0 t1 q1 n)
    (make-path t0 q0 t1 q1
               (multidimensional-minimize (parametric-path-action L t0 q0 t1 q1)
                                          (linear-interpolants q0 q1 n))))
  (check-= (greatest-error (my-find-path (L-harmonic 1 1) 0 1 :pi/2 0 3)) 1.6830033e-4 1e-7))

(test-case "the search can be watched"
  (define actions '())
  (find-path (L-harmonic 1 1) 0 1 :pi/2 0 3
             #:observe (lambda (q action)
                         (check-= (q 0) 1 1e-14)
                         (set! actions (cons action actions))))
  (check-true (> (length actions) 3))
  (check-= (car actions) 5.362656e-7 1e-12))

(test-case "no point between is a straight line"
  (check-= ((find-path (L-harmonic 1 1) 0 1 1 3 0) 0.5) 2 1e-14))

(test-case "minima of functions of lists, tuples and numbers"
  (define (f x y) (+ (square (- x 1)) (* 2 (square (+ y 2))) (* 1/2 x y)))
  (define expected (multidimensional-minimize (lambda (v) (f (ref v 0) (ref v 1))) (up 0 0)))
  (check-true (up? expected))
  (for ([slope ((D (lambda (v) (f (ref v 0) (ref v 1)))) expected)]) (check-= slope 0 1e-7))
  (define from-list (multidimensional-minimize (lambda (v) (f (car v) (cadr v))) '(0 0)))
  (check-= (car from-list) (ref expected 0) 1e-8)
  (check-= (multidimensional-minimize (lambda (x) (square (- x 3))) 0) 3 1e-8))

(test-case "functions without a derivative are minimised from their values"
  (define found
    (multidimensional-minimize (lambda (v) (+ (abs (floor (* 1e6 (- (ref v 0) 1)))) (abs (- (ref v 1) 2))))
                               (up 0 0) #:tolerance 1e-6))
  (check-= (ref found 0) 1 1e-3)
  (check-= (ref found 1) 2 1e-3))

(test-case "mistakes"
  (check-exn #rx"find-path: .*initial time" (lambda () (find-path (L-harmonic 1 1) 't 1 2 0 3)))
  (check-exn #rx"number of intermediate points" (lambda () (find-path (L-harmonic 1 1) 0 1 2 0 1.5)))
  (check-exn #rx"symbol m is left" (lambda () (find-path (L-harmonic 'm 1) 0 1 2 0 2)))
  (check-exn #rx"'quasi-newton or 'nelder-mead"
             (lambda () (multidimensional-minimize sin 0 #:method 'newton)))
  (check-exn #rx"expected real numbers to start from.*given \"here\", a string"
             (lambda () (multidimensional-minimize sin "here")))
  (check-exn #rx"expected real numbers.*the symbol x"
             (lambda () (multidimensional-minimize sin (quote x)))))
