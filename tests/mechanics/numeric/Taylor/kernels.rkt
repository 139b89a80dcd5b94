#lang racket/base
;; Kernels beside sums of products over lists, of all orders, for one to seven terms; linear
;; systems put into their equations.

(require racket/flonum
         racket/list
         mechanics/numeric/Taylor/kernels
         mechanics/numeric/Taylor/linear-system
         "../../support/checks.rkt")

(define size 9)
(random-seed 4343)
(define (number) (- (* 4.0 (random)) 2.0))
(define (random-row) (for/flvector #:length size ([_ (in-range size)]) (number)))
(define (row-of-degree n)
  (for/flvector #:length size ([k (in-range size)]) (if (<= k n) (number) 0.0)))
(define (empty-row) (make-flvector size 0.0))

;; Σ a_j b_{k−j} for j from `first` on
(define (convolution a b k [first 0] [last k])
  (for/sum ([j (in-range first (+ last 1))]) (* (flvector-ref a j) (flvector-ref b (- k j)))))

(define (run kernels) (for* ([k (in-range 1 size)] [f (in-list kernels)]) (f k)))

;; coefficient : k -> what the row holds at k
(define-check (check-row r coefficient)
  (for ([k (in-range 1 size)])
    (define-values (found expected) (values (flvector-ref r k) (coefficient k)))
    (unless (<= (abs (- found expected)) (* 1e-12 (+ 1.0 (abs expected))))
      (with-check-info (['k k] ['found found] ['expected expected]) (fail-check)))))

;; Adds to nothing, to a multiple of another row and to what is there.
;; things : what is summed;  make : r things base -> kernels;  share : thing k -> what it adds
(define (check-sums things make share)
  (define other (random-row))
  (for* ([n (in-range 1 (+ 1 (length things)))] [which (in-list '(nothing other there))])
    (define r (random-row))
    (define before (flvector-copy r))
    (define-values (base start)
      (case which
        [(nothing) (values #f (lambda (k) 0.0))]
        [(other) (values (weighed 1.7 other) (lambda (k) (* 1.7 (flvector-ref other k))))]
        [else (values (itself r) (lambda (k) (flvector-ref before k)))]))
    (run (make r (take things n) base))
    (check-row r (lambda (k) (for/fold ([sum (start k)]) ([t (in-list (take things n))])
                               (+ sum (share t k)))))))

(test-case "sums of rows"
  (check-sums (for/list ([_ (in-range 7)]) (weighed (number) (random-row))) sum-kernels
              (lambda (t k) (* (weighed-weight t) (flvector-ref (weighed-row t) k)))))

(test-case "sums of squares"
  (check-sums (for/list ([_ (in-range 7)]) (weighed (number) (random-row))) square-kernels
              (lambda (t k) (* (weighed-weight t)
                               (convolution (weighed-row t) (weighed-row t) k)))))

(define (product-share t k)
  (* (product-weight t) (convolution (product-a t) (product-b t) k)))

(define (random-product a b)
  (define (row degree) (if (= degree +inf.0) (random-row) (row-of-degree degree)))
  (product (number) (row a) a (row b) b))

(test-case "sums of products, of rows that end too"
  (check-sums (for/list ([_ (in-range 7)]) (random-product +inf.0 +inf.0))
              product-kernels product-share)
  (for ([degrees (in-list '((0 +inf.0) (+inf.0 2) (1 3) (4 1)))])
    (define ending (apply random-product degrees))
    (for ([others (in-list (list '() (list (random-product +inf.0 +inf.0))
                                 (list (random-product 2 +inf.0))))])
      (check-sums (cons ending others) product-kernels product-share))))

(test-case "products that share a factor"
  (for ([n (in-range 1 8)])
    (define b (random-row))
    (define targets (for/list ([_ (in-range n)]) (target (empty-row) (random-row))))
    (run (shared-product-kernels targets b))
    (for ([t (in-list targets)])
      (check-row (target-row t) (lambda (k) (convolution (target-a t) b k))))))

(test-case "derivatives and integrals"
  (define-values (r d back) (values (random-row) (empty-row) (empty-row)))
  (run (list (derivative-kernel d r) (integral-kernel back d)))
  (check-row d (lambda (k) (* k (flvector-ref r k))))
  (check-row back (lambda (k) (flvector-ref r k))))

(test-case "two functions of which each has the other in its derivative"
  (for ([degree (in-list '(1 2 +inf.0))])
    (define d (if (= degree +inf.0) (random-row) (row-of-degree degree)))
    (flvector-set! d 0 0.0)
    (define-values (r p) (values (empty-row) (empty-row)))
    (flvector-set! r 0 0.6)
    (flvector-set! p 0 0.8)
    (run (list (pair-kernel r 3.0 p -2.0 d degree)))
    (check-row r (lambda (k) (/ (* 3.0 (convolution d p k 1)) k)))
    (check-row p (lambda (k) (/ (* -2.0 (convolution d r k 1)) k)))))

(test-case "terms of a differential equation, and its leading factor"
  (for ([degree (in-list '(1 3 +inf.0))])
    (define d (if (= degree +inf.0) (random-row) (row-of-degree degree)))
    (check-sums (list (weighed (number) (random-row)))
                (lambda (r terms base)
                  (define t (car terms))
                  (list (differential-kernel r (weighed-weight t) d degree (weighed-row t) base)))
                (lambda (t k) (* (weighed-weight t) (convolution d (weighed-row t) k 1)))))
  (define-values (x l) (values (random-row) (random-row)))
  (define d (flvector-copy x))
  (flvector-set! l 0 1.3)
  (run (list (differential-leading-kernel d l)))
  (check-row x (lambda (k) (convolution d l k 1))))

(test-case "quotients, reciprocals, roots and powers satisfy their equations"
  (define (start r x) (flvector-set! r 0 x) r)
  (define b (start (random-row) 1.7))
  (for ([degree (in-list '(1 3 +inf.0))])
    (define l (start (if (= degree +inf.0) (random-row) (row-of-degree degree)) 1.3))
    (define x (random-row))
    (define r (flvector-copy x))
    (run (list (leading-kernel r l degree)))
    (check-row x (lambda (k) (convolution l r k))))
  (define inverse (start (empty-row) (/ 1.0 1.7)))
  (run (list (reciprocal-kernel inverse b)))
  (check-row (empty-row) (lambda (k) (convolution b inverse k)))
  (define root (start (empty-row) (sqrt 1.7)))
  (run (list (root-kernel root b)))
  (check-row b (lambda (k) (convolution root root k)))
  (define power (start (empty-row) (expt 1.7 2.5)))
  (run (list (power-kernel power b 2.5)))
  (define-values (of-power of-b) (values (random-row) (random-row)))
  (run (list (derivative-kernel of-power power) (derivative-kernel of-b b)))
  (check-row (empty-row) (lambda (k) (- (convolution of-power b k 1)
                                        (* 2.5 (convolution of-b power k 1))))))

;; Entry 1 of A is a constant, the others vary.
(test-case "the solution of a linear system satisfies it at all orders"
  (define n 3)
  (define (varying? i) (not (= i 1)))
  (define A (for/vector ([i (in-range (* n n))])
              (define row (if (varying? i) (random-row) (row-of-degree 0)))
              (when (= 0 (remainder i (+ n 1))) (flvector-set! row 0 (+ 5.0 (random))))
              row))
  (define b (build-vector n (lambda (_) (random-row))))
  (define x (build-vector n (lambda (_) (empty-row))))
  (define-values (start! step!) (system-kernels A varying? b x))
  (start!)
  (run (list step!))
  (for* ([i (in-range n)] [k (in-range size)])
    (check-= (for/sum ([j (in-range n)])
               (convolution (vector-ref A (+ (* i n) j)) (vector-ref x j) k))
             (flvector-ref (vector-ref b i) k) 1e-10)))
