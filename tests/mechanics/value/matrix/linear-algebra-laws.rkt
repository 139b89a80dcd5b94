#lang racket/base
;; Linear algebra over expressions, as it is typed: laws proved, random matrices
;; against their values, matrices with a name, and what singular ones say.

(require mechanics
         "../../support/checks.rkt" "../../support/messages.rkt"
         "../../support/random.rkt" "../../support/same.rkt")

(define (symbols n [name 'a])
  (m:generate n n (lambda (i j) (string->symbol (format "~a~a~a" name i j)))))

(define (unknowns n) (s:generate n 'up (lambda (i) (string->symbol (format "b~a" i)))))

(define (proved-equal? a b) (proved? (verify-equal a b)))

(define-syntax-rule (failure-of expr)
  (with-handlers ([exn:fail? values]) expr (void)))

;; The lists in a datum, shared ones once: what a graph costs.
(define (node-count x)
  (define seen (make-hasheq))
  (let walk ([d (expression x)])
    (when (and (pair? d) (not (hash-ref seen d #f)))
      (hash-set! seen d #t)
      (for-each walk d)))
  (hash-count seen))

;; ---------------------------------------------------------------------------
;; Laws, proved

(test-case "a matrix times its inverse is the identity"
  (for ([n '(1 2 3)])
    (define A (symbols n))
    (check-true (proved-equal? (* A (m:invert A)) (identity-matrix n)))
    (check-true (proved-equal? (* (/ 1 A) A) (identity-matrix n)))))

(test-case "the reciprocal of a tuple of tuples is the inverse map"
  (for ([A (list (down (up 'a 'b) (up 'c 'd)) (down (down 'a 'b) (down 'c 'd)))])
    (define x (up 'x 'y))
    (check-true (proved-equal? (* (/ 1 A) (* A x)) x))
    (check-true (proved-equal? (* (invert A) (* A x)) x))
    (check-true (proved-equal? (* A (/ (* A x) A)) (* A x))))
  (check-message (string-append "/: cannot divide a number by an up tuple of 2\n"
                                "  argument 1: the number 1\n"
                                "  argument 2: (up (up 1 2) 3), an up tuple of 2")
                 (/ 1 (up (up 1 2) 3))))

(test-case "determinants multiply and ignore transposition"
  (for ([n '(2 3)])
    (check-true (proved-equal? (determinant (* (symbols n 'a) (symbols n 'b)))
                               (* (determinant (symbols n 'a)) (determinant (symbols n 'b))))))
  (check-true (proved-equal? (determinant (transpose (symbols 5))) (determinant (symbols 5)))))

(test-case "the residual of a solution is zero"
  (for ([n '(1 2 3 4)])
    (define A (symbols n))
    (define b (unknowns n))
    (check-true (proved-equal? (* A (solve-linear-left A b)) b))
    (check-true (proved-equal? (* (solve-linear-right (flip b) A) A) (flip b)))))

(test-case "every matrix satisfies its characteristic polynomial"
  (check-equal? (simplify (characteristic-polynomial (symbols 3) (symbols 3)))
                (m:generate 3 3 (lambda (i j) 0))))

;; ---------------------------------------------------------------------------
;; Random matrices against their values

(define (random-entry)
  (random-choice 'x 'y 'm (sin 'theta) (cos 'theta) (* 2 'x 'y) (/ 1 'm) (sqrt 'r) 3 1/2 0.25
                 (cos (+ 'theta 'phi))))

(define (random-matrix n density)
  (m:generate n n (lambda (i j) (if (< (random) density) (random-entry) 0))))

(define (value-at-point m)
  (substitute m 'x 1.3 'y -0.7 'm 2.1 'theta 0.9 'phi -0.4 'r 1.7))

(test-case "determinants and solutions, sparse and dense, have the values of the numbers put in"
  (with-seed 451
    (for* ([n '(2 3 4 5 6 8)] [density '(0.3 0.6 1)])
      (define A (random-matrix n density))
      (define numbers (value-at-point A))
      (define d (determinant A))
      (check-true (same? (value-at-point d) (determinant numbers) 1e-8))
      (unless (proved? (prove-zero d))
        (define b (unknowns n))
        (define point (apply append (for/list ([i n]) (list (ref b i) (+ i 0.5)))))
        (check-true (same? (apply substitute (value-at-point (solve-linear-left A b)) point)
                           (solve-linear-left numbers (apply substitute b point))
                           1e-6))
        (check-true (same? (value-at-point (m:invert A)) (m:invert numbers) 1e-6))))))

(test-case "entries of any kind: the derivative of a determinant of many rows"
  ;; |1 + x v vᵀ| = 1 + x v·v
  (define ((bordered n) x)
    (m:generate n n (lambda (i j) (+ (* x (add1 i) (add1 j)) (if (= i j) 1 0)))))
  (for ([n '(3 9 12)])
    (define v² (for/sum ([i n]) (square (add1 i))))
    (check-equal? ((D (compose determinant (bordered n))) 5) v²)
    (check-equal? (simplify ((D (compose determinant (bordered n))) 't)) v²)
    (define (first-unknown x)
      (ref (solve-linear-left ((bordered n) x) (s:generate n 'up add1)) 0))
    ;; (1 + x v vᵀ) y = v has y = v / (1 + x v·v)
    (check-equal? ((D first-unknown) 1) (/ (- v²) (square (+ 1 v²))))))

(test-case "dense matrices of many rows make graphs, not trees"
  (check < (node-count (determinant (symbols 9))) 5000)
  (check < (node-count (determinant (symbols 20))) 100000)
  (check < (node-count (ref (solve-linear-left (symbols 12) (unknowns 12)) 0)) 10000))

;; ---------------------------------------------------------------------------
;; Zeros

(define (symbol . parts) (string->symbol (apply string-append (map ->string parts))))
(define (->string x) (format "~a" x))

(test-case "ten rows of a tridiagonal matrix: the recurrence of continuants"
  (define A
    (m:generate 10 10 (lambda (i j) (case (- j i) [(0) (symbol 'a i)] [(1) (symbol 'b i)]
                                      [(-1) (symbol 'c j)] [else 0]))))
  (define-values (before continuant)
    (for/fold ([before 1] [d (symbol 'a 0)]) ([k (in-range 1 10)])
      (values d (- (* (symbol 'a k) d)
                   (* (symbol 'b (- k 1)) (symbol 'c (- k 1)) before)))))
  (check-true (proved-equal? (determinant A) continuant))
  (check < (node-count (determinant A)) 120))

(test-case "eight rows with many zeros: blocks cost what they cost"
  (define A
    (m:generate 8 8 (lambda (i j)
                      (cond [(= (quotient i 2) (quotient j 2)) (symbol 'a i j)]
                            [(and (> i j) (even? (+ i j))) (symbol 'c i j)]
                            [else 0]))))
  (define blocks (for/list ([k 4]) (m:submatrix A (* 2 k) (* 2 (+ k 1)) (* 2 k) (* 2 (+ k 1)))))
  (check-true (proved-equal? (determinant A) (apply * (map determinant blocks))))
  (check < (node-count (determinant A)) 25)
  (define x (solve-linear-left A (unknowns 8)))
  (check-true (proved-equal? (up (ref x 0) (ref x 1))
                             (solve-linear-left (car blocks) (up 'b0 'b1))))
  (define residual (- (* A x) (unknowns 8)))
  (with-seed 453
    (define point
      (for*/list ([name (append (for*/list ([i 8] [j 8]) (format "a~a~a" i j))
                                (for*/list ([i 8] [j 8]) (format "c~a~a" i j))
                                (for/list ([i 8]) (format "b~a" i)))]
                  [item (list (string->symbol name) (random-rational))])
        item))
    (check-equal? (apply substitute residual point) (s:generate 8 'up (lambda (i) 0)))))

(test-case "rows and columns may come in any order"
  (define A (matrix-by-rows '(0 0 a) '(b 0 0) '(c d 0)))
  (check-true (proved-equal? (determinant A) (* 'a 'b 'd)))
  (check-true (proved-equal? (* A (m:invert A)) (identity-matrix 3))))

(test-case "blocks of numbers stay exact beside blocks of flonums"
  (check-equal? (solve-linear-left (matrix-by-rows '(3 1 0) '(1 2 0) '(0 0 4.0)) (up 1 1 1))
                (up 1/5 2/5 0.25))
  (check-equal? (determinant (matrix-by-rows '(0 1.0) '(0 2))) 0.0)
  (check-equal? (solve-linear-left (matrix-by-rows '(1 2) '(3 4)) (up 'p 'q))
                (* (m:invert (matrix-by-rows '(1 2) '(3 4))) (up 'p 'q))))

;; ---------------------------------------------------------------------------
;; Matrices with a name

(test-case "Vandermonde's determinant is the product of the differences"
  (define nodes '(x y z w))
  (define V (m:generate 4 4 (lambda (i j) (expt (list-ref nodes i) j))))
  (define differences
    (for*/product ([j 4] [i j]) (- (list-ref nodes j) (list-ref nodes i))))
  (check-true (proved-equal? (determinant V) differences))
  (define factored (expression (factor (determinant V))))
  (check-equal? (length factored) (if (memv -1 factored) 8 7)))

(define (Rx a) (matrix-by-rows '(1 0 0) (list 0 (cos a) (- (sin a))) (list 0 (sin a) (cos a))))
(define (Rz a) (matrix-by-rows (list (cos a) (- (sin a)) 0) (list (sin a) (cos a) 0) '(0 0 1)))
(define Euler (* (Rz 'phi) (Rx 'theta) (Rz 'psi)))

(test-case "Euler-angle matrices are orthogonal, of determinant 1"
  (check-equal? (simplify (* Euler (transpose Euler))) (identity-matrix 3))
  (check-equal? (simplify (determinant Euler)) 1)
  (check-equal? (simplify (m:invert Euler)) (simplify (transpose Euler))))

(test-case "a rotation leaves its axis as it is"
  (check-equal? (rank (- Euler 1)) 2)
  (define axis (car (null-space (- Euler 1))))
  (check-true (proved-equal? (* Euler axis) axis)))

(define ((T-rigid-body A B C) (up t (up theta phi psi) (up thetadot phidot psidot)))
  (* 1/2 (+ (* A (square (+ (* phidot (sin theta) (sin psi)) (* thetadot (cos psi)))))
            (* B (square (- (* phidot (sin theta) (cos psi)) (* thetadot (sin psi)))))
            (* C (square (+ (* phidot (cos theta)) psidot))))))

(define Euler-state (up 't (up 'theta 'phi 'psi) (up 'thetadot 'phidot 'psidot)))

(test-case "the determinant of ∂₂∂₂T in Euler angles is A B C sin²θ (SICM p. 144)"
  (define mass-matrix (((square (partial 2)) (T-rigid-body 'A 'B 'C)) Euler-state))
  (check-equal? (expression (simplify (determinant mass-matrix)))
                '(* A B C (expt (sin theta) 2)))
  (check-equal? (rank mass-matrix) 3))

(test-case "Hilbert's matrix is inverted exactly"
  (define H (m:generate 12 12 (lambda (i j) (/ 1 (+ i j 1)))))
  (check-equal? (* H (m:invert H)) (identity-matrix 12)))

(test-case "radicals and flonums among the entries"
  (define A (matrix-by-rows (list (sqrt 'x) 1) (list 1 (sqrt 'x))))
  (check-true (proved-equal? (determinant A) (- 'x 1)))
  (check-true (proved-equal? (* A (m:invert A)) (identity-matrix 2)))
  (define B (matrix-by-rows '(9.8 m) '(1 2.0)))
  (check-equal? (expression (simplify (determinant B))) '(- 19.6 m)))

(test-case "fifty rows of flonums: the residual is small"
  (with-seed 452
    (define A (m:generate 50 50 (lambda (i j) (random-flonum))))
    (define x (s:generate 50 'up (lambda (i) (random-flonum))))
    (check-true (same? (solve-linear-left A (* A x)) x 1e-8))
    (check-true (same? (* A (m:invert A)) (identity-matrix 50) 1e-8))))

;; ---------------------------------------------------------------------------
;; Singular matrices

(define disguised-zero (- (+ (square (sin 'q)) (square (cos 'q))) 1))

(test-case "what is singular only after simplification is singular"
  (for ([A (list (matrix-by-rows (list disguised-zero 0) '(0 1))
                 (matrix-by-rows (list (square (sin 'q)) 'k)
                                 (list (- 1 (square (cos 'q))) 'k))
                 (down (down 'm (* 'm (sqrt (square 2)))) (down 'm (* 2 'm))))])
    (check-pred exn:fail:mechanics:singular:matrix?
                (failure-of (solve-linear-left A (* A (up 1 1)))))
    (check-equal? (rank A) 1)))

(test-case "a zero in disguise on the diagonal is no obstacle where the matrix has an inverse"
  (define A (matrix-by-rows (list disguised-zero 'a) (list 'b disguised-zero)))
  (check-equal? (simplify (solve-linear-left A (up 'p 'q))) (simplify (up (/ 'q 'b) (/ 'p 'a)))))

(test-case "the failure says which rows depend, what goes to zero, and whether there are solutions"
  (define A
    (matrix-by-rows '(a b c) '(d e f) (list (+ 'a (* 2 'd)) (+ 'b (* 2 'e)) (+ 'c (* 2 'f)))))
  (define (message b) (exn-message (failure-of (solve-linear-left A b))))
  (check-regexp-match #rx"^solve-linear-left: the matrix has no inverse\n  matrix: "
                      (message (up 1 1 1)))
  (check-regexp-match #rx"\n  rank: 2 of 3\n" (message (up 1 1 1)))
  (check-regexp-match #rx"\n  dependent: row 2 is row 0 plus 2 times row 1\n" (message (up 1 1 1)))
  (check-regexp-match #rx"\n  solutions: none, the right-hand side not depending in the same way$"
                      (message (up 1 1 1)))
  (check-regexp-match
   #rx"\n  solutions: infinitely many, the right-hand side depending in the same way$"
   (message (up 'p 'q (+ 'p (* 2 'q)))))
  (check-regexp-match #rx"row 0 is zero"
                      (exn-message (failure-of (m:invert (matrix-by-rows '(0 0) '(1 2))))))
  (check-regexp-match #rx"row 1 is [(]/ b a[)] times row 0"
                      (exn-message (failure-of (m:invert (matrix-by-rows '(a a) '(b b)))))))

(test-case "null vectors have the shape of the unknown, and are taken to zero"
  (define (nulls thunk)
    (exn:fail:mechanics:singular:matrix-null-vectors (failure-of (thunk))))
  (check-equal? (nulls (lambda () (solve-linear-left (matrix-by-rows '(1 2) '(2 4)) (up 1 1))))
                (list (up -2 1)))
  (check-equal? (nulls (lambda () (solve-linear-right (down 1 1) (matrix-by-rows '(1 2) '(2 4)))))
                (list (down -2 1)))
  (define mass-matrix (down (down 'm 'm) (down 'm 'm)))
  (check-equal? (nulls (lambda () (solve-linear-left mass-matrix (down 'p 'q))))
                (list (up -1 1)))
  (check-equal? (nulls (lambda () (solve-linear-left 0 'p))) '(1)))

(test-case "a system with too few or too many equations is called so"
  (check-exn
   #rx"^solve-linear-left: there are more unknowns than equations: the system is underdetermined"
   (lambda () (solve-linear-left (down (up 'a) (up 'b)) (up 'p))))
  (check-exn
   #rx"^solve-linear-left: there are more equations than unknowns: the system is overdetermined"
   (lambda () (solve-linear-left (down (up 'a 'b 'c) (up 'd 'e 'f)) (up 'p 'q 'r)))))

(test-case "flonums: singular within rounding, rank and null space to rounding"
  (define A (matrix-by-rows '(0.1 0.3) '(0.3 0.9)))
  (check-pred exn:fail:mechanics:singular:matrix? (failure-of (m:invert A)))
  (check-equal? (rank A) 1)
  (check-true (same? (* A (car (null-space A))) (up 0 0) 1e-15)))

(test-case "rank and null space of matrices that are not square"
  (check-equal? (rank (matrix-by-rows '(a b c))) 1)
  (check-equal? (length (null-space (matrix-by-rows '(a b c)))) 2)
  (check-equal? (null-space (matrix-by-rows '(a) '(b))) '())
  (check-equal? (rank (up (down 1 2 3) (down 2 4 6))) 1)
  (check-exn #rx"^rank: expected a matrix or a tuple of tuples\n  given: the procedure `sin`$"
             (lambda () (rank sin)))
  (check-exn
   #rx"^null-space: expected numbers or expressions as entries\n  given: [(]matrix-by-rows [(]list sin[)][)]"
   (lambda () (null-space (matrix-by-rows (list sin))))))
