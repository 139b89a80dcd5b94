#lang racket/base
;; Paths of stationary action: SICM 1.4 and its numbers.

(require mechanics
         (only-in mechanics/book L-harmonic)
         "../support/checks.rkt")

(define (greatest-error q)
  (for/fold ([m 0]) ([k (in-range 1001)])
    (define t (* k 1/1000 :pi/2))
    (max m (magnitude (- (q t) (cos t))))))

(define (path n) (find-path (L-harmonic 1 1) 0 1 :pi/2 0 n))

(test-case "the harmonic oscillator: errors for 1 to 5 points between (p. 22)"
  (for ([n '(1 2 3 4 5)]
        [expected '(2.2012e-2 2.3902875e-3 1.6830033e-4 1.092142e-5 5.996e-7)]
        [digits '(1e-6 1e-10 1e-11 1e-11 1e-10)])
    (check-= (greatest-error (path n)) expected digits (format "~a points" n)))
  (check-true (< (greatest-error (path 3)) 1.7e-4) "the book's")
  (check-= (/ (greatest-error (path 3)) (greatest-error (path 4))) 15.4 0.05))

(test-case "the points between, to rounding"
  (for ([points '((0.704726908759999)
                  (0.86482763688188 0.499131312024785)
                  (0.923770770382687 0.707095882776644 0.382811359235426))]
        [n '(1 2 3)])
    (for ([t (linear-interpolants 0 :pi/2 n)] [expected points])
      (check-= ((path n) t) expected 1e-14))))

(test-case "the action that three points reach"
  (check-= (Lagrangian-action (L-harmonic 1 1) (path 3) 0 :pi/2) 5.362656e-7 5e-14))

(test-case "many points"
  (check-true (< (greatest-error (path 10)) 1e-12))
  (check-true (< (greatest-error (path 20)) 1e-9)))

(test-case "no rounding hides the minimum: two ways to the same points"
  ;; a pendulum from the bottom to 1 rad, its solution from the integrator
  (define (L-pendulum s) (+ (* 1/2 (square (velocity s))) (* 9.8 (cos (coordinate s)))))
  (define q (find-path L-pendulum 0 0 0.5 1 12))
  (define end
    ((state-advancer (lambda () (Lagrangian->state-derivative L-pendulum)))
     (up 0 0 ((D q) 0)) 0.5 1e-12))
  (check-= (coordinate end) 1 1e-7)
  (check-= (velocity end) ((D q) 0.5) 1e-6))

(test-case "in two dimensions: a free particle goes straight"
  (define q (find-path (lambda (s) (* 1/2 (square (velocity s)))) 0 (up 1 2) 2 (up 3 -4) 3))
  (for ([t '(0 0.5 1.7 2)])
    (check-true (< (euclidean-norm (- (q t) (up (+ 1 t) (- 2 (* 3 t))))) 1e-8))))

;; L = ẋ²/2 + a cos(ωt) x on paths 4 c t (1 − t): 16 c/3 + a ∫ 4 t (1 − t) cos ωt dt = 0.  A few
;; dozen nodes tell nothing of a force that oscillates so fast.
(test-case "the action is integrated until more nodes change nothing"
  (define-values (a w) (values 1e4 400.0))
  (define (L s) (+ (* 1/2 (square (velocity s))) (* a (cos (* w (time s))) (coordinate s))))
  (define integral (* 4 (- (/ (* 2 (sin w)) (cube w)) (/ (+ 1 (cos w)) (square w)))))
  (check-= ((find-path L 0 0 1 0 1) 1/2) (* -3/16 a integral) 1e-10))

(test-case "several coordinates, in the shape they are given in"
  ;; a throw in uniform gravity is a polynomial: exact with two points or more
  (define (L-gravity s)
    (- (* 1/2 (square (velocity s))) (* 9.8 (ref (coordinate s) 1 0))))
  (define q (find-path L-gravity 1 (up 0 (up 2)) 3 (up 4 (up 1)) 2))
  (for ([t '(1 1.3 2 3)])
    (check-= (ref (q t) 0) (* 2 (- t 1)) 1e-12)
    (check-= (ref (q t) 1 0) (+ 2 (* (- t 1) (+ 9.8 -1/2)) (* -4.9 (square (- t 1)))) 1e-12))
  ;; an oscillator in the plane, two frequencies and a coupling that depends on time
  (define (L-coupled s)
    (define-values (x y) (values (ref (coordinate s) 0) (ref (coordinate s) 1)))
    (- (* 1/2 (square (velocity s))) (* 1/2 (square x)) (* 2 (square y)) (* (time s) x y)))
  (define w (find-path L-coupled 0 (up 1 0) 1 (up 0 1) 8))
  (for ([t '(0.1 0.5 0.8)])
    (for ([residual (((Lagrange-equations L-coupled) w) t)]) (check-= residual 0 1e-5))))

(test-case "the earlier end may come second"
  (define forth (find-path (L-harmonic 1 1) 0 1 1 2 3))
  (define back (find-path (L-harmonic 1 1) 1 2 0 1 3))
  (for ([t '(0 0.3 1)]) (check-equal? (back t) (forth t))))

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
    (multidimensional-minimize (lambda (v) (+ (abs (floor (* 1e6 (- (ref v 0) 1))))
                                              (abs (- (ref v 1) 2))))
                               (up 0 0) #:tolerance 1e-6))
  (check-= (ref found 0) 1 1e-3)
  (check-= (ref found 1) 2 1e-3))

(test-case "Lagrangians that are compiled and those that are not give the same path"
  ;; a test of the time, where there is nothing to decide
  (define ((L-with-a-test m k) (up t q v))
    (if (< t -1) 0 (- (* 1/2 m (square v)) (* 1/2 k (square q)))))
  (define q (find-path (L-with-a-test 1 1) 0 1 :pi/2 0 3))
  (for ([t '(0.1 0.7 1.3)]) (check-= (q t) ((path 3) t) 1e-13)))

;; ---------------------------------------------------------------------------
;; Where there is no path of least action

(define (failure thunk)
  (with-handlers ([exn:fail:mechanics:not-convergent? values]) (thunk) #f))

(test-case "over more than half a period the motion is a saddle point, which is said and carried"
  ;; q = sin(T − t)/sin T from 1 to 0
  (define f (failure (lambda () (find-path (L-harmonic 1 1) 0 1 4 0 8))))
  (check-regexp-match #rx"^find-path: the stationary path does not make the action least: it falls"
                      (exn-message f))
  (check-regexp-match #rx"half a period\n  action of the stationary path: 0.43" (exn-message f))
  (define q (exn:fail:mechanics:not-convergent-value f))
  (for ([t '(0 1 2.5 4)]) (check-= (q t) (/ (sin (- 4 t)) (sin 4)) 1e-4))
  ;; the straight line is the motion here, and no descent leads away from it
  (check-regexp-match #rx"does not make the action least"
                      (exn-message (failure (lambda () (find-path (L-harmonic 1 1) 0 0 4 0 3)))))
  ;; just below and above half a period
  (check-pred procedure? (find-path (L-harmonic 1 1) 0 0 3.1 0 5))
  (check-pred exn? (failure (lambda () (find-path (L-harmonic 1 1) 0 0 3.2 0 5)))))

(test-case "an action without a stationary path"
  (define f (failure (lambda () (find-path (lambda (s) (coordinate s)) 0 1 1 1 2))))
  (check-regexp-match
   #rx"^find-path: the action has no minimum among these paths: it falls without end\n  best value: "
   (exn-message f))
  (check-= ((exn:fail:mechanics:not-convergent-value f) 0.5) 1 1e-14)
  (define none (failure (lambda () (find-path (lambda (s) +nan.0) 0 1 1 1 2))))
  (check-regexp-match #rx": it is not finite there\n" (exn-message none)))

(define (L-quartic s)
  (+ (* 1/2 (square (velocity s))) (expt (coordinate s) 4) (exp (coordinate s))))

(test-case "a search that may take few steps says that it was stopped, and how far it came"
  (define (L-steep s) (+ (* 1/2 (square (velocity s))) (exp (* -20 (coordinate s)))))
  (define f (failure (lambda () (find-path L-steep 0 1 1 -3 4 #:most-steps 2))))
  (check-regexp-match
   #rx"^find-path: the search for the path was stopped after 2 steps\n  action: .*\n  size of its g"
   (exn-message f))
  (define q (exn:fail:mechanics:not-convergent-value f))
  (check-= (q 0) 1 1e-12)
  (check-= (q 1) -3 1e-12)
  ;; where Newton's method gets there, nothing is to be said
  (define few (find-path L-quartic 0 1 1 2 4 #:most-steps 1))
  (define many (find-path L-quartic 0 1 1 2 4))
  (for ([t '(0.2 0.6)]) (check-= (few t) (many t) 1e-7))
  (check-exn #rx"^find-path: expected a number of steps, a positive integer\n  given: the number 0"
             (lambda () (find-path L-quartic 0 1 1 2 4 #:most-steps 0))))

(test-case "a failure of the Lagrangian's own is not taken for one of the search"
  (define (L s)
    (if (> (coordinate s) 1.5)
        (definite-integral (lambda (x) (/ 1 x)) 0 1)
        (square (velocity s))))
  (check-regexp-match #rx"^definite-integral: "
                      (exn-message (failure (lambda () (find-path L 0 1 1 2 2))))))

(test-case "a Lagrangian that jumps in time is not integrated well enough, which is said"
  (define (L s) (+ (square (velocity s)) (* (coordinate s) (if (< (time s) 0.3) 1 0))))
  (define f (failure (lambda () (find-path L 0 1 1 1 2))))
  (check-regexp-match #rx"^find-path: the action of the paths cannot be integrated well enough"
                      (exn-message f))
  (check-true (< 0 (exn:fail:mechanics:not-convergent-error-estimate f) 1e-3))
  ;; to what it can be
  (define q (find-path L 0 1 1 1 2 #:tolerance 1e-4))
  (check-= ((exn:fail:mechanics:not-convergent-value f) 0.5) (q 0.5) 1e-3))

(test-case "a constant action has any path for a minimum"
  (check-= ((find-path (lambda (s) (velocity s)) 0 1 1 2 2) 0.5) 1.5 1e-12))

(test-case "mistakes"
  (check-exn #rx"find-path: .*initial time" (lambda () (find-path (L-harmonic 1 1) 't 1 2 0 3)))
  (check-exn #rx"number of intermediate points"
             (lambda () (find-path (L-harmonic 1 1) 0 1 2 0 1.5)))
  (check-exn #rx"symbol m is left" (lambda () (find-path (L-harmonic 'm 1) 0 1 2 0 2)))
  (check-exn #rx"^find-path: the initial and the final time are the same\n  time: 1"
             (lambda () (find-path (L-harmonic 1 1) 1 0 1 1 2)))
  (check-exn
   #rx"^find-path: expected a coordinate at the final time that is a real number\n  given: the symbol b"
   (lambda () (find-path (L-harmonic 1 1) 0 0 1 'b 2)))
  (check-exn
   #rx"^find-path: expected a coordinate at the initial time that is a real number\n  given: \"here\", a string"
   (lambda () (find-path (L-harmonic 1 1) 0 (up 1 "here") 1 (up 1 2) 2)))
  (check-exn
   #rx"^find-path: the coordinates at the two ends are of different shapes\n  at the initial time: [(]up 0 1[)]\n  at the final time: 0"
   (lambda () (find-path (L-harmonic 1 1) 0 (up 0 1) 1 0 2)))
  (check-exn #rx"^find-path: expected a final time"
             (lambda () (find-path (L-harmonic 1 1) 0 0 +inf.0 1 2)))
  (check-exn #rx"^find-path: .*tolerance"
             (lambda () (find-path (L-harmonic 1 1) 0 0 1 1 2 #:tolerance 0)))
  (check-exn #rx"^find-path: a Lagrangian is a function of the local tuple"
             (lambda () (find-path 3 0 0 1 1 2)))
  (check-exn #rx"^find-path: the value of a Lagrangian is a number"
             (lambda () (find-path coordinate 0 (up 0 1) 1 (up 1 1) 2)))
  (check-exn #rx"the argument does not match the pattern .*expected an up tuple of 2, given 0.0"
             (lambda ()
               (define (L-plane (up t (up x y) v)) (* x y))
               (find-path L-plane 0 0 1 1 2)))
  (check-exn #rx"'quasi-newton or 'nelder-mead"
             (lambda () (multidimensional-minimize sin 0 #:method 'newton)))
  (check-exn #rx"expected real numbers to start from.*given: \"here\", a string"
             (lambda () (multidimensional-minimize sin "here")))
  (check-exn #rx"expected real numbers.*the symbol x"
             (lambda () (multidimensional-minimize sin (quote x)))))
