#lang racket/base
;; Zeros of polynomials whose zeros are known, in (0, 1].

(require racket/flonum
         mechanics/numeric/Taylor/polynomial-zeros
         "../../support/checks.rkt")

;; The product of factors, each a list of coefficients.
(define (product-of factors)
  (for/fold ([p '(1.0)]) ([q factors])
    (for/list ([k (in-range (+ (length p) (length q) -1))])
      (for/sum ([c p] [i (in-naturals)])
        (define j (- k i))
        (if (< -1 j (length q)) (* c (list-ref q j)) 0.0)))))
(define (with-zeros . zs) (for/list ([z zs]) (list (- z) 1.0)))
(define (zeros-of factors [touch 1e-14])
  (polynomial-zeros (apply flvector (map real->double-flonum (product-of factors))) touch))

(define (check-zeros factors expected [tolerance 1e-12] [touch 1e-14])
  (define found (zeros-of factors touch))
  (check-equal? (map zero-kind found) (map cdr expected) (format "~a" expected))
  (for ([z found] [e expected]) (check-= (zero-at z) (car e) tolerance)))

(test-case "simple zeros, their directions, and none elsewhere"
  (check-zeros (with-zeros 0.5) '((0.5 . rising)))
  (check-zeros (with-zeros 0.25 0.75) '((0.25 . falling) (0.75 . rising)))
  (check-zeros (with-zeros 0.1 0.2 0.3 1.5 -0.3) '((0.1 . falling) (0.2 . rising) (0.3 . falling))
               1e-10)
  (check-zeros (with-zeros 1.5 -0.5) '())
  (check-zeros (list '(1.0 0.0 1.0) '(0.3 -1.0 1.0)) '()))

(test-case "zeros at the ends: one at 0 is none, one at 1 is one"
  (check-zeros (with-zeros 0.0 0.5) '((0.5 . rising)))
  (check-zeros (with-zeros 0.0 0.0 0.5) '((0.5 . rising)))
  (check-zeros (with-zeros 1.0) '((1.0 . rising)))
  (check-zeros (with-zeros 0.5 1.0) '((0.5 . falling) (1.0 . rising))))

(test-case "two zeros as close as they may be are two, one that is double is touched"
  (check-zeros (with-zeros 0.3 0.3001) '((0.3 . falling) (0.3001 . rising)) 1e-9)
  (check-zeros (with-zeros 0.3 0.300001) '((0.3 . falling) (0.300001 . rising)) 1e-8)
  (check-zeros (with-zeros 0.3 0.3000001) '((0.3 . touching)) 1e-6)
  (check-zeros (with-zeros 0.25 0.25) '((0.25 . touching)) 1e-7)
  (check-zeros (append (with-zeros 0.25 0.25) (with-zeros 0.5)) '((0.25 . touching) (0.5 . rising))
               1e-7)
  (check-zeros (list '(0.0626 -0.5 1.0)) '()))          ; misses 0 by 1e-4

(test-case "a zero in the middle of a half"
  (check-zeros (append (with-zeros 0.5 0.25 0.75) (list '(1.0)))
               '((0.25 . rising) (0.5 . falling) (0.75 . rising))))

(test-case "constants and nothing"
  (check-equal? (polynomial-zeros (flvector 1.0) 0.0) '())
  (check-equal? (polynomial-zeros (flvector 0.0 0.0 0.0) 0.0) '()))

(test-case "random zeros of polynomials of degree 10"
  (random-seed 11)
  (for ([_ (in-range 300)])
    (define inside (sort (for/list ([_ (in-range (random 5))]) (random)) <))
    (define outside (for/list ([_ (in-range (- 10 (length inside)))]) (+ 1.2 (* 3 (random)))))
    (define gaps (for/list ([a inside] [b (if (null? inside) '() (cdr inside))]) (- b a)))
    (when (and (andmap (lambda (g) (> g 0.02)) gaps) (andmap (lambda (x) (< 0.01 x 0.99)) inside))
      (define found (zeros-of (apply with-zeros (append inside outside))))
      (check-equal? (length found) (length inside))
      (for ([z found] [x inside]) (check-= (zero-at z) x 1e-6)))))

(test-case "terms beyond order 10 are not passed over"
  (define (long . cs) (append cs (for/list ([_ (in-range (- 11 (length cs)))]) 0.0)))
  (define (zero-of cs) (map zero-kind (polynomial-zeros (apply flvector cs) 0.0)))
  (check-equal? (zero-of (append (long 1.0) '(0.0 -0.999))) '())
  (check-equal? (zero-of (append (long 1.0) '(0.0 -1.001))) '(falling))
  (check-equal? (zero-of (append (long 1.0) '(0.0 -1.0))) '(falling))
  (check-equal? (zero-of (append (long -1.0 1.0) '(0.0 1e-9))) '(rising))
  (check-equal? (zero-of (append (long 1.0 -1.0) '(0.0 1e-9))) '()))

(test-case "the terms up to order 10 decide only where they say it"
  (random-seed 12)
  (for ([_ (in-range 2000)])
    (define p
      (for/flvector #:length 16 ([k (in-range 16)]) (* (- (random) 0.5) (expt 0.6 k))))
    (flvector-set! p 0 (* 0.3 (flvector-ref p 0)))
    (define changes
      (for/sum ([j (in-range 1000)])
        (define (p-at j) (polynomial-value p (/ (->fl j) 1000.0)))
        (if (< (* (p-at j) (p-at (+ j 1))) 0.0) 1 0)))
    (check <= changes (length (polynomial-zeros p 0.0)))))
