#lang racket/base
;; Kernels beside sums of products over lists, of all orders, for one to seven terms; linear
;; systems put into their equations.

(require racket/flonum
         racket/list
         mechanics/numeric/Taylor/kernels
         mechanics/numeric/Taylor/recurrence-list
         "../../support/checks.rkt")

(define size 9)
(random-seed 4343)
(define (number) (- (* 4.0 (random)) 2.0))

;; Rows and their coefficients, flvectors
(define all '())
(define (row-with coefficients [degree +inf.0])
  (set! all (append all (list coefficients)))
  (row (- (length all) 1) degree))
(define (coefficients r) (list-ref all (row-index r)))
(define (at r k) (flvector-ref (coefficients r) k))
(define (start! r x) (flvector-set! (coefficients r) 0 x) r)

(define (random-row [degree +inf.0])
  (row-with (for/flvector #:length size ([k (in-range size)]) (if (<= k degree) (number) 0.0))
            degree))
(define (empty-row) (row-with (make-flvector size 0.0)))
(define (copy r) (row-with (flvector-copy (coefficients r)) (row-degree r)))

;; Σ a_j b_{k−j} for j from `first` on
(define (convolution a b k [first 0] [last k])
  (for/sum ([j (in-range first (+ last 1))]) (* (at a j) (at b (- k j)))))

(define (run recurrences #:from [first 1])
  (define rows (list->vector all))
  (define kernels (for/list ([r (in-list recurrences)]) (recurrence->kernel r rows)))
  (for* ([k (in-range first size)] [f (in-list kernels)]) (f k)))

;; coefficient : k -> what the row holds at k
(define-check (check-row r coefficient)
  (for ([k (in-range 1 size)])
    (define-values (found expected) (values (at r k) (coefficient k)))
    (unless (<= (abs (- found expected)) (* 1e-12 (+ 1.0 (abs expected))))
      (with-check-info (['k k] ['found found] ['expected expected]) (fail-check)))))

;; Adds to nothing, to a multiple of another row and to what is there.
;; things : what is summed;  make : r things base -> recurrences;  share : thing k -> what it adds
(define (check-sums things make share)
  (define other (random-row))
  (for* ([n (in-range 1 (+ 1 (length things)))] [which (in-list '(nothing other there))])
    (define r (random-row))
    (define before (copy r))
    (define-values (base start)
      (case which
        [(nothing) (values #f (lambda (k) 0.0))]
        [(other) (values (weighed 1.7 other) (lambda (k) (* 1.7 (at other k))))]
        [else (values (itself r) (lambda (k) (at before k)))]))
    (run (make r (take things n) base))
    (check-row r (lambda (k) (for/fold ([sum (start k)]) ([t (in-list (take things n))])
                               (+ sum (share t k)))))))

(test-case "sums of rows"
  (check-sums (for/list ([_ (in-range 7)]) (weighed (number) (random-row))) sum-recurrences
              (lambda (t k) (* (weighed-weight t) (at (weighed-row t) k)))))

(test-case "sums of squares"
  (check-sums (for/list ([_ (in-range 7)]) (weighed (number) (random-row))) square-recurrences
              (lambda (t k) (* (weighed-weight t)
                               (convolution (weighed-row t) (weighed-row t) k)))))

(define (product-share t k)
  (* (product-weight t) (convolution (product-a t) (product-b t) k)))

(define (random-product a b) (product (number) (random-row a) (random-row b)))

(test-case "sums of products, of rows that end too"
  (check-sums (for/list ([_ (in-range 7)]) (random-product +inf.0 +inf.0))
              product-recurrences product-share)
  (for ([degrees (in-list '((0 +inf.0) (+inf.0 2) (1 3) (4 1)))])
    (define ending (apply random-product degrees))
    (for ([others (in-list (list '() (list (random-product +inf.0 +inf.0))
                                 (list (random-product 2 +inf.0))))])
      (check-sums (cons ending others) product-recurrences product-share))))

(test-case "products that share a factor"
  (for ([n (in-range 1 8)])
    (define b (random-row))
    (define targets (for/list ([_ (in-range n)]) (target (empty-row) (random-row))))
    (run (shared-product-recurrences targets b))
    (for ([t (in-list targets)])
      (check-row (target-row t) (lambda (k) (convolution (target-a t) b k))))))

(test-case "derivatives and integrals"
  (define-values (r d back) (values (random-row) (empty-row) (empty-row)))
  (run (list (make-recurrence 'derivative d r) (make-recurrence 'integral back d)))
  (check-row d (lambda (k) (* k (at r k))))
  (check-row back (lambda (k) (at r k))))

;; The row of a derivative begins with 0.
(define (random-derivative degree) (start! (random-row degree) 0.0))
(define degrees '(1 2 3 +inf.0))

(test-case "two functions of which each has the other in its derivative"
  (for ([degree (in-list degrees)])
    (define d (random-derivative degree))
    (define-values (r p) (values (start! (empty-row) 0.6) (start! (empty-row) 0.8)))
    (run (list (pair-recurrence r 3.0 p -2.0 d)))
    (check-row r (lambda (k) (/ (* 3.0 (convolution d p k 1)) k)))
    (check-row p (lambda (k) (/ (* -2.0 (convolution d r k 1)) k)))))

(test-case "terms of a differential equation, and its leading factor"
  (for ([degree (in-list degrees)])
    (define d (random-derivative degree))
    (check-sums (list (weighed (number) (random-row)))
                (lambda (r terms base)
                  (define t (car terms))
                  (list (differential-recurrence r (weighed-weight t) d (weighed-row t) base)))
                (lambda (t k) (* (weighed-weight t) (convolution d (weighed-row t) k 1)))))
  (define-values (x l) (values (random-row) (start! (random-row) 1.3)))
  (define d (copy x))
  (run (list (make-recurrence 'differential-leading d l)))
  (check-row x (lambda (k) (convolution d l k 1))))

(test-case "quotients, reciprocals, roots and powers satisfy their equations"
  (define b (start! (random-row) 1.7))
  (for ([degree (in-list degrees)])
    (define-values (l x) (values (start! (random-row degree) 1.3) (random-row)))
    (define r (copy x))
    (run (list (leading-recurrence r l)))
    (check-row x (lambda (k) (convolution l r k))))
  (define inverse (start! (empty-row) (/ 1.0 1.7)))
  (run (list (make-recurrence 'reciprocal inverse b)))
  (check-row (empty-row) (lambda (k) (convolution b inverse k)))
  (define root (start! (empty-row) (sqrt 1.7)))
  (run (list (make-recurrence 'root root b)))
  (check-row b (lambda (k) (convolution root root k)))
  (define power (start! (empty-row) (expt 1.7 2.5)))
  (run (list (make-recurrence 'power power b 2.5)))
  (define-values (of-power of-b) (values (random-row) (random-row)))
  (run (list (make-recurrence 'derivative of-power power) (make-recurrence 'derivative of-b b)))
  (check-row (empty-row) (lambda (k) (- (convolution of-power b k 1)
                                        (* 2.5 (convolution of-b power k 1))))))

;; Entry 1 of A is a constant, the others vary.
(test-case "the solution of a linear system satisfies it at all orders"
  (define n 3)
  (define varying (build-vector (* n n) (lambda (i) (not (= i 1)))))
  (define A
    (for/vector ([varies? (in-vector varying)] [i (in-naturals)])
      (define r (random-row (if varies? +inf.0 0)))
      (if (= 0 (remainder i (+ n 1))) (start! r (+ 5.0 (random))) r)))
  (define b (build-vector n (lambda (_) (random-row))))
  (define x (build-vector n (lambda (_) (empty-row))))
  (run (list (make-recurrence 'system A varying b x)) #:from 0)
  (for* ([i (in-range n)] [k (in-range size)])
    (check-= (for/sum ([j (in-range n)])
               (convolution (vector-ref A (+ (* i n) j)) (vector-ref x j) k))
             (at (vector-ref b i) k) 1e-10)))
