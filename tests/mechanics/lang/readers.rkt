#lang mechanics
;; Habits that readers of the book bring with them from scmutils: the forms that it takes, the
;; operations that it has, its names; each with what is expected of it here.

(require mechanics/scmutils
         (except-in "../support/checks.rkt" check)
         "../support/close.rkt" "../support/messages.rkt" "../support/session.rkt")

;; [expression datum] : the value, simplified, is that expression.
(define-syntax-rule (prints [expression expected] ...)
  (begin (test-case (format "~s" 'expression) (check-prints expression 'expected)) ...))

;; [expression number ...] : the numbers of the value are these.
(define-syntax-rule (comes-close [expression expected] ...)
  (begin (test-case (format "~s" 'expression) (check-near expression expected)) ...))

(define (check-near value expected)
  (check-close (numbers-of value) (numbers-of expected) 1e-12))

;; The parts of the numbers in lists, tuples and matrices.
(define (numbers-of value)
  (cond [(list? value) (apply append (map numbers-of value))]
        [(structure? value) (numbers-of (structure->list value))]
        [(matrix? value)
         (numbers-of (for/list ([i (m:num-rows value)]) (m:nth-row value i)))]
        [else (list (real-part value) (imag-part value))]))

(define x (literal-function 'x))
(define y (literal-function 'y))
(define ((L m k) (up t q v)) (- (* 1/2 m (square v)) (* 1/2 k (square q))))
(define A (down (up 'a 'b) (up 'c 'd)))
(define z (make-rectangular 'x 'y))

;; ---------------------------------------------------------------------------
;; Signatures

(prints
 [((literal-function 'F (-> (UP* Real) Real)) (up 'x 'y)) (F (up x y))]
 [((literal-function 'F '(-> (UP* Real) Real)) (up 'x 'y 'z)) (F (up x y z))]
 [((literal-function 'F (-> (DOWN* Real) Real)) (down 'x 'y)) (F (down x y))]
 [((literal-function 'F (-> (X* Real) Real)) 'x 'y 'z) (F x y z)]
 [(((partial 1) (literal-function 'F (-> (X* Real) Real))) 'x 'y) (((partial 1) F) x y)]
 [((literal-function 'F (-> (^ Real 3) Real)) 'x 'y 'z) (F x y z)]
 [((literal-function 'F '(-> (^ Real 3) Real)) 'x 'y 'z) (F x y z)]
 [((literal-function 'F (-> (^ (UP Real Real) 2) Real)) (up 1 2) (up 3 4)) (F (up 1 2) (up 3 4))]
 [((literal-function 'F (-> (UP Real (UP* Real) (UP* Real)) Real)) (up 't 'q 'v)) (F (up t q v))]
 [((literal-function 'L (Lagrangian)) (up 't (up 'x 'y) (up 'u 'v))) (L (up t (up x y) (up u v)))]
 [((literal-function 'H (Hamiltonian)) (up 't (up 'x 'y) (down 'p 'q)))
  (H (up t (up x y) (down p q)))]
 [((D (literal-function 'F (-> (UP* Real) Real))) (up 'x 'y))
  (down (((partial 0) F) (up x y)) (((partial 1) F) (up x y)))]
 [(s:length (((Lagrange-equations (literal-function 'L (Lagrangian))) (up x y)) 't)) 2]
 [(((literal-function 'f (-> Real (-> Real Real))) 'x) 'y) (f x y)]
 [(((D (literal-function 'f (-> Real (-> Real Real)))) 'x) 'y) (((partial 0) f) x y)]
 [((D ((literal-function 'f (-> Real (-> Real Real))) 'x)) 'y) (((partial 1) f) x y)]
 [((((literal-function 'f (-> Real (-> Real (-> Real Real)))) 'x) 'y) 'z) (f x y z)])

(says
 [((literal-function 'L (Lagrangian)) (up 't (up 'x 'y) 'v))
  "L: was declared (-> (UP Real (UP* Real) (UP* Real)) Real); slot 0 got "
  "(up t (up x y) v), an up tuple of 3"]
 [((literal-function 'F (-> (X* Real) Real)))
  "F: was declared (-> (X* Real) Real), which takes at least 1 argument; given 0: ()"]
 [(literal-function 'F (-> Real (UP* Real)))
  "literal-function: the range needs a count, as in (-> Real (UP* Real 2))\n  given: (UP* Real)"]
 [((literal-function 'f (-> Real (-> Real Real))) (up 1 2))
  "f: was declared (-> Real (-> Real Real)); slot 0 got (up 1 2), an up tuple of 2\n"
  "  a signature such as (-> (UP Real Real) Real) declares a function of tuples"]
 [(literal-function 'f (-> (X* Real) (-> Real Real)))
  "literal-function: a function whose values are functions has a known number of arguments\n"
  "  given: (-> (X* Real) (-> Real Real))"])

;; ---------------------------------------------------------------------------
;; Local tuples and coordinates

(prints
 [((generalized-LE (L 'm 'k)) (up 't 'x 'v 'a)) (+ (* a m) (* k x))]
 [((generalized-LE (L 'm 'k)) (up 't (up 'x 'y) (up 'u 'v) (up 'a 'b)))
  (down (+ (* a m) (* k x)) (+ (* b m) (* k y)))]
 [((generalized-LE (lambda (s) (* 1/2 (square (acceleration s))))) (up 't 'x 'v 'a 'j 's)) s]
 [(((generalized-LE (L 'm 'k) #:order 1) x) 't) (+ (* k (x t)) (* m (((expt D 2) x) t)))]
 [(polar->rectangular (up 'r 'phi)) (up (* r (cos phi)) (* r (sin phi)))]
 [(p->r (up 't (up 'r 'phi) (up 'rdot 'phidot))) (up (* r (cos phi)) (* r (sin phi)))]
 [(rectangular->polar (up 'x 'y)) (up (sqrt (+ (expt x 2) (expt y 2))) (atan y x))]
 [(spherical->rectangular (up 'r 'theta 'phi))
  (up (* r (cos phi) (sin theta)) (* r (sin phi) (sin theta)) (* r (cos theta)))]
 [(s->r (up 't (up 'r 'theta 'phi) (up 'a 'b 'c)))
  (up (* r (cos phi) (sin theta)) (* r (sin phi) (sin theta)) (* r (cos theta)))]
 [(ref (rectangular->spherical (up 3 4 0)) 0) 5])

(says
 [((generalized-LE (L 'm 'k)) (up 't 'x 'v))
  "generalized-LE: expected a path or a local tuple of 4 or 6 or ... components: (up t q v a)\n"
  "  given: (up t x v), an up tuple of 3"]
 [(polar->rectangular (up 't 'r 'v))
  "p->r: expected a local tuple with 2 coordinates; given (up t r v), an up tuple of 3"]
 [(substitute 3 'a (+ 'a 'b))
  "substitute: there is nothing to replace in the number 3; the expression comes first here: "
  "(substitute (+ a b) 'a 3)"]
 [(substitute 3 (x 't) (+ 1 (x 't)))
  "substitute: there is nothing to replace in the number 3; the expression comes first here: "
  "(substitute (+ 1 (x t)) (x t) 3)"])

(prints
 [(substitute 3 'a 'b) 3]
 [(substitute (up 3 'a) 'a (+ 'a 1)) (up 3 (+ 1 a))])

;; ---------------------------------------------------------------------------
;; Operations

(prints
 [(/ (up 5 11) (down (up 1 2) (up 2 5))) (up 3 1)]
 [(simplify (* A (/ (up 'x 'y) A))) (up x y)]
 [(simplify (* A (/ A A))) (down (up a b) (up c d))]
 [(simplify (* (invert A) A)) (down (up 1 0) (up 0 1))]
 [(invert (up (down 2 0) (down 0 4))) (up (down 1/2 0) (down 0 1/4))]
 [(invert (down (down 2 0) (down 0 4))) (up (up 1/2 0) (up 0 1/4))]
 [(* 2 (/ 3 (down (down 2 0) (down 0 4)))) (up (up 3 0) (up 0 3/2))]
 [((/ (lambda (t) (up t 2)) (lambda (t) (down (up 1 0) (up 0 t)))) 3) (up 3 2/3)]
 [(magnitude (up 3 4)) 5]
 [(abs (down 3 (up 4 12))) 13]
 [(magnitude (up 3+4i 12)) 13]
 [(abs (up 'x 'y)) (sqrt (+ (expt x 2) (expt y 2)))]
 [((D (lambda (t) (abs (up t 1)))) 0) 0]
 [(ref (list 1 '(2 3)) 1 -1) 3]
 [(ref (matrix-by-rows '(a b) '(c d)) 0 1) b]
 [(ref (matrix-by-rows '(a b) '(c d)) 1) (down c d)]
 [(vector->list (up 1 2)) (1 2)]
 [(vector->list #(1 2)) (1 2)]
 [(vector-map sin (down 'a 'b)) (down (sin a) (sin b))]
 [(vector-map + (up 1 2) #(3 4)) (up 4 6)]
 [(exp (matrix-by-rows '(0 t) '(0 0))) (matrix-by-rows (list 1 t) (list 0 1))]
 [(exp (matrix-by-rows '(0 1 2) '(0 0 3) '(0 0 0)))
  (matrix-by-rows (list 1 1 7/2) (list 0 1 3) (list 0 0 1))]
 [(exp (matrix-by-rows '(a 0) '(0 b))) (matrix-by-rows (list (exp a) 0) (list 0 (exp b)))]
 [((matrix-by-rows (list sin cos) (list + *)) 't)
  (matrix-by-rows (list (sin t) (cos t)) (list t t))]
 [(transpose (up 'x 'y)) (down x y)]
 [(transpose (down 'x 'y)) (up x y)]
 [(zero-like (matrix-by-rows '(a b))) (matrix-by-rows (list 0 0))]
 [((zero-like (lambda (t) (up t 1))) 't) (up 0 0)]
 [(((zero-like D) x) 't) 0]
 [(inner-product (up +i 2) (up +i 'x)) (+ 1 (* 2 x))]
 [(inner-product (up 'x 'y) (up 'x 'y)) (+ (expt x 2) (expt y 2))]
 [(outer-product (up 'a 'b) (up (down 1 2) (down 3 4)))
  (up (down (up a b) (up (* 2 a) (* 2 b))) (down (up (* 3 a) (* 3 b)) (up (* 4 a) (* 4 b))))]
 [(outer-product (up 'a 'b) (down 'x 'y)) (down (up (* a x) (* b x)) (up (* a y) (* b y)))])

(comes-close
 [(exp (matrix-by-rows '(0 1) '(-1 0)))
  (matrix-by-rows (list (cos 1.0) (sin 1.0)) (list (- (sin 1.0)) (cos 1.0)))]
 [(exp (matrix-by-rows '(0 30.0) '(-30.0 0)))
  (matrix-by-rows (list (cos 30.0) (sin 30.0)) (list (- (sin 30.0)) (cos 30.0)))]
 [(exp (matrix-by-rows '(1.0 1) '(0 1))) (matrix-by-rows (list (exp 1.0) (exp 1.0))
                                                         (list 0.0 (exp 1.0)))]
 [((D (lambda (t) (exp (matrix-by-rows (list 0 t) (list (- t) 0))))) 0.3)
  (matrix-by-rows (list (- (sin 0.3)) (cos 0.3)) (list (- (cos 0.3)) (- (sin 0.3))))]
 [(elliptic-integral-F 0.3 1.5) (/ (elliptic-integral-F (asin (* 1.5 (sin 0.3))) (/ 1 1.5)) 1.5)])

(says
 [(/ (up 1 2) (up 3 4))
  "/: cannot divide an up tuple of 2 by an up tuple of 2\n"
  "  argument 1: (up 1 2), an up tuple of 2\n  argument 2: (up 3 4), an up tuple of 2"]
 [(exp (matrix-by-rows '(a b) '(c d)))
  "exp: the exponential of a matrix is known if it is diagonal or nilpotent, or if its entries "
  "are numbers; given (matrix-by-rows (list a b) (list c d))"]
 [((matrix-by-rows (list sin 3)) 't)
  "application: a matrix applies its entries to the arguments, but the entry 3 of "
  "(matrix-by-rows (list sin 3)) is not a function"]
 [(vector-map + (up 1 2) (up 3)) "vector-map: the tuples differ in length: (2 1)"]
 [(vector-map + 3) "vector-map: expected tuples or vectors\n  given: the number 3"]
 [(ref '(1 2) 4) "ref: index 4 is outside a list (indices 0 to 1)\n  in: (1 2)"])

;; ---------------------------------------------------------------------------
;; Optional arguments

(comes-close
 [(newton-search (lambda (x receive) (receive (- (square x) 2) (* 2 x))) 1.0) (sqrt 2.0)]
 [(newton-search (lambda (x) (- (square x) 2)) 1.0 1e-10) (sqrt 2.0)]
 [(bisect (lambda (x) (- (square x) 2)) 1.0 2.0 1e-14) (sqrt 2.0)])

(test-case "nelder-mead returns what it has at its limit"
  (define result (nelder-mead (lambda (v) (square (- (ref v 0) 1))) (up -3 0) 1 1e-10 9))
  (check-true (<= 9 (ref result 2) 12))
  (check-true (< (ref result 1) 16)))

(prints
 [((make-operator D 'derivative 'scalar 1) sin) (derivative sin)]
 [(((make-operator D 'd 'scalar 1) sin) 't) (cos t)]
 [(series:head (series:generate (lambda (k) k) 1) 3) (0 1 2)])

(says
 [(nelder-mead square 1.0 1 1e-8 0)
  "nelder-mead: expected a number of evaluations, a positive integer\n"
  "  given: the number 0"])

;; ---------------------------------------------------------------------------
;; Complex expressions

(prints
 [(conjugate 1+2i) 1-2i]
 [(conjugate (exp (* +i 't))) (exp (* -i t))]
 [(simplify (* (exp (* +i 't)) (conjugate (exp (* +i 't))))) 1]
 [(simplify (- (conjugate (/ (square z) (tan z)))
               (let ([w (make-rectangular 'x (- 'y))]) (/ (square w) (tan w)))))
  0]
 [(real-part z) x]
 [(imag-part z) y]
 [(real-part (conjugate (* z z))) (- (expt x 2) (expt y 2))]
 [(imag-part (/ 1 z)) (/ (* -1 y) (+ (expt x 2) (expt y 2)))]
 [(simplify (real-part (exp z))) (* (exp x) (cos y))]
 [(imag-part (sin z)) (* (cos x) (sinh y))]
 [(imag-part (cos z)) (* -1 (sin x) (sinh y))]
 [(imag-part (cosh z)) (* (sin y) (sinh x))]
 [(real-part (expt z -1)) (/ x (+ (expt x 2) (expt y 2)))]
 [((real-part (lambda (t) (exp (* +i t)))) 't) (cos t)]
 [(real-part (up 1+2i (x 't))) (up 1 (x t))]
 [(imag-part 'x) 0]
 [(real-part (make-polar 'r 'phi)) (* r (cos phi))])

(says
 [(real-part (sqrt z))
  "real-part: the parts are known of sums, products, whole powers, exp, sin, cos, sinh and cosh "
  "of complex expressions; given (sqrt (+ x (* 0+1i y)))"]
 [(conjugate (sqrt z))
  "conjugate: the parts are known of sums, products, whole powers, exp, sin, cos, sinh and cosh "
  "of complex expressions; given (sqrt (+ x (* 0+1i y)))"]
 [(make-rectangular sin 1) "make-rectangular: expected two numbers\n  given: the procedure `sin`"])

;; ---------------------------------------------------------------------------
;; Names

(prints
 [(matrix-by-cols '(1 2) '(3 4)) (matrix-by-rows (list 1 3) (list 2 4))]
 [(matrix:generate 2 2 +) (matrix-by-rows (list 0 1) (list 1 2))]
 [(m:make-identity 2) (matrix-by-rows (list 1 0) (list 0 1))]
 [(vector->column-matrix #(1 2)) (matrix-by-rows (list 1) (list 2))]
 [(vector->row-matrix (up 1 2)) (matrix-by-rows (list 1 2))]
 [(column-matrix 1 2) (matrix-by-rows (list 1) (list 2))]
 [(row-matrix 1 2) (matrix-by-rows (list 1 2))]
 [(column-matrix->vector (column-matrix 1 2)) (up 1 2)]
 [(row-matrix->vector (row-matrix 1 2)) (up 1 2)]
 [(lu-null-space (matrix-by-rows '(1 2) '(2 4))) ((up -2 1))]
 [((derivative cube) 'x) (* 3 (expt x 2))]
 [((constant 'c) 't) c]
 [(literal-up-tuple 'q 2) (up q^0 q^1)]
 [(literal-down-tuple 'p 2) (down p_0 p_1)]
 [(literal-matrix 'A 1 2) (matrix-by-rows (list A^0_0 A^0_1))]
 [(list-head '(a b c) 2) (a b)]
 [(make-list 2 'x) (x x)]
 [(fold-left list 's '(a b) '(c d)) ((s a c) b d)]
 [(fold-right list 's '(a b) '(c d)) (a c (b d s))]
 [(factorial 5) 120]
 [(eigenvectors (matrix-by-rows '(a b) '(b a))) (((+ a b) (up 1 1)) ((- a b) (up -1 1)))]
 [(eigenvectors (matrix-by-rows '(1 1) '(0 1))) ((1 (up 1 0)))]
 [(polynomial-roots (* (expt (- 'x 1) 3) (- 'x 2) (+ 1 (square 'x))) 'x) (1 1 1 2 +i -i)]
 [(polynomial-roots (* 'x (- 'x 'a)) 'x) (0 a)])

(comes-close
 [(gamma 1/2) (sqrt pi)]
 [(bessj0 1) 0.7651976865579666]
 [(bessj 10 0.1) 2.69053289543422e-20]
 [(bessj -1 2.5) (- (bessj1 2.5))]
 [(bessj 3 -2.5) (- (bessj 3 2.5))]
 [(+ (bessj 2 3.0) (bessj 4 3.0)) (* 2 (bessj 3 3.0))]
 [(bessj0 100) 0.019985850304223122]
 [(polynomial-roots (- (expt 'x 3) 8) 'x)
  (list 2 -1.0+1.7320508075688772i -1.0-1.7320508075688772i)])

(test-case "Bessel's functions of a small argument keep their digits"
  (check-= (/ (bessj 10 0.1) 2.6905328954342155e-20) 1 1e-13)
  (check-= (/ (bessj 5 1e-12) (/ 1e-60 3840)) 1 1e-13))

(test-case "factor-polynomial-expression factors"
  (check-unsimplified (factor-polynomial-expression (- (square 'x) 1)) '(* (- x 1) (+ 1 x))))

(define (check-eigenvectors m)
  (for ([found (eigenvectors m)])
    (define-values (value v) (apply values found))
    (check-near (* m v) (* value v))))

(test-case "eigenvectors of decimals"
  (check-eigenvectors (matrix-by-rows '(2.0 1.0) '(1.0 3.0)))
  (check-eigenvectors (matrix-by-rows '(2.0 1.0) '(0.0 3.0)))
  (check-eigenvectors (matrix-by-rows '(0.0 1.0) '(-4.0 0.0)))
  (check-eigenvectors (matrix-by-rows '(1.0 2.0 3.0) '(4.0 5.0 6.0) '(7.0 8.0 10.0))))

(test-case "U Σ Vᵀ is the matrix, U and V are orthogonal"
  (for ([m (list (matrix-by-rows '(3 0) '(4 5)) (matrix-by-rows '(1 2 3) '(4 5 6))
                 (matrix-by-rows '(1 2) '(3 4) '(5 6)))])
    (define-values (U values-found V) (apply values (svd m)))
    (define n (length values-found))
    (define S (m:generate n n (lambda (i j) (if (= i j) (list-ref values-found i) 0))))
    (check-near (* U S (transpose V)) m)
    (check-near (* (transpose U) U) (identity-matrix n))
    (check-near (* (transpose V) V) (identity-matrix n))
    (check-true (apply >= values-found))))

(says
 [(literal-matrix "A" 2 2)
  "literal-matrix: expected a quoted name, such as 'A\n  given: \"A\", a string"]
 [(literal-matrix 'A 2 0)
  "literal-matrix: expected a number of rows and one of columns; given 2 and 0"]
 [(column-matrix->vector (row-matrix 1 2))
  "column-matrix->up: expected a matrix of one column\n  matrix: (matrix-by-rows (list 1 2))"]
 [(list-head '(a) 2)
  "list-head: expected a list, and a number of its first elements\n  list: '(a)\n  number: 2"]
 [(fold-left + 0 '(1 2) '(3))
  "fold-left: expected lists of one length\n  lists: '((1 2) (3))"]
 [(fold-right 'f 0 '(1 2)) "fold-right: expected a procedure\n  given: the symbol f"]
 [(gamma 'x) "gamma: expected a real number\n  given: the symbol x"]
 [(gamma -1) "gamma: there is a pole at 0, -1, -2, ...; given the number -1"]
 [(factorial 1.5)
  "factorial: expected a natural number\n  given: the number 1.5\n"
  "  of other numbers x it is (gamma (+ x 1))"]
 [(bessj 1/2 3) "bessj: expected a whole order\n  given: the number 1/2"]
 [(bessj 0 1e9) "bessj: expected a number below 1000000.0 in size; given 1000000000.0"]
 [(eigenvectors 3) "eigenvectors: expected a matrix or a tuple of tuples\n  given: the number 3"]
 [(svd 3) "svd: expected a matrix or a tuple of tuples\n  given: the number 3"]
 [(polynomial-roots (sin 'x) 'x)
  "polynomial-roots: expected a polynomial in x, of degree 100 at most; given (sin x)"]
 [(polynomial-roots 0 'x) "polynomial-roots: every number is a root of 0"])
