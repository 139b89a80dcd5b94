#lang racket/base
;; Dense univariate polynomials modulo a prime of any size.
;;
;; A polynomial is the vector of its residues by ascending degree, without zeros
;; at the end; the zero polynomial is #().  Every operation takes the prime last.
;; The primes are Mersenne's: there is one above any bound that matters, and
;; nothing to search for.

(require (only-in racket/vector vector-copy))

(provide
 prime-above
 dense dense-degree dense-one?
 dense- dense* dense-product dense-monic dense-derivative
 dense-divide dense-gcd dense-bezout dense-expt-modulo)

(define mersenne-exponents '(31 61 89 107 127 521 607 1279 2203))

;; The least of the primes above a bound, #f if there is none.
(define (prime-above bound)
  (for/first ([e (in-list mersenne-exponents)] #:when (> (- (expt 2 e) 1) bound))
    (- (expt 2 e) 1)))

(define (inverse a P)
  (let loop ([r P] [s (modulo a P)] [u 0] [v 1])
    (if (eqv? s 1)
        (modulo v P)
        (let ([q (quotient r s)])
          (loop s (- r (* q s)) v (- u (* q v)))))))

;; ---------------------------------------------------------------------------
;; Making and asking

;; A vector of integers reduced.
(define (dense v P) (dense-scale 1 v P))

(define (trim v)
  (let loop ([n (vector-length v)])
    (cond [(eqv? n 0) #()]
          [(eqv? 0 (vector-ref v (- n 1))) (loop (- n 1))]
          [(eqv? n (vector-length v)) v]
          [else (vector-copy v 0 n)])))

(define (dense-degree p) (- (vector-length p) 1))
(define (dense-leading p) (vector-ref p (dense-degree p)))
(define (dense-zero? p) (eqv? 0 (vector-length p)))
(define (dense-one? p) (equal? p #(1)))

;; ---------------------------------------------------------------------------
;; Arithmetic

(define (dense- p q P)
  (define (at v i) (if (< i (vector-length v)) (vector-ref v i) 0))
  (define n (max (vector-length p) (vector-length q)))
  (trim (for/vector #:length n ([i (in-range n)]) (modulo (- (at p i) (at q i)) P))))

(define (dense-scale c p P)
  (trim (for/vector #:length (vector-length p) ([a (in-vector p)]) (modulo (* c a) P))))

(define (dense* p q P)
  (cond [(or (dense-zero? p) (dense-zero? q)) #()]
        [else
         (define product (make-vector (+ (vector-length p) (dense-degree q)) 0))
         (for* ([i (in-range (vector-length p))] [j (in-range (vector-length q))])
           (vector-set! product (+ i j)
                        (+ (vector-ref product (+ i j)) (* (vector-ref p i) (vector-ref q j)))))
         (dense product P)]))

;; p times all of qs.
(define (dense-product p qs P)
  (for/fold ([product p]) ([q (in-list qs)]) (dense* product q P)))

(define (dense-monic p P) (dense-scale (inverse (dense-leading p) P) p P))

(define (dense-derivative p P)
  (if (dense-zero? p)
      p
      (trim (for/vector #:length (dense-degree p) ([a (in-vector p 1)] [i (in-naturals 1)])
              (modulo (* i a) P)))))

;; ---------------------------------------------------------------------------
;; Division

;; -> quotient and remainder
(define (dense-divide p q P)
  (define m (dense-degree q))
  (define k (- (dense-degree p) m))
  (cond [(< k 0) (values #() p)]
        [else
         (define unit (inverse (dense-leading q) P))
         (define rest (vector-copy p))
         (define quotient (make-vector (+ k 1) 0))
         (for ([i (in-range k -1 -1)])
           (define c (modulo (* unit (vector-ref rest (+ i m))) P))
           (vector-set! quotient i c)
           (unless (eqv? c 0)
             (for ([b (in-vector q)] [j (in-naturals i)])
               (vector-set! rest j (modulo (- (vector-ref rest j) (* c b)) P)))))
         (values (trim quotient) (trim rest))]))

(define (remainder-by p q P)
  (define-values (quotient rest) (dense-divide p q P))
  rest)

;; The monic gcd.
(define (dense-gcd p q P)
  (if (dense-zero? q)
      (if (dense-zero? p) p (dense-monic p P))
      (dense-gcd q (remainder-by p q P) P)))

;; -> u and v with u p + v q = 1, for coprime p and q
(define (dense-bezout p q P)
  (let loop ([a p] [b q] [u #(1)] [v #()] [s #()] [t #(1)])
    ;; a = u p + v q, b = s p + t q
    (cond [(dense-zero? b)
           (define unit (inverse (dense-leading a) P))
           (values (dense-scale unit u P) (dense-scale unit v P))]
          [else
           (define-values (k rest) (dense-divide a b P))
           (loop b rest s t
                 (dense- u (dense* k s P) P)
                 (dense- v (dense* k t P) P))])))

;; base^n modulo f
(define (dense-expt-modulo base n f P)
  (define (times p q) (remainder-by (dense* p q P) f P))
  (let loop ([n n])
    (cond [(eqv? n 0) #(1)]
          [(eqv? n 1) (remainder-by base f P)]
          [else
           (define root (loop (quotient n 2)))
           (define square (times root root))
           (if (odd? n) (times square base) square)])))
