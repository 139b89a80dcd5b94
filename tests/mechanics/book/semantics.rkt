#lang racket/base
;; Habits of the book's listings, point by point, through the public module.

(require mechanics
         "../support/checks.rkt" "../support/close.rkt" "../support/session.rkt")

(define x (literal-function 'x))
(define y (literal-function 'y))

(test-case "1. tuples are procedures; vectors count as up; ref chains and applies to functions"
  (check-prints ((up x y) 't) '(up (x t) (y t)))
  (check-prints ((vector x y) 't) '(up (x t) (y t)))
  (check-prints (+ #(1 2) (up 'a 'b)) '(up (+ 1 a) (+ 2 b)))
  (check-equal? (ref (up 1 (up 2 3)) 1 0) 2)
  (check-prints ((ref (lambda (t) (up (x t) (y t))) 1) 't) '(y t))
  (check-prints ((component 0) (up 'a 'b)) 'a))

(test-case "2. arithmetic on functions, curried and of several arguments"
  (define (T m) (lambda (v) (* 1/2 m (square v))))
  (define (U m) (lambda (v) (* m v)))
  (define L (- T U))
  (check-prints (- ((L 'm) 'v) (- ((T 'm) 'v) ((U 'm) 'v))) 0)
  (check-prints ((+ x (* 'epsilon y)) 't) '(+ (* epsilon (y t)) (x t)))
  (check-prints ((compose cube sin) 'a) '(expt (sin a) 3))
  (check-prints ((* cube sin) 'a) '(* (expt a 3) (sin a)))
  (check-prints ((+ (lambda (a b) (* a b)) (lambda (a b) b)) 2 'b) '(* 3 b)))

(test-case "3. operators: powers, products, multiples, commutators"
  (check-unsimplified (((expt D 2) x) 't) '(((expt D 2) x) t))
  (check-prints (((square D) x) 't) '(((expt D 2) x) t))
  (check-prints (((* (+ D I) (- D I)) x) 't) '(- (((expt D 2) x) t) (x t)))
  (check-prints (((square (partial 2)) (lambda (s) (cube (ref s 2)))) (up 't 'q 'v)) '(* 6 v))
  (check-prints (((commutator D (lambda (t) t)) x) 't) '(x t)))

(test-case "4. derivatives of functions of anything to anything"
  (check-prints ((D (lambda (s) (up (* (ref s 0) (ref s 1)) (square (ref s 0))))) (up 'a 'b))
                '(down (up b (* 2 a)) (up a 0)))
  (check-prints ((D (lambda (a b) (* a (square b)))) 'a 'b) '(down (expt b 2) (* 2 a b)))
  (check-prints (((D (lambda (a) (lambda (b) (sin (* a b))))) 'a) 'b) '(* b (cos (* a b))))
  (check-prints ((D (lambda (s) (* (ref s 0) (ref s 1)))) (down 'p 'q)) '(up q p))
  (check-prints ((D (lambda (s) (* (ref s 1) (ref s 0)))) (up (up 'x 'y) (down 'p 'q)))
                '(down (down p q) (up x y)))
  (check-unsimplified ((D (lambda (t) (matrix-by-rows (list t 1) (list 0 (* t 2))))) 'a)
                      '(matrix-by-rows (list 1 0) (list 0 2))))

(test-case "5. a down of downs where a matrix is meant"
  (define (T local) (* 1/2 (+ (* 'A (square (ref local 2 0))) (* 'B (square (ref local 2 1))))))
  (check-prints (determinant (((square (partial 2)) T) (up 't (up 'x 'y) (up 'vx 'vy)))) '(* A B))
  (check-prints (transpose (matrix-by-rows '(a b) '(c d))) '(matrix-by-rows (list a c) (list b d))))

(test-case "6. literal functions: values and derivatives in the book's form"
  (define F (literal-function 'F (-> (X Real Real) Real)))
  (define V '(-> (UP Real Real) Real))
  (check-unsimplified ((D x) 't) '((D x) t))
  (check-unsimplified (((partial 1) F) 'x 'y) '(((partial 1) F) x y))
  (check-unsimplified ((literal-function 'V V) (up 'x 'y)) '(V (up x y)))
  (check-unsimplified ((literal-function 'q (-> Real (UP Real Real))) 't) '(up (q^0 t) (q^1 t))))

(test-case "7. symbols are numbers"
  (check-true (= 'a 'a))
  (check-false (= 'a 'b))
  (check-false (zero? (- 'a 'b)))
  (check-prints (+ (up 't (up 'x 'y)) (up 1 (up 2 3))) '(up (+ 1 t) (up (+ 2 x) (+ 3 y))))
  (check-exn #rx"^<: " (lambda () (< 'a 1))))

(test-case "8. exactness is kept"
  (check-eqv? (/ 4 2) 2)
  (check-prints (* 1/2 'm) '(* 1/2 m))
  (check-eqv? (expt 2 -2) 1/4)
  (check-eqv? ((D square) 1/3) 2/3))

(test-case "9. Gamma has an optional length, F->C works for any"
  (check-unsimplified ((Gamma x 4) 't) '(up t (x t) ((D x) t) (((expt D 2) x) t)))
  (check-prints (- ((F->C (lambda (local) (square (coordinate local)))) (up 't 'q 'v 'a))
                   (up 't (square 'q) (* 2 'q 'v) (+ (* 2 'a 'q) (* 2 (square 'v)))))
                '(up 0 0 0 0))
  (check-equal? (vector-length (up 't 'q 'v 'a)) 4))

(test-case "10. minimize returns a list of three, find-path takes six, integrals a tolerance"
  (define (L local) (* 1/2 (- (square (velocity local)) (square (coordinate local)))))
  (define found (minimize (lambda (x) (+ 3 (square (- x 1)))) -2.0 4.0))
  (check-equal? (length found) 3)
  (check-close (list->up (list (car found) (cadr found))) '(1 3) 1e-7)
  (check-pred exact-positive-integer? (caddr found))
  (check-= ((find-path L 0. 1. :pi/2 0. 2) 0.5) (cos 0.5) 3e-3)
  (check-= (definite-integral sin 0 :pi 1e-3) 2 1e-3)
  (check-= (Lagrangian-action L sin 0 :pi/2 1e-3) 0 1e-3))

(test-case "11. evolve and state-advancer take parameters, then states"
  (define (oscillator m k)
    (lambda (state) (up 1 (velocity state) (* -1 (/ k m) (coordinate state)))))
  (define seen '())
  (define last
    ((evolve oscillator 1 4) (up 0 1 0) (lambda (s) (set! seen (cons (time s) seen))) 0.25 1 1e-12))
  (check-equal? (reverse seen) '(0.0 0.25 0.5 0.75 1.0))
  (check-close last (list 1 (cos 2) (* -2 (sin 2))) 1e-11)
  (check-close ((state-advancer oscillator 1 4) (up 0 1 0) 1 1e-12)
               (list 1 (cos 2) (* -2 (sin 2))) 1e-11)
  (define method (ode-integration-method))
  (set-ode-integration-method! 'qcrk4)
  (check-eq? (ode-integration-method) 'qcrk4)
  (set-ode-integration-method! method))

(test-case "13. series of functions, with operators and structures"
  (define s (series (lambda (q) (up q 0)) (* 'epsilon (lambda (q) (up 0 (square q))))))
  (check-prints (series:sum (s 'q) 1) '(up q (* epsilon (expt q 2))))
  (define shown '())
  (series:for-each (lambda (term) (set! shown (cons (simplify term) shown)))
                   (((exp (* 'h D)) (literal-function 'f)) 'x) 3)
  (check-equal? (map expression (reverse shown))
                '((f x) (* h ((D f) x)) (* 1/2 (expt h 2) (((expt D 2) f) x))))
  (check-prints (series:sum (((exp (* 'h D)) cube) 'x) 3)
                '(+ (expt h 3) (* 3 (expt h 2) x) (* 3 h (expt x 2)) (expt x 3))))

(test-case "14. constants"
  (check-= :pi (* 2 (asin 1.0)) 1e-15)
  (check-equal? (list :-pi :pi/2 :2pi) (list (- :pi) (/ :pi 2) (* 2 :pi))))

(test-case "p. 71: functions with structures as values are solved for"
  (define (M local) (down (down 'a 0) (down 0 (velocity local))))
  (check-prints ((solve-linear-left M (lambda (local) (down (coordinate local) 1))) (up 't 'q 'v))
                '(up (/ q a) (/ 1 v))))
