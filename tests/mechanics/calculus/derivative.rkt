#lang racket/base
;; D and partial: functions of every shape, orientation, nesting, programs.

(require racket/match
         mechanics/generic/arithmetic
         mechanics/generic/compare
         mechanics/generic/elementary
         mechanics/generic/sums-and-products
         mechanics/value/compose
         mechanics/value/matrix/linear-algebra
         mechanics/value/matrix/matrix
         mechanics/value/structure
         mechanics/value/signature
         mechanics/calculus/derivative
         mechanics/calculus/literal-function
         "../support/checks.rkt" "../support/same.rkt")

(define V (literal-function 'V))
(define F (literal-function 'F (-> (X Real Real) Real)))

;; ---------------------------------------------------------------------------
;; Scalars

(test-case "derivatives at numbers, symbols and expressions"
  (define (f x) (g:* x (g:sin x)))
  (check-equal? ((D g:cube) 2) 12)
  (check-equal? ((D g:cube) 1/2) 3/4)
  (check-= ((D f) 1.5) (+ (sin 1.5) (* 1.5 (cos 1.5))) 1e-15)
  (check-same ((D f) 'x) (g:+ (g:sin 'x) (g:* 'x (g:cos 'x))))
  (check-same ((D f) (g:* 2 'x)) (g:+ (g:sin (g:* 2 'x)) (g:* 2 'x (g:cos (g:* 2 'x)))))
  (check-equal? ((D (lambda (z) (g:* z z))) +i) +2i))

(test-case "exactness is kept: the derivative of x² is 2x exactly"
  (check-eqv? ((D g:square) 1/3) 2/3)
  (check-eqv? ((D (lambda (x) 7)) 1.5) 0)
  (check-eqv? ((D values) 1.5) 1))

(test-case "higher derivatives"
  (check-same (((g:expt D 4) g:sin) 'x) (g:sin 'x))
  (check-equal? (((g:expt D 3) (lambda (x) (g:expt x 5))) 2) 240)
  (check-equal? (((g:expt D 0) g:square) 3) 9)
  (check-equal? ((D (D (D g:cube))) 'x) 6))

;; ---------------------------------------------------------------------------
;; Structures in and out (SICM p. 516)

(test-case "the derivative by an up tuple is a down tuple, and by a down an up"
  (define (f s) (g:* (ref s 0) (g:square (ref s 1))))
  (check-equal? ((D f) (up 2 3)) (down 9 12))
  (check-equal? ((D f) (down 2 3)) (up 9 12))
  (check-equal? ((D f) (vector 2 3)) (down 9 12)))

(test-case "nested structures keep their nesting, each level flipped"
  (define (f s) (g:* (ref s 0) (ref s 1 0) (ref s 2 1)))
  (check-equal? ((D f) (up 2 (up 3 0) (down 0 5)))
                (down 15 (down 10 0) (up 0 6))))

(test-case "the derivative of a tuple-valued function: the argument's index outside"
  (define (f x) (up (g:square x) (g:cube x)))
  (check-equal? ((D f) 2) (up 4 12))
  (define (g s) (up (g:* (ref s 0) (ref s 1)) (ref s 0) 7))
  (check-equal? ((D g) (up 2 3)) (down (up 3 1 0) (up 2 0 0)))
  (define (h s) (down (g:square (ref s 0)) (ref s 1)))
  (check-equal? ((D h) (down 2 3)) (up (down 4 0) (down 0 1))))

(test-case "the derivative times an increment is the increment of the value"
  (define (g s) (up (g:* (ref s 0) (ref s 1)) (g:sin (ref s 0)) (g:exp (ref s 1))))
  (check-same (g:* ((D g) (up 'x 'y)) (up 'dx 'dy))
              (up (g:+ (g:* 'y 'dx) (g:* 'x 'dy)) (g:* (g:cos 'x) 'dx) (g:* (g:exp 'y) 'dy))))

(test-case "second derivatives of a function of a tuple: a symmetric down of downs"
  (define (f s) (g:* (g:square (ref s 0)) (g:cube (ref s 1))))
  (check-equal? (((g:expt D 2) f) (up 2 3)) (down (down 54 108) (down 108 72))))

(test-case "the chain rule for tuples, by contraction"
  (define (inner s) (up (g:* (ref s 0) (ref s 1)) (g:- (ref s 0) (ref s 1))))
  (define (outer s) (g:+ (g:sin (ref s 0)) (g:square (ref s 1))))
  (define s (up 'x 'y))
  (check-same ((D (compose outer inner)) s)
              (g:* ((D outer) (inner s)) ((D inner) s))))

(test-case "functions in a tuple have the tuple of derivatives"
  (check-same ((D (up g:sin (down g:exp V))) 't)
              (up (g:cos 't) (down (g:exp 't) ((D V) 't))))
  (check-same (((partial 0) (up (lambda (x y) (g:* x y)) (lambda (x y) (g:+ x y)))) 'x 'y)
              (up 'y 1)))

(test-case "matrix-valued functions have matrices of derivatives"
  (check-equal? ((D (lambda (x) (matrix-by-rows (list 1 x) (list (g:square x) 0)))) 'x)
                (matrix-by-rows '(0 1) (list (g:* 2 'x) 0))))

(test-case "the derivative by a matrix is that by the tuples it stands for"
  (define M (matrix-by-rows '(a b) '(c d)))
  (define dM (down (up 'da 'dc) (up 'db 'dd)))          ; by columns
  (check-same (g:* ((D determinant) M) dM)
              (g:+ (g:* 'a 'dd) (g:* 'd 'da) (g:* -1 'b 'dc) (g:* -1 'c 'db)))
  (check-same ((D (lambda (m) (ref (g:* m (up 'x 'y)) 0))) M)
              (up (down 'x 0) (down 'y 0)))
  (check-same (((D (lambda (m) (lambda (v) (g:* m v)))) (matrix-by-rows '(1 2))) (up 'x 'y))
              (up (down (up 'x)) (down (up 'y))))
  (check-equal? ((D (lambda (m) (g:square (matrix-ref m 0 2)))) (matrix-by-rows '(1 2 3)))
                (up (down 0) (down 0) (down 6))))

(test-case "an empty tuple has an empty derivative"
  (check-equal? ((D (lambda (s) 3)) (up)) (down)))

;; ---------------------------------------------------------------------------
;; Several arguments

(test-case "several arguments are taken as one up tuple"
  (define (f x y) (g:* x (g:square y)))
  (check-equal? ((D f) 2 3) (down 9 12))
  (check-equal? ((D (lambda (x y z) (g:* x y z))) 2 3 5) (down 15 10 6))
  (check-equal? (((g:expt D 2) f) 2 3) (down (down 0 6) (down 6 4)))
  (check-equal? ((D (lambda (s t) (g:* (ref s 0) (ref s 1) t))) (up 2 3) 5)
                (down (down 15 10) 6)))

(test-case "partial takes the derivative by one argument, or by a component of one"
  (define (f x y) (g:* x (g:square y)))
  (check-equal? (((partial 0) f) 2 3) 9)
  (check-equal? (((partial 1) f) 2 3) 12)
  (check-equal? (((partial 1 0) (lambda (t q) (g:* t (g:square (ref q 0))))) 5 (up 3 4)) 30)
  (check-equal? (((partial 1) (lambda (t q) (g:* t (g:square (ref q 0))))) 5 (up 3 4)) (down 30 0)))

(test-case "of one tuple, partial takes the derivative by a component"
  (define (L local) (g:* 1/2 'm (g:square (ref local 2))))
  (check-same (((partial 2) L) (up 't 'q 'v)) (g:* 'm 'v))
  (check-same (((partial 2) L) (up 't (up 'x 'y) (up 'vx 'vy))) (down (g:* 'm 'vx) (g:* 'm 'vy)))
  (check-same (((partial 2 1) L) (up 't (up 'x 'y) (up 'vx 'vy))) (g:* 'm 'vy))
  (check-equal? (((partial 0) L) (up 't 'q 'v)) 0))

(test-case "partial by a down component gives an up"
  (define (H s) (g:* 1/2 (g:square (ref s 2))))
  (check-same (((partial 2) H) (up 't (up 'x 'y) (down 'px 'py))) (up 'px 'py)))

(test-case "mixed partial derivatives commute, of functions and of operators"
  (define (f x y) (g:+ (g:exp (g:* x y)) (g:sin (g:/ x y))))
  (define one-then-zero (((partial 0) ((partial 1) f)) 'x 'y))
  (define zero-then-one (((partial 1) ((partial 0) f)) 'x 'y))
  (check-same one-then-zero zero-then-one)
  (check-same (((g:* (partial 0) (partial 1)) f) 'x 'y) one-then-zero)
  (check-equal? (((partial 0) ((partial 1) F)) 'x 'y) (((partial 1) ((partial 0) F)) 'x 'y)))

(test-case "curried, variadic and optional arguments"
  (define ((f x) y) (g:* x (g:square y)))
  (check-equal? (((D f) 2) 3) 9)
  (check-equal? ((D (f 2)) 3) 12)
  (define (g . xs) (apply g:* xs))
  (check-equal? ((D g) 2 3 5) (down 15 10 6))
  (check-equal? (((partial 2) g) 2 3 5) 6)
  (check-equal? ((D g) 7) 1)
  (define (h x [y 10]) (g:* x y))
  (check-equal? ((D h) 3) 10)
  (check-equal? ((D h) 3 4) (down 4 3))
  (check-equal? (((partial 1) h) 3 4) 3))

;; ---------------------------------------------------------------------------
;; Functions of functions

(test-case "a function-valued function has the function of derivatives"
  (define ((f x) y) (g:* x (g:sin (g:* x y))))
  (check-same (((D f) 'x) 'y)
              (g:+ (g:sin (g:* 'x 'y)) (g:* 'x 'y (g:cos (g:* 'x 'y)))))
  (check-same (((g:expt D 2) (lambda (x) (lambda (y) (g:* (g:cube x) y)))) 'x)
              (lambda (y) (g:* 6 'x y))))

(test-case "the derivative by three rotation angles at zero (SICM p. 91): generators"
  (define ((Rz a) s) (up (g:- (g:* (g:cos a) (ref s 0)) (g:* (g:sin a) (ref s 1)))
                         (g:+ (g:* (g:sin a) (ref s 0)) (g:* (g:cos a) (ref s 1)))
                         (ref s 2)))
  (define ((Rx a) s) (up (ref s 0)
                         (g:- (g:* (g:cos a) (ref s 1)) (g:* (g:sin a) (ref s 2)))
                         (g:+ (g:* (g:sin a) (ref s 1)) (g:* (g:cos a) (ref s 2)))))
  (define ((Ry a) s) (up (g:+ (g:* (g:cos a) (ref s 0)) (g:* (g:sin a) (ref s 2)))
                         (ref s 1)
                         (g:- (g:* (g:cos a) (ref s 2)) (g:* (g:sin a) (ref s 0)))))
  (define (F-tilde a b c) (compose (Rx a) (Ry b) (Rz c)))
  (define generators ((D F-tilde) 0 0 0))
  (check-pred structure? generators)
  (check-equal? (structure-orientation generators) 'down)
  (check-equal? (generators (up 'x 'y 'z))
                (down (up 0 (g:* -1 'z) 'y) (up 'z 0 (g:* -1 'x)) (up (g:* -1 'y) 'x 0))))

(test-case "a function that computes a derivative has derivatives"
  (define ((slope f) x) ((D f) x))
  (check-same ((D (slope g:sin)) 'x) (g:* -1 (g:sin 'x)))
  (check-same ((D (lambda (a) ((D (lambda (x) (g:sin (g:* a x)))) 1))) 'a)
              (g:- (g:cos 'a) (g:* 'a (g:sin 'a)))))

;; ---------------------------------------------------------------------------
;; Programs

(define (power-by-recursion x n) (if (zero? n) 1 (g:* x (power-by-recursion x (sub1 n)))))
(define (power-by-loop x n) (let loop ([p 1] [n n]) (if (zero? n) p (loop (g:* p x) (sub1 n)))))
(define (power-by-for x n) (for/fold ([p 1]) ([_ (in-range n)]) (g:* p x)))
(define (power-by-squaring x n)
  (cond [(zero? n) 1]
        [(even? n) (g:square (power-by-squaring x (quotient n 2)))]
        [else (g:* x (power-by-squaring x (sub1 n)))]))

(test-case "recursion, named let, for loops and cond"
  (for ([power (list power-by-recursion power-by-loop power-by-for power-by-squaring g:expt)])
    (check-equal? ((D (lambda (x) (power x 7))) 2) 448)
    (check-same ((D (lambda (x) (power x 7))) 'x) (g:* 7 (g:expt 'x 6)))
    (check-equal? (((g:expt D 2) (lambda (x) (power x 7))) 2) 1344)))

(test-case "ifs, let, internal definitions, higher-order list functions, hash tables"
  (define (f x)
    (define xs (for/list ([k 4]) (g:* k x)))
    (define table (for/hash ([k 4] [y xs]) (values k (g:square y))))
    (let* ([total (apply g:+ (map g:sin xs))]
           [s (foldl g:+ 0 (hash-values table))])
      (if (g:> x 0) (g:+ total s) (g:- total s))))
  (check-= ((D f) 0.5)
           (+ (for/sum ([k 4]) (* k (cos (* k 0.5)))) (* 2 0.5 14)) 1e-14)
  (check-= ((D f) -0.5)
           (- (for/sum ([k 4]) (* k (cos (* k -0.5)))) (* 2 -0.5 14)) 1e-14))

(test-case "mutual recursion and continued fractions"
  ;; x/(1 + x/(1 + ...)) to depth n solves y = x/(1 + y): y' = 1/(1 + 2y)
  (define (f x n) (if (zero? n) x (g:/ x (g:+ 1 (f x (sub1 n))))))
  (check-= ((D (lambda (x) (f x 80))) 1.0) (/ 1 (sqrt 5.0)) 1e-12))

(test-case "mutation in the program is no obstacle"
  (define (f x)
    (define v (make-vector 3 x))
    (for ([i 2]) (vector-set! v (add1 i) (g:* (vector-ref v i) x)))
    (vector-ref v 2))
  (check-equal? ((D f) 2) 12))

(test-case "assignment from within is not confused either"
  (define total 0)
  (define (f x) (set! total (g:+ 1 x)) (g:square total))
  (check-equal? ((D f) 2) 6))

(test-case "exceptions and early exits pass through"
  (define (f x) (let/ec return (g:for/sum ([n 10]) (when (= n 3) (return (g:expt x n))) x)))
  (check-equal? ((D f) 2) 12))

(struct body (mass position))

(test-case "match, structures of the user's, accumulators, strings of calls"
  (define (energy x)
    (define b (body 2 (list x (g:square x))))
    (match b
      [(body m (list y z)) (g:* m (g:+ y z))]))
  (check-equal? ((D energy) 3) 14)
  (define (apply-all fs x) (foldl (lambda (f y) (f y)) x fs))
  (check-same ((D (lambda (x) (apply-all (list g:sin g:square g:exp) x))) 'x)
              ((D (compose g:exp g:square g:sin)) 'x))
  (define (sum-by-set x)
    (define total 0)
    (for ([k 4]) (set! total (g:+ total (g:expt x k))))
    total)
  (check-equal? ((D sum-by-set) 2) 17)
  (check-equal? (((g:expt D 2) sum-by-set) 2) 14))

(test-case "functions that remember their values"
  (define (remembering f)
    (define known (make-hash))
    (lambda (x) (hash-ref! known x (lambda () (f x)))))
  (define cube (remembering g:cube))
  (check-equal? (list (cube 5) ((D cube) 5) ((D (D cube)) 5) ((D cube) 5) (cube 5))
                '(125 75 30 75 125))
  (check-same ((D cube) 'x) (g:* 3 (g:square 'x)))
  (define (fibonacci-polynomial n x)            ; Fₙ = x Fₙ₋₁ + Fₙ₋₂
    (define F (remembering (lambda (k) (if (< k 2) k (g:+ (g:* x (F (- k 1))) (F (- k 2)))))))
    (F n))
  ;; F₄ = x³ + 2x; at 1 the slope of Fₙ is (n Lₙ − Fₙ)/5
  (check-equal? ((D (lambda (x) (fibonacci-polynomial 4 x))) 3) 29)
  (check-equal? ((D (lambda (x) (fibonacci-polynomial 30 x))) 1)
                (/ (- (* 30 1860498) 832040) 5)))

(test-case "continuations: generators, escapes, and coming back to a derivative that has ended"
  (define (powers x)                            ; yields 1, x, x², … to `receive`
    (lambda (receive)
      (let loop ([p 1] [n 0]) (unless (= n 4) (receive p) (loop (g:* p x) (add1 n))))))
  (define (sum x) (let ([total 0]) ((powers x) (lambda (p) (set! total (g:+ total p)))) total))
  (check-equal? ((D sum) 2) 17)
  (define again #f)
  (define visits 0)
  (define (f x) (let ([k (call/cc (lambda (k) (set! again k) 2))]) (g:* k (g:square x))))
  (define slope ((D f) 3))
  (set! visits (add1 visits))
  (case visits
    [(1) (check-equal? slope 12) (again 5)]
    [else (check-equal? slope 30)]))

(test-case "derivatives in threads do not meet"
  (define results
    (for/list ([n 8])
      (define box (make-channel))
      (thread (lambda ()
                (channel-put box
                             ((D (lambda (x) (g:* x ((D (lambda (y) (g:* x (g:expt y n)))) x))))
                              2))))
      box))
  ;; d/dx (n xⁿ⁺¹) = n (n + 1) xⁿ
  (for ([r results] [n 8])
    (check-equal? (channel-get r) (* n (+ n 1) (expt 2 n)))))

(test-case "literal functions of several structures, and of structured range, along curves"
  (define G
    (literal-function 'G (-> (X (UP Real Real) (DOWN Real Real)) (UP Real (DOWN Real Real)))))
  (define (along t) (G (up t (g:square t)) (down (g:sin t) 1)))
  (define d ((D along) 't))
  (check-same (ref d 0)
              (g:+ (((partial 0 0) (ref G 0)) (up 't (g:square 't)) (down (g:sin 't) 1))
                   (g:* 2 't (((partial 0 1) (ref G 0)) (up 't (g:square 't)) (down (g:sin 't) 1)))
                   (g:* (g:cos 't)
                        (((partial 1 0) (ref G 0)) (up 't (g:square 't)) (down (g:sin 't) 1)))))
  (check-equal? (((partial 0 1) ((partial 1 0) G)) (up 'a 'b) (down 'c 'd))
                (((g:* (partial 1 0) (partial 0 1)) G) (up 'a 'b) (down 'c 'd))))

;; ---------------------------------------------------------------------------
;; Direction

(test-case "value and derivative along a direction, in one run"
  (define runs 0)
  (define (f s) (set! runs (add1 runs)) (up (g:* (ref s 0) (ref s 1)) (g:square (ref s 1))))
  (define-values (value slope) (value-and-derivative-along f (up 2 3) (up 'a 1)))
  (check-equal? value (up 6 9))
  (check-same slope (up (g:+ 2 (g:* 3 'a)) 6))
  (check-equal? runs 1)
  (define-values (v s) (value-and-derivative-along g:square 'x 'dx))
  (check-equal? v (g:square 'x))
  (check-same s (g:* 2 'x 'dx)))

(test-case "along a direction within another derivative"
  (check-equal? ((D (lambda (x)
                      (define-values (v s) (value-and-derivative-along g:cube x x))
                      s))
                 2)
                36))
