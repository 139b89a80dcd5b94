#lang racket/base
;; SICM 1.4, Computing Actions (pp. 14-23).

(require mechanics
         mechanics/book
         (only-in mechanics/plot frame frame-curves plot-function graphics-clear)
         "../support/checks.rkt" "../support/close.rkt" "../support/session.rkt")

(define q (up (literal-function 'x) (literal-function 'y) (literal-function 'z)))

(test-case "p. 15: a literal path, its derivative, its local tuple"
  (check-unsimplified (q 't) '(up (x t) (y t) (z t)))
  (check-unsimplified ((D q) 't) '(up ((D x) t) ((D y) t) ((D z) t)))
  (check-unsimplified ((Gamma q) 't)
                      '(up t (up (x t) (y t) (z t)) (up ((D x) t) ((D y) t) ((D z) t)))))

(test-case "p. 16: the Lagrangian along the path"
  (check-prints ((compose (L-free-particle 'm) (Gamma q)) 't)
                '(* 1/2 m (+ (expt ((D x) t) 2) (expt ((D y) t) 2) (expt ((D z) t) 2)))))

(test-case "p. 14: the listing as it is typed is the same Lagrangian"
  (define ((L-free-particle-typed mass) local)
    (let ((v (velocity local)))
      (* 1/2 mass (dot-product v v))))
  (check-identity ((compose (L-free-particle-typed 'm) (Gamma q)) 't)
                  ((compose (L-free-particle 'm) (Gamma q)) 't)))

(test-case "p. 18: the action of a straight path"
  (check-equal? (test-path 2) (up 15 11 5))
  (check-= (Lagrangian-action (L-free-particle 3.0) test-path 0.0 10.0) 435.0 1e-12)
  (define (another-path t) (up (+ t 7) (+ (* 3 t) 5) (+ (* 2 t) 1)))
  (check-= (Lagrangian-action (L-free-particle 3) another-path 0 10) 210 1e-12)
  (check-= (definite-integral sin 0 pi) 2 1e-12))

(define varied (varied-free-particle-action 3.0 test-path (up sin cos square) 0.0 10.0))

(test-case "p. 18: the action of a varied path is greater"
  (check-= (varied 0.001) (+ 435 18077/14000) 1e-9)
  (check-= (varied 0.001) 436.29121428571153 1e-9 "the number in the book")
  (for ([epsilon '(-1/2 1/4 2)])
    (check-= (varied epsilon) (+ 435 (* 1000000 18077/14000 (square epsilon))) 1e-6)))

(test-case "p. 19: and least where there is no variation"
  (define-values (epsilon action iterations) (apply values (minimize varied -2.0 1.0)))
  (check-= epsilon 0.0 1e-7)
  (check-= action 435.0 1e-9)
  (check-equal? iterations 5))

(test-case "exercise 1.4: the action of a free particle between two positions"
  (define (between xa ta xb tb)
    (Lagrangian-action (L-free-particle 3)
                       (lambda (t) (+ xa (* (- t ta) (/ (- xb xa) (- tb ta))))) ta tb))
  (check-= (between 1 0 5 2) (/ (* 3 (square 4)) (* 2 2)) 1e-12))

(test-case "p. 20: a path through given points"
  (check-prints ((make-path 0 'a 2 'c '(b)) 1) 'b)
  (check-equal? (linear-interpolants 0 1 3) '(1/4 1/2 3/4)))

;; ---------------------------------------------------------------------------
;; Paths of least action

(define (greatest-error q)
  (for/fold ([m 0]) ([k (in-range 501)])
    (define t (* k 1/500 :pi/2))
    (max m (abs (- (q t) (cos t))))))

(test-case "p. 22: find-path comes close to the cosine"
  (define (path n) (find-path (L-harmonic 1.0 1.0) 0. 1. :pi/2 0. n))
  (check-true (< (greatest-error (path 3)) 1.7e-4))
  (for ([n '(1 2 3 4 5)] [expected '(2.2012e-2 2.3902875e-3 1.6830033e-4 1.092142e-5 5.996e-7)])
    (check-= (/ (greatest-error (path n)) expected) 1 1e-3 (format "~a points" n)))
  (check-= ((path 1) (/ :pi 4)) 0.704726908759999 1e-8)
  (for ([t (linear-interpolants 0 :pi/2 2)] [expected '(0.86482763688188 0.499131312024785)])
    (check-= ((path 2) t) expected 1e-8)))

(test-case "p. 21: find-path as the book defines it"
  (define (find-path L t0 q0 t1 q1 n)
    (let ((initial-qs (linear-interpolants q0 q1 n)))
      (let ((minimizing-qs
             (multidimensional-minimize
              (parametric-path-action L t0 q0 t1 q1)
              initial-qs)))
        (make-path t0 q0 t1 q1 minimizing-qs))))
  (check-= (greatest-error (find-path (L-harmonic 1.0 1.0) 0. 1. :pi/2 0. 3)) 1.6830033e-4 1e-8))

(test-case "p. 22: the least action with three points between"
  (define action ((parametric-path-action (L-harmonic 1.0 1.0) 0.0 1.0 :pi/2 0.0)
                  '(0.923770770382687 0.707095882776644 0.382811359235426)))
  (check-= action 5.362656e-7 1e-12))

(test-case "exercise 1.5: the search watched, path by path"
  (define seen '())
  (define (watch path action)
    (check-= (path 0) 1 1e-14)
    (set! seen (cons action seen)))
  (define action
    (parametric-path-action (L-harmonic 1 1) 0 1 :pi/2 0 #:observe watch))
  (multidimensional-minimize action (linear-interpolants 1 0 2) #:method 'nelder-mead)
  (check-true (> (length seen) 20))
  (check-true (< (apply min seen) (list-ref seen (- (length seen) 1)))))

(test-case "exercise 1.5: each path drawn in the place of the one before, as the book does"
  (define win2 (frame 0. :pi/2 0. 1.2))
  (define ((parametric-path-action Lagrangian t0 q0 t1 q1) intermediate-qs)
    (let ((path (make-path t0 q0 t1 q1 intermediate-qs)))
      (graphics-clear win2)
      (plot-function win2 path t0 t1 (/ (- t1 t0) 100))
      (Lagrangian-action Lagrangian path t0 t1)))
  (define qs
    (multidimensional-minimize (parametric-path-action (L-harmonic 1. 1.) 0. 1. :pi/2 0.)
                               (linear-interpolants 1. 0. 2)
                               #:method 'nelder-mead))
  (check-close (list->up qs) '(0.86482763688188 0.499131312024785) 1e-3)
  (check-equal? (length (frame-curves win2)) 1))
