#lang racket/base
;; Each order of the series of two Hamiltonians took six times as long as the one before: the
;; tenth half a minute, the twelfth a quarter of an hour.

(require racket/list
         mechanics
         "../support/checks.rkt")

;; Matrices as lists of rows, of polynomials as lists of coefficients up to s^order
(define order 12)
(define (trimmed p) (take (append p (make-list (+ order 1) 0)) (+ order 1)))
(define (poly+ p q) (map + p q))
(define (poly* p q)
  (trimmed (for/list ([n (+ order 1)])
             (for/sum ([i (+ n 1)]) (* (list-ref p i) (list-ref q (- n i)))))))
(define (mat+ A B) (map (lambda (r s) (map poly+ r s)) A B))
(define (mat* A B)
  (for/list ([r A])
    (for/list ([j 2])
      (poly+ (poly* (first r) (list-ref (first B) j)) (poly* (second r) (list-ref (second B) j))))))
(define (scaled c A) (map (lambda (r) (map (lambda (p) (map (lambda (x) (* c x)) p)) r)) A))
(define (matrix a b c d) (list (list (trimmed a) (trimmed b)) (list (trimmed c) (trimmed d))))
(define one (matrix '(1) '() '() '(1)))

;; Of A with no constant term
(define (exponential A)
  (for/fold ([sum one] [power one] #:result sum) ([k (in-range 1 (+ order 1))])
    (define next (scaled (/ 1 k) (mat* power A)))
    (values (mat+ sum next) next)))
(define (logarithm E)
  (define X (mat+ E (scaled -1 one)))
  (for/fold ([sum (scaled 0 one)] [power one] #:result sum) ([k (in-range 1 (+ order 1))])
    (define next (mat* power X))
    (values (mat+ sum (scaled (/ (expt -1 (+ k 1)) k) next)) next)))

;; On q and p the Lie derivative of p²/2 makes p of q, that of q²/2 makes −q of p.
(define Z-matrix
  (logarithm (mat* (exponential (matrix '() '() '(0 1) '()))
                   (exponential (matrix '() '(0 -1) '() '())))))

(define (T s) (/ (square (momentum s)) 2))
(define (V s) (/ (square (coordinate s)) 2))
(define Z (Baker-Campbell-Hausdorff T V))

(test-case "twelve orders are those of the logarithm of a product of matrices"
  (for ([n (in-range 1 (+ order 1))])
    (define (entry i j) (list-ref (list-ref (list-ref Z-matrix i) j) n))
    ;; of H = a q²/2 + b q p + c p²/2: q goes to b q + c p, p to −a q − b p
    (define-values (a b c) (values (- (entry 0 1)) (entry 0 0) (entry 1 0)))
    (check-equal? (simplify ((series:ref Z n) (up 't 'q 'p)))
                  (simplify (+ (* 1/2 a (square 'q)) (* b 'q 'p) (* 1/2 c (square 'p))))
                  (format "order ~a" n))))

(test-case "and so of literal functions and of several coordinates"
  (define f (literal-function 'f (Hamiltonian 2)))
  (define g (literal-function 'g (Hamiltonian 2)))
  (define s (up 't (up 'x 'y) (down 'a 'b)))
  (define (bracket u v) (Poisson-bracket u v))
  (define third (* 1/12 (+ (bracket (bracket g f) f) (bracket (bracket f g) g))))
  (check-equal? (verdict-status
                 (verify-equal ((series:ref (Baker-Campbell-Hausdorff f g) 3) s) (third s)))
                'proved))

;; The value of a function at symbols is kept, simplified under the relations declared at the time;
;; none is where the function chooses by a number.
(test-case "brackets follow what is declared of a constant"
  (define (spring s) (* 1/2 (sqrt (square 'k)) (square (coordinate s))))
  (define sum (Baker-Campbell-Hausdorff T spring))
  (define (third) (simplify ((series:ref sum 3) (up 't 'q 'p))))
  (define (third-of k) (simplify (* 1/12 k (+ (* k (square 'q)) (square 'p)))))
  (check-equal? (assuming ['(> k 0)] (third)) (third-of 'k))
  (check-equal? (assuming ['(< k 0)] (third)) (third-of (- 'k))))

(test-case "and the branch of the state where they are asked"
  (define (lame s) (if (< (coordinate s) 0) (V s) (* 4 (V s))))
  (define sum (Baker-Campbell-Hausdorff T lame))
  (define (third k q p) (/ (* k (+ (* k q q) (* p p))) 12))
  (check-= ((series:ref sum 3) (up 0 -3.0 2.0)) (third 1 -3.0 2.0) 1e-14)
  (check-= ((series:ref sum 3) (up 0 3.0 2.0)) (third 4 3.0 2.0) 1e-13))
